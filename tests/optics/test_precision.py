"""When float32 is enough, and what is done when it is not."""

import math

import numpy as np
import pytest
import torch

from workbench.optics.plan import Plan
from workbench.optics.precision import precision_of, shift_of

POINT = {"kind": "point", "position": [0, 0, -5.0], "rays": 20_000}
FAR = {"screen.z": 2e5, "screen.pixels": [64, 64], "lens.height_range": [-0.02, 0.02]}


def images(scene):
    """The image in float32, float64, and in the float type that the scene needs."""
    rng = np.random.default_rng(3)
    net = scene.lens.control_points
    # Aimed at the screen, as a designed lens is: slopes so small that light stays on it.
    waves = 1e-7 * rng.normal(size=net)
    heights = torch.tensor(scene.lens.base.height + 0.019 + waves)
    return [
        Plan(scene, dtype=t).trace({"exit": heights}).flux
        for t in (torch.float32, torch.float64, None)
    ]


@pytest.mark.parametrize("source", [{"kind": "collimated", "rays": [512, 512]}, POINT])
@pytest.mark.parametrize("pixels", [256, 512])
def test_common_scenes_do_with_float32(make_scene, source, pixels):
    scene = make_scene(
        {"source": source, "screen.pixels": [pixels, pixels], "lens.control_points": [128, 128]}
    )
    assert precision_of(scene) == torch.float32
    assert "float32" in Plan(scene).notes[0]
    assert not any("would move" in note for note in Plan(scene).notes)


def test_a_far_screen_of_fine_pixels_is_traced_in_float64(make_scene):
    scene = make_scene(FAR)
    single, double, chosen = images(scene)
    assert (single - double).abs().sum() > 1e-3 * double.sum()
    assert torch.equal(chosen, double)
    plan = Plan(scene)
    assert "float64" in plan.notes[0]
    assert any("would move light" in note for note in plan.notes)


def test_the_shift_is_that_of_rounding(make_scene):
    """It grows with distance, pixels and net, and does not know units."""
    scene = make_scene({"screen.z": 100.0})
    known = shift_of(scene)
    assert shift_of(make_scene({"screen.z": 200.0})) == pytest.approx(2 * known, rel=0.01)
    assert shift_of(make_scene({"screen.z": 100.0, "screen.pixels": [64, 64]})) == pytest.approx(
        2 * known
    )
    assert shift_of(
        make_scene({"screen.z": 100.0, "lens.control_points": [24, 20]})
    ) == pytest.approx(2 * known)


def test_a_screen_that_leans_far_away_is_traced_in_float64(make_scene):
    """Places along it are differences of the way to it, which is rounded."""
    far = {"version": 2, "screen.z": 1e5, "screen.half_width": [1.0, 1.0]}
    upright, leaning = (make_scene(far | {"screen.tilt": [0.0, tilt]}) for tilt in (0.0, 20.0))
    more = shift_of(leaning) - shift_of(upright)
    pixels = leaning.screen.pixels[0] / 2  # for each unit of length
    eps = torch.finfo(torch.float32).eps
    assert more > eps * pixels * 1e5 * math.sin(math.radians(20))
    assert precision_of(leaning) is torch.float64
