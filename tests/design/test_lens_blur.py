"""The blur of the sun differs over the image of a lens."""

import math

import numpy as np
import pytest
import torch

from workbench.design.blurred_plan import BlurredPlan
from workbench.design.lens_blur import BlurChange, LensBlur
from workbench.design.levels import lens_blur_of
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners

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

    change = BlurChange.of(sun, heights).at((50, 40), (0, 0))
    rim = np.array([0.9])
    column = round(25 * (1 + hit(rim, 0.0) / 2.0) - 0.5)
    found = (1 + change[0, 20, column]) / (1 + change[0, 20, 25])
    assert found == pytest.approx(width(rim) / width(np.zeros(1)), abs=1e-3)
    assert abs(found - 1) > 0.008


def test_image_with_a_changing_blur_is_nearer_to_that_of_many_origins(sun, rng):
    heights = lens_of(sun, -0.12, 0.004, rng)
    found, margin = lens_blur_of(sun, heights), (4, 4)
    assert found is not None
    all_of_it = BeamPlan(sun, Corners(96, 96, 512)).trace(heights, margin).flux
    off = [
        (BlurredPlan(sun, (256, 256), blur).trace(heights, margin).flux - all_of_it).norm()
        for blur in (found, LensBlur(found.mean))
    ]
    assert off[0] < 0.5 * off[1]


def test_gradient_of_a_changing_blur_is_that_of_central_differences(sun, rng):
    heights = lens_of(sun, 0.1, 0.004, rng)["lens.back"]
    plan = BlurredPlan(sun, (64, 64), lens_blur_of(sun, {"lens.back": heights}))
    way, weight = (torch.as_tensor(rng.random(shape) - 0.5) for shape in ((12, 12), (40, 50)))

    def value(heights):
        return (plan.trace({"lens.back": heights}).flux.double() * weight).sum()

    free = heights.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(free), [free])
    step = 1e-4
    with torch.no_grad():
        ahead, back = (value(heights + s * step * way) for s in (1, -1))
    slope = ((ahead - back) / (2 * step)).item()
    assert (gradient * way).sum().item() == pytest.approx(slope, rel=0.01)
