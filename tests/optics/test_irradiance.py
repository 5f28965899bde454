"""Image reconstruction: light is conserved, the right pixel lights up, nothing is NaN."""

import math

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from tests.optics.landing import image_at
from workbench.scene import BoxFilter, GaussianFilter, Screen

SCREEN = Screen(
    position=(0.0, 0.0, 5.0), half_width=(3.0, 2.0), pixels=(12, 8)
)  # pixels of 0.5 x 0.5
FILTERS = [
    BoxFilter(),
    GaussianFilter(size=(1, 1)),
    GaussianFilter(size=(3, 3)),
    GaussianFilter(size=(11, 5), alpha=0.2),
    GaussianFilter(size=(3, 7), alpha=1e6),
    GaussianFilter(size=(3, 3), alpha=1e-6),
]


def points(*xy):
    x, y = torch.tensor(xy, dtype=torch.float64).T
    return x, y, torch.ones_like(x)


@pytest.mark.parametrize("filter", FILTERS, ids=str)
@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_every_rays_weight_is_conserved(filter, dtype, rng):
    x = torch.as_tensor(rng.normal(0, 3, 4000), dtype=dtype)
    y = torch.as_tensor(rng.normal(0, 3, 4000), dtype=dtype)
    weight = torch.as_tensor(rng.random(4000), dtype=dtype)
    image = image_at(x, y, weight, SCREEN, filter)
    # The same pixels in the middle of so many that all light falls on some.
    wide = Screen(position=(0.0, 0.0, 5.0), half_width=(33.0, 22.0), pixels=(132, 88))
    flux = image_at(x, y, weight, wide, filter)
    assert image.shape == (8, 12)
    assert (flux >= 0).all()
    slack = 1e-5 if dtype == torch.float32 else 1e-12
    assert flux.sum().item() == pytest.approx(weight.sum().item(), rel=slack)
    assert image.numpy() == pytest.approx(flux[40:48, 60:72].numpy(), abs=1000 * slack)


@pytest.mark.parametrize("filter", FILTERS, ids=str)
def test_the_upper_left_pixel_is_at_minus_x_plus_y(filter):
    x, y, weight = points((-2.75, 1.75))
    flux = image_at(x, y, weight, SCREEN, filter)
    assert flux.argmax() == 0
    x, y, weight = points((2.75, 1.75))
    assert image_at(x, y, weight, SCREEN, filter).argmax() == 11


def test_a_ray_in_the_centre_of_its_pixel_is_spread_by_the_formula():
    filter = GaussianFilter(size=(3, 3), alpha=1.0)
    flux = image_at(*points((0.25, 0.25)), SCREEN, filter).numpy()
    tap = np.array([math.exp(-d * d) - math.exp(-2.25) for d in (-1, 0, 1)])
    tap /= tap.sum()
    assert flux[2:5, 5:8] == pytest.approx(np.outer(tap, tap), abs=1e-15)
    assert flux.sum() == pytest.approx(1)


@given(
    x=st.floats(-3.4, 3.4),
    y=st.floats(-2.4, 2.4),
    alpha=st.floats(1e-3, 10),
    size=st.sampled_from([3, 5, 9]),
)
def test_gradient_is_that_of_central_differences(x, y, alpha, size):
    column = (x + 3) * 2
    row = (2 - y) * 2
    # The derivative jumps where a hit goes from one pixel to the next.
    if min(abs(column - round(column)), abs(row - round(row))) < 1e-4:
        return
    filter = GaussianFilter(size=(size, size), alpha=alpha)
    cotangent = torch.as_tensor(np.random.default_rng(3).normal(size=(8, 12)))

    def brightness(x, y):
        one = torch.ones(1, dtype=torch.float64)
        return (image_at(x, y, one, SCREEN, filter) * cotangent).sum()

    at = [torch.tensor([c], dtype=torch.float64, requires_grad=True) for c in (x, y)]
    assert torch.autograd.gradcheck(brightness, at, eps=1e-6, atol=1e-6)
