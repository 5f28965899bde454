"""Handles of sources: where they are, and what dragging them does."""

import numpy as np
import pytest

from workbench.pictures.lens import LensPicture
from workbench.pictures.projection import Projection
from workbench.pictures.source_handles import SourceHandles, moved

POINT = {"kind": "point", "position": [0.1, 0.2, -3.0]}
GRID = {
    "kind": "grid",
    "center": [0.1, 0.0, -3.0],
    "half_width": [0.8, 0.5],
    "points": [5, 5],
    "rays": 10,
}


@pytest.fixture
def handles(make_scene, plotter):
    def make(source):
        scene = make_scene({"source": source})
        LensPicture(plotter, scene, np.ones((32, 32))).fit()
        made = SourceHandles(plotter)
        made.show(scene.source)
        plotter.ren_win.Render()
        return made, scene.source

    return make


def test_a_point_is_its_own_handle(handles, plotter):
    made, source = handles(POINT)
    ((x, y),) = Projection(plotter).pixels(np.array([source.position]))
    assert made.pick(x + 5, y - 5) == "middle"
    assert made.pick(x + 30, y) is None
    made.show(None)
    assert made.pick(x, y) is None


def test_a_grid_has_corners_and_a_middle(handles, plotter):
    made, _ = handles(GRID)
    corners = [[-0.7, -0.5, -3.0], [-0.7, 0.5, -3.0], [0.9, -0.5, -3.0], [0.9, 0.5, -3.0]]
    seen = Projection(plotter).pixels(np.array([*corners, [0.1, 0.0, -3.0], [0.5, 0.25, -3.0]]))
    assert [made.pick(x, y) for x, y in seen] == [0, 1, 2, 3, "middle", "middle"]


def test_moving_rounds_to_what_a_person_would_type(make_scene):
    point = make_scene({"source": POINT}).source
    by = np.array([0.01234567, -0.1, 0.00001])
    assert moved(point, "middle", by, 3).position == (0.112, 0.1, -3.0)
    back = moved(point, "middle", -np.array(point.position) - 1e-9, 3).position
    assert str(back) == "(0.0, 0.0, 0.0)"  # not -0
    grid = make_scene({"source": GRID}).source
    assert moved(grid, "middle", by, 3).center == (0.112, -0.1, -3.0)
