"""When float32 is enough, and what is done when it is not."""

import numpy as np
import torch

from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan, nearly_touches, precision_of
from workbench.optics.samples import Corners

FAR = {"screen.z": 2e5, "screen.pixels": [64, 64], "lens.height_range": [-0.02, 0.02]}


def images(scene):
    """The image in float32, float64, and in the float type that the scene needs."""
    rng = np.random.default_rng(3)
    net = scene.optic.control_points
    # Aimed at the screen, as a designed lens is: slopes so small that light stays on it.
    waves = 1e-7 * rng.normal(size=net)
    heights = torch.tensor(scene.optic.base.height + 0.019 + waves)
    return [
        Plan(scene, dtype=t).trace({"lens.back": heights}).flux
        for t in (torch.float32, torch.float64, None)
    ]


def test_a_far_screen_of_fine_pixels_is_traced_in_float64(make_scene):
    scene = make_scene(FAR)
    single, double, chosen = images(scene)
    assert (single - double).abs().sum() > 1e-3 * double.sum()
    assert torch.equal(chosen, double)
    plan = Plan(scene)
    assert "float64" in plan.notes[0]
    assert any("too few digits" in note for note in plan.notes)


def test_light_of_a_source_that_nearly_touches_the_lens_is_traced_in_float64(make_scene):
    def lit_from(distance):
        lens = {"lens.control_points": [12, 12], "lens.height_range": [-0.02, 0.02]}
        source = {"kind": "area", "half_width": [0.2, 0.1], "rays": 100}
        return make_scene(
            {"version": 2, "source": source | {"center": [0.1, 0.0, -distance]}} | lens
        )

    near, common = lit_from(1e-6), lit_from(0.01)
    assert nearly_touches(near)
    assert precision_of(near) is torch.float64
    assert precision_of(common) is torch.float32

    def account(scene, dtype):
        heights = {
            "lens.back": torch.full(scene.optic.control_points, scene.optic.base.height).double()
        }
        corners = Corners(16, 16, 16)
        lost = BeamPlan(scene, corners, dtype=dtype).trace(heights).account.to_data()
        return np.array(list(lost.values()))

    chosen, double, single = (account(near, t) for t in (None, torch.float64, torch.float32))
    assert np.array_equal(chosen, double)
    assert np.abs(single - double).max() > 1e-3
    single, double = (account(common, t) for t in (torch.float32, torch.float64))
    assert np.abs(single - double).max() < 1e-5
