"""Blur of an extended source in the design: even, changing, and the first design for it."""

import math

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.design.fitted_blur import lens_blur_of
from workbench.design.lens_blur import BlurChange, LensBlur, LightBlurring, plan_of
from workbench.design.transport import first_design, transport_start
from workbench.extended.blur import Blur
from workbench.extended.bound import Bound
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.scene import Scene

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
        validate(scene, target, FaceArrays(heights), 60_000).relative_l2_corrected
        for heights in (
            {"lens.back": transport_start(scene, target)},
            first_design(scene, target).heights,
        )
    )
    assert bound < aimed < 0.8 * sharp


SHAPE, PARTS = (7, 9), 2


@pytest.fixture
def kernels(rng):
    """A mean and two changes."""
    return rng.standard_normal((3, PARTS**2, 5, 3))


@pytest.fixture
def factors(rng):
    return rng.standard_normal((2, *SHAPE))


@pytest.fixture
def blurring(kernels, factors):
    return LightBlurring(torch.as_tensor(kernels), torch.as_tensor(factors))


def test_light_of_each_part_is_spread_by_the_kernels_of_its_part(blurring, kernels, factors):
    light = torch.zeros(PARTS * SHAPE[0], PARTS * SHAPE[1], dtype=torch.float64)
    row, column = 4, 6
    light[PARTS * row + 1, PARTS * column] = 2.0  # below, left of the middle
    image = blurring.image(light).numpy()
    kernel = kernels[0, PARTS]
    for factor, change in zip(factors, kernels[1:], strict=True):
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
    "screen.half_width": [2.0, 1.6],
    "screen.pixels": [50, 40],
}


@pytest.fixture
def sun(make_scene):
    return make_scene(SUN)


def lens_of(scene, power, noise=0.0, rng=None):
    """A bowl or a dome: places bend light by more the farther they are from the axis."""
    x, y = ControlNet.of(scene.optic).positions
    bowl = scene.optic.base.height + power * (x[:, None] ** 2 + y**2)
    return {
        "lens.back": torch.as_tensor(bowl if rng is None else bowl + noise * rng.random(bowl.shape))
    }


def test_widths_change_as_rays_of_the_source_say(sun):
    """Light that comes in at two angles to a place of a bowl, by Snell's law."""
    heights, net, n = lens_of(sun, 0.1), ControlNet.of(sun.optic), sun.optic.index

    def hit(x, angle):
        z, slope, _ = (each.item() for each in net.at(x, np.zeros(1), heights["lens.back"].numpy()))
        lean = math.atan(slope)
        leaves = math.asin(n * math.sin(math.asin(math.sin(angle) / n) + lean)) - lean
        return x.item() + (sun.receiver.z - z) * math.tan(leaves)

    def width(x):
        half = math.radians(1.5)
        return hit(x, half) - hit(x, -half)

    change = lens_blur_of(sun, heights).image_blur.factors_at((50, 40), (0, 0))
    rim = np.array([0.9])
    column = round(25 * (1 + hit(rim, 0.0) / 2.0) - 0.5)
    found = (1 + change[0, 20, column]) / (1 + change[0, 20, 25])
    assert found == pytest.approx(width(rim) / width(np.zeros(1)), abs=1e-3)
    assert abs(found - 1) > 0.008


def folded(scene, half_width):
    """The scene behind a fold mirror: light along +z goes on along +y."""
    data = scene.to_data()
    (lens,), (image,) = data["elements"], data["images"]
    fold = {"kind": "mirror", "name": "fold", "half_width": half_width, "tilt": [45, 0, 0]}
    fold |= {"face": {"shape": "plane"}, "position": [0, 0, 0]}
    lens = lens | {"tilt": [-90, 0, 0], "position": [0, 3, 0]}
    screen = image["receiver"] | {"tilt": [-90, 0, 0], "position": [0, 8, 0]}
    behind = {"elements": [fold, lens], "images": [image | {"receiver": screen}]}
    return Scene.from_data(data | behind)


def test_a_fold_mirror_does_not_change_how_the_blur_changes(sun):
    heights = lens_of(sun, 0.1)
    plain, behind = (BlurChange.of(each, heights) for each in (sun, folded(sun, [3, 3])))
    np.testing.assert_allclose(behind.factors, plain.factors, atol=1e-6)


