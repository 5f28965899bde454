"""What has to hold of the gradients of every trace."""

import pytest
import torch


def check_against_differences(loss, heights, directions):
    """The gradient of a loss is that of extrapolated central differences."""
    (gradient,) = torch.autograd.grad(loss(heights), heights)
    for direction in directions:
        with torch.no_grad():
            central = []
            for step in (2e-5, 1e-5):
                ahead, behind = loss(heights + step * direction), loss(heights - step * direction)
                central.append((ahead - behind).item() / (2 * step))
        extrapolated = (4 * central[1] - central[0]) / 3
        assert (gradient * direction).sum().item() == pytest.approx(extrapolated, rel=1e-6)
