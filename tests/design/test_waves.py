"""Changes of a net as cosine waves."""

import numpy as np
import pytest
import torch

from workbench.design.waves import Waves


@pytest.fixture
def like():
    return torch.zeros(9, 6, dtype=torch.float64)


def change(waves, number):
    amplitudes = waves.nothing.clone()
    amplitudes[number] = 1
    return waves.change(amplitudes)


def test_waves_are_perpendicular_and_long_ones_are_large(like):
    waves = Waves(like, 1.25, (False, False))
    all_waves = torch.stack([change(waves, k).flatten() for k in range(54)])
    products = all_waves @ all_waves.T
    sizes = products.diagonal().sqrt()
    assert torch.allclose(products, torch.diag(products.diagonal()), atol=1e-14)
    assert sizes[0] == pytest.approx(1.0)
    assert sizes[1] == pytest.approx((1 + 0.5**2) ** -0.625)  # half a period along v
    assert (torch.diff(sizes[:6]) < 0).all()


@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_only_even_waves_are_left_of_a_mirrored_net(like, mirrored, rng):
    waves = Waves(like, 1.25, mirrored)
    made = waves.change(torch.as_tensor(rng.normal(size=waves.nothing.numel())))
    for axis, even in enumerate(mirrored):
        assert torch.allclose(made, made.flip(axis), atol=1e-12) == even
    half = [(n + 1) // 2 if even else n for n, even in zip(like.shape, mirrored, strict=True)]
    assert waves.nothing.numel() == np.prod(half)
