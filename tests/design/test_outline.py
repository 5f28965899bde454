"""Lenses with an elliptic outline: their limits, and what the paper's and our own method find."""

import numpy as np
import pytest

from workbench.design.limits import HeightLimits
from workbench.design.run import run
from workbench.geometry.surface import ControlNet
from workbench.targets import load_target

ROUND = {"lens.outline": "ellipse", "lens.control_points": [32, 32]}


def test_heights_beside_the_lens_need_not_fit(make_scene):
    scene = make_scene(ROUND)
    net = ControlNet.of(scene.optic)
    limits = HeightLimits.of(scene.optic, net)
    assert not limits.shaping[0, 0]
    assert limits.shaping[16, 0]
    heights = np.full((32, 32), 0.5)
    heights[0, 0] = 7.0
    assert limits.hold(heights)
    assert limits.lacks(heights) < 0
    assert not limits.ends(heights, 0.01)[1].any()
    heights[16, 0] = 7.0
    assert not limits.hold(heights)
    assert limits.lacks(heights) > 0


def test_a_design_of_an_elliptic_lens_comes_near_the_target(make_scene, tmp_path):
    changes = ROUND | {"target": {"builtin": "ball"}, "run.iterations": 25}
    errors = {}
    for outline in ("rectangle", "ellipse"):
        scene = make_scene(changes | {"lens.outline": outline})
        target = load_target(scene, tmp_path)
        *_, last = run(scene, target)
        image = last.state.irradiance / last.state.irradiance.sum()
        wanted = target / target.sum()
        errors[outline] = np.linalg.norm(image - wanted) / np.linalg.norm(wanted)
        heights = last.state.heights["exit"]
    assert errors["ellipse"] < 1.5 * errors["rectangle"] + 0.01
    assert last.state.account.lost["missed_lens"] == pytest.approx(1 - np.pi / 4, abs=1e-6)
    second_differences = np.abs(np.diff(heights, 2, axis=0))
    assert (
        second_differences[:, 0].max() < 3 * second_differences[:, 16].max()
    )  # no wild heights beside the lens
