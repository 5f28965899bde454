"""What the best method promises."""

import numpy as np
import pytest

from workbench.design.run import run


def best(scene, target):
    return [s for s in run(scene, target) if s.best][-1]


@pytest.fixture
def letter():
    image = np.zeros((32, 32))
    image[6:26, 8:12] = 1.0
    image[22:26, 8:24] = 1.0
    return image


def test_the_first_iteration_reduces_the_loss_to_a_third(make_scene, letter):
    first, second, *_ = run(make_scene({"lens.control_points": [24, 24]}), letter)
    assert second.state.loss < 0.3 * first.state.loss


def test_symmetric_tasks_have_symmetric_lenses(make_scene):
    scene = make_scene({"run.iterations": 20})
    across = np.linspace(-1, 1, 32)
    disc = (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)
    heights = best(scene, disc).state.heights["exit"]
    for axis in (0, 1):
        assert heights == pytest.approx(np.flip(heights, axis), abs=1e-12)


@pytest.mark.parametrize("kind", ["point", "grid"])
def test_light_of_points_reaches_the_screen(make_scene, letter, kind):
    source = {"kind": "point", "position": [0.1, 0.0, -5.0], "rays": 4096}
    if kind == "grid":
        source = {
            "kind": "grid",
            "center": [0.1, 0.0, -5.0],
            "half_width": [0.02, 0.02],
            "points": [3, 3],
            "rays": 500,
        }
    scene = make_scene({"source": source, "lens.control_points": [24, 24]})
    found = best(scene, letter)
    lost = found.state.account.lost["off_screen"] + found.state.account.lost["total_reflection"]
    assert lost < 0.03 * found.state.account.on_screen
