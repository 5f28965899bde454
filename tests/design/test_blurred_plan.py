"""Light of the middle of a source, blurred, stands for that of all of it."""

import pytest
import torch

from workbench.design.blurred_plan import BlurredPlan
from workbench.design.lens_blur import LensBlur
from workbench.extended.blur import Blur
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners

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
    return {"exit": torch.as_tensor(sun.optic.base.height + 0.01 * rng.random(shape))}


def blurred(scene, cells=(256, 256)):
    return BlurredPlan(scene, cells, LensBlur(Blur.of(scene, scene.optic.base.height)))


def test_blurred_image_is_the_image_of_many_origins(sun, heights):
    middle = blurred(sun).trace(heights, (3, 4))
    all_of_it = BeamPlan(sun, Corners(64, 64, 256)).trace(heights, (3, 4))
    assert (middle.flux - all_of_it.flux).norm() < 0.01 * all_of_it.flux.norm()
    # Some light of the others leaves the lens by its sides.
    assert middle.account.on_screen == pytest.approx(all_of_it.account.on_screen, abs=5e-3)


def test_asymmetric_light_stays_where_it_is(sun):
    """A wedge moves the light by one pixel along rows and by three across them."""
    x, y = ControlNet.of(sun.optic).positions
    wedge = sun.optic.base.height + 0.03 * x[:, None] + 0.09 * y[None, :]
    heights = {"exit": torch.as_tensor(wedge)}
    plans = blurred(sun), BeamPlan(sun, Corners(64, 64, 256))
    middles = []
    for plan in plans:
        flux = plan.trace(heights, (20, 20)).flux.double()
        rows, columns = (torch.arange(n, dtype=torch.float64) for n in flux.shape)
        middles.append(
            ((flux.sum(1) @ rows / flux.sum()).item(), (flux.sum(0) @ columns / flux.sum()).item())
        )
    assert middles[0] == pytest.approx(middles[1], abs=0.02)
    assert abs(middles[0][0] - 35.5) > 2.5 and abs(middles[0][1] - 39.5) > 1


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
        return (plan.trace({"exit": heights}).flux.double() * weight).sum()

    free = heights["exit"].clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(free), [free])
    step = 1e-4
    with torch.no_grad():
        ahead, back = (value(heights["exit"] + s * step * way) for s in (1, -1))
    slope = ((ahead - back) / (2 * step)).item()
    assert (gradient * way).sum().item() == pytest.approx(slope, rel=0.01)