def test_image_with_a_changing_blur_is_nearer_to_that_of_many_origins(sun, rng):
    heights = lens_of(sun, -0.12, 0.004, rng)
    found, margin = lens_blur_of(sun, heights), (4, 4)
    assert found is not None
    all_of_it = BeamPlan(sun, Corners(96, 96, 512)).trace(heights, margin).flux
    off = [
        (plan_of(sun, (256, 256), blur=blur).trace(heights, margin).flux - all_of_it).norm()
        for blur in (found, LensBlur(found.mean))
    ]
    assert off[0] < 0.5 * off[1]


@pytest.fixture
def heights(sun, rng):
    """A lens that is not mirrored and sends some light beside the screen."""
    shape = ControlNet.of(sun.optic).shape
    return {"lens.back": torch.as_tensor(sun.optic.base.height + 0.01 * rng.random(shape))}


def blurred(scene, cells=(256, 256), rays=False):
    blur = LensBlur(Blur.of(scene, scene.optic.base.height))
    return plan_of(scene, cells, blur=blur, rays=rays)


def test_blurred_image_is_the_image_of_many_origins(sun, heights):
    middle = blurred(sun).trace(heights, (3, 4))
    all_of_it = BeamPlan(sun, Corners(64, 64, 256)).trace(heights, (3, 4))
    assert (middle.flux - all_of_it.flux).norm() < 0.01 * all_of_it.flux.norm()
    # Some light of the others leaves the lens by its sides.
    assert middle.account.on_screen == pytest.approx(all_of_it.account.on_screen, abs=5e-3)


def test_account_of_a_blurred_image_adds_up_and_counts_its_light(make_scene, heights):
    sun = make_scene(SUN | {"screen.half_width": [1.2, 1.2], "screen.pixels": [40, 32]})
    light = blurred(sun).trace(heights)
    account = light.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert light.flux.sum().item() == pytest.approx(account.on_screen, rel=1e-5)
    assert account.lost["off_screen"] > 1e-4


def test_rays_make_the_blurred_image_of_beams_and_its_account(sun, heights):
    beams, rays = (blurred(sun, rays=each).trace(heights, (3, 4)) for each in (False, True))
    assert (rays.flux - beams.flux).norm() < 0.005 * beams.flux.norm()
    assert rays.account.on_screen == pytest.approx(beams.account.on_screen, abs=1e-3)
    account = rays.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-6)


@pytest.mark.parametrize("rays", [False, True])
@pytest.mark.parametrize("changing", [False, True])
def test_gradient_of_a_blurred_image_is_that_of_central_differences(sun, rng, changing, rays):
    heights = lens_of(sun, 0.1, 0.004, rng)
    blur = lens_blur_of(sun, heights)
    plan = plan_of(sun, (64, 64), blur=blur if changing else LensBlur(blur.mean), rays=rays)
    way, weight = (torch.as_tensor(rng.random(shape) - 0.5) for shape in ((12, 12), (40, 50)))

    def value(heights):
        return (plan.trace({"lens.back": heights}).flux.double() * weight).sum()

    free = heights["lens.back"].clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(free), [free])
    step = 1e-4
    with torch.no_grad():
        ahead, back = (value(heights["lens.back"] + s * step * way) for s in (1, -1))
    slope = ((ahead - back) / (2 * step)).item()
    assert (gradient * way).sum().item() == pytest.approx(slope, rel=0.01)


def test_light_of_parts_of_the_source_sees_the_shade_of_a_mirror_before_the_lens(sun):
    """The shade moves with the direction: light at its border is blurred more than elsewhere."""
    shaded, heights, margin = folded(sun, [0.7, 1]), lens_of(sun, -0.12), (4, 4)
    blur = LensBlur(Blur.of(shaded, sun.optic.base.height))
    all_of_it = BeamPlan(shaded, Corners(96, 96, 256)).trace(heights, margin).flux
    of_middle, of_parts = (
        (plan_of(shaded, cells, blur=blur).trace(heights, margin).flux - all_of_it).norm()
        for cells in (Corners(256, 256), Corners(256, 256, 4))
    )
    assert of_middle > 0.02 * all_of_it.norm()
    assert of_parts < 0.5 * of_middle
