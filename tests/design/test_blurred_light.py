"""Light in parts of pixels, blurred by Fourier transforms, and its adjoint."""

import numpy as np
import pytest
import torch

from workbench.design.blurred_light import LightBlurring

SHAPE, PARTS = (7, 9), 2


@pytest.fixture
def kernels(rng):
    return rng.standard_normal((PARTS**2, 5, 3))


@pytest.fixture
def changes(rng):
    return rng.standard_normal((2, PARTS**2, 5, 3))


@pytest.fixture
def factors(rng):
    return rng.standard_normal((2, *SHAPE))


@pytest.fixture
def blurring(kernels, changes, factors):
    return LightBlurring(*map(torch.as_tensor, (kernels, changes, factors)))


def test_light_of_each_part_is_spread_by_the_kernels_of_its_part(
    blurring, kernels, changes, factors
):
    light = torch.zeros(PARTS * SHAPE[0], PARTS * SHAPE[1], dtype=torch.float64)
    row, column = 4, 6
    light[PARTS * row + 1, PARTS * column] = 2.0  # below, left of the middle
    image = blurring.image(light).numpy()
    kernel = kernels[PARTS]
    for factor, change in zip(factors, changes, strict=True):
        kernel = kernel + factor[row, column] * change[PARTS]
    wanted = np.zeros(SHAPE)
    wanted[row - 2 : row + 3, column - 1 : column + 2] = 2 * kernel
    np.testing.assert_allclose(image, wanted, atol=1e-12)


def test_gradient_is_that_of_finite_differences(blurring, rng):
    shape = PARTS * SHAPE[0], PARTS * SHAPE[1]
    light = torch.as_tensor(rng.random(shape)).requires_grad_()
    assert torch.autograd.gradcheck(blurring.image, (light,))
