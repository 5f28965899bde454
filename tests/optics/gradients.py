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


def check_both_modes(plan, heights, rng):
    """Forward mode agrees with reverse mode."""
    tangent = torch.as_tensor(rng.normal(size=heights.shape))
    cotangent = torch.as_tensor(rng.normal(size=(32, 32)))
    _, forward = torch.func.jvp(plan.flux, ({"exit": heights},), ({"exit": tangent},))
    variable = heights.requires_grad_()
    (reverse,) = torch.autograd.grad(
        (plan.trace({"exit": variable}).flux * cotangent).sum(), variable
    )
    assert (forward * cotangent).sum().item() == pytest.approx((reverse * tangent).sum().item())
