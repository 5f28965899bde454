"""Light that something is in the way of, where that is known exactly."""

import numpy as np
import pytest

from workbench.analysis.shading import SHADED, shading_of
from workbench.analysis.validation import validate
from workbench.geometry.surface import ControlNet
from workbench.report.figures import check_rows
from workbench.scene import Scene


def mirror(changes=None, **fields):
    data = {
        "mirror": {
            "half_width": [1.0, 1.0],
            "control_points": [40, 4],
            "degree": [1, 1],
            "height_range": [-3.0, 3.0],
        },
        "source": {"kind": "collimated", "rays": [64, 64]},
        "screen": {"z": -9.0, "half_width": [0.5, 0.4], "pixels": [8, 8]},
        "target": {"builtin": "tophat"},
    }
    data["mirror"] |= changes or {}
    return Scene.from_data({key: value for key, value in (data | fields).items() if value})


def trough(scene, slope):
    """Two planes that meet at x = 0 and lean towards each other: its light side is inside."""
    x, _ = ControlNet.of(scene.optic).positions
    return {"mirror.face": np.repeat(-slope * np.abs(x)[:, None], 4, axis=1)}


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_a_trough_of_a_right_angle_sends_all_light_to_its_other_side(outline):
    scene = mirror({"control_points": [41, 4], "outline": outline})
    found = shading_of(scene, trough(scene, 1.0), seed=1)
    lit = 1.0 if outline == "rectangle" else np.pi / 4
    assert found.meets_again == pytest.approx(lit, rel=2e-2)


def test_light_comes_back_where_the_check_says():
    """A wall at x > 0.5, 56 degrees steep, sends its light up to the level rest of the mirror."""
    scene = mirror({"control_points": [41, 4]})
    x, _ = ControlNet.of(scene.optic).positions

    def walled(slope):
        wall = np.repeat(-slope * (x - 0.5).clip(min=0)[:, None], 4, axis=1)
        return shading_of(scene, {"mirror.face": wall}, seed=1)

    found = walled(1.5)
    assert found.meets_again == pytest.approx(0.25, rel=2e-2)
    # Light from x rises by 5 for 12 aside, and the wall by 1.5 (x - 0.5).
    assert -0.8 < found.at[0] < 0.5
    assert found.figures[SHADED[0]].endswith("({:.4g}, {:.4g})".format(*found.at))
    assert walled(0.9).meets_again == 0.0  # goes down by 6 degrees


def test_a_screen_on_the_axis_stands_in_parallel_light():
    scene = mirror()
    found = shading_of(scene, trough(scene, 0.0), seed=1)
    assert found.through_receiver == pytest.approx(0.5 * 0.4, rel=2e-2)
    assert list(found.figures) == [SHADED[1]]


@pytest.mark.parametrize(("z", "part"), [(-4.0, 0.0), (-18.0, 0.8)])
def test_light_of_a_point_is_shaded_by_a_screen_before_it_alone(z, part):
    """From twice as far, the shadow of the screen is twice as large."""
    source = {"kind": "point", "position": [0.0, 0.0, z], "rays": 1000}
    scene = mirror(source=source)
    found = shading_of(scene, trough(scene, 0.0), seed=1)
    hits = 0.0 if not part else found.through_receiver / _met(scene)
    assert hits == pytest.approx(part, rel=3e-2)


def _met(scene):
    heights = trough(scene, 0.0)
    found = validate(scene, np.ones((8, 8)), heights, 20_000)
    return 1 - found.account.lost["missed_mirror"]


def test_the_check_tells_of_shaded_light():
    scene = mirror()
    found = validate(scene, np.ones((8, 8)), trough(scene, 0.1), 20_000, accuracy=0.05)
    rows = {row.name: row.value for row in check_rows(found, 0.0)}
    assert rows[SHADED[1]].endswith("% of the light")
    assert SHADED[0] not in rows
    assert found.to_data()["shading"]["through_receiver"] == pytest.approx(0.2, rel=2e-2)
