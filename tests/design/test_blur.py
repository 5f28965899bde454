"""Blur of an extended source in the design: even, changing, and the first lens for it."""

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.design.aim import first_lens
from workbench.design.blurred_light import LightBlurring
from workbench.design.blurred_plan import BlurredPlan
from workbench.design.lens_blur import LensBlur
from workbench.design.transport import transport_start
from workbench.extended.blur import Blur
from workbench.extended.bound import Bound
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners

GRID = {"kind": "grid", "center": [0, 0, -8], "half_width": [0.25, 0.25], "points": [6, 6]}


@pytest.fixture
def scene(make_scene):
    return make_scene({"source": GRID, "lens.control_points": [48, 48], "filter": {"kind": "box"}})


@pytest.fixture
def target(scene):
    (n_x, n_y), image = scene.receiver.pixels, np.zeros(scene.receiver.pixels[::-1])
    image[n_y // 4 : -n_y // 4, n_x // 4 : -n_x // 4] = 1
    image[n_y // 4 : -n_y // 4, n_x // 2 :] *= 0.4
    return image


def test_first_lens_with_an_extended_source_is_nearer_than_that_for_the_target_itself(
    scene, target
):
    bound = Bound(scene, target).relative_l2
    sharp, aimed = (
        validate(scene, target, FaceArrays(heights), 400_000).relative_l2_corrected
        for heights in (
            {"lens.back": transport_start(scene, target)},
            first_lens(scene, target).heights,
        )
    )
    assert bound < aimed < 0.8 * sharp


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


SUN = {
    "lens.half_width": [1.0, 1.0],
    "lens.control_points": [12, 12],
    "source": {"kind": "collimated", "angular_diameter": 3.0},
    "screen.z": 5.0,
    "screen.half_width": [1.2, 1.2],
    "screen.pixels": [40, 32],
}


@pytest.fixture
def sun(make_scene):
    return make_scene(SUN)


@pytest.fixture
def heights(sun, rng):
    """A lens that is not mirrored and sends some light beside the screen."""
    shape = ControlNet.of(sun.optic).shape
    return {"lens.back": torch.as_tensor(sun.optic.base.height + 0.01 * rng.random(shape))}


def blurred(scene, cells=(256, 256)):
    return BlurredPlan(scene, cells, LensBlur(Blur.of(scene, scene.optic.base.height)))


def test_blurred_image_is_the_image_of_many_origins(sun, heights):
    middle = blurred(sun).trace(heights, (3, 4))
    all_of_it = BeamPlan(sun, Corners(64, 64, 256)).trace(heights, (3, 4))
    assert (middle.flux - all_of_it.flux).norm() < 0.01 * all_of_it.flux.norm()
    # Some light of the others leaves the lens by its sides.
    assert middle.account.on_screen == pytest.approx(all_of_it.account.on_screen, abs=5e-3)


def test_account_of_a_blurred_image_adds_up_and_counts_its_light(sun, heights):
    light = blurred(sun).trace(heights)
    account = light.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert light.flux.sum().item() == pytest.approx(account.on_screen, rel=1e-5)
    assert account.lost["off_screen"] > 1e-4


def test_gradient_of_a_blurred_image_is_that_of_central_differences(sun, heights, rng):
    plan, way = blurred(sun, (64, 64)), torch.as_tensor(rng.random((12, 12)) - 0.5)
    weight = torch.as_tensor(rng.random((32, 40)))

    def value(heights):
        return (plan.trace({"lens.back": heights}).flux.double() * weight).sum()

    free = heights["lens.back"].clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(free), [free])
    step = 1e-4
    with torch.no_grad():
        ahead, back = (value(heights["lens.back"] + s * step * way) for s in (1, -1))
    slope = ((ahead - back) / (2 * step)).item()
    assert (gradient * way).sum().item() == pytest.approx(slope, rel=0.01)
