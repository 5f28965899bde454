"""What sources say of themselves."""

import numpy as np
import pytest

from workbench.scene import GridSource


def grid(points, half_width=(2.0, 1.0)):
    return GridSource(kind="grid", position=(1.0, 0.0, -3.0), half_width=half_width, points=points)


def test_grid_points_reach_the_rim_of_the_source():
    found = grid((3, 2)).seen((25, 25))
    expected = [[x, y, -3] for x in (-1, 1, 3) for y in (-1, 1)]
    np.testing.assert_allclose(found, expected)


@pytest.mark.parametrize(
    ("source", "rays"),
    [
        ({"kind": "collimated", "rays": [5, 7]}, 35),
        ({"kind": "point", "position": [0, 0, -5], "rays": 4000}, 4000),
        (
            {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1], "points": [2, 3]}
            | {"rays": 500},
            3000,
        ),
    ],
)
def test_all_rays_of_a_source_are_counted(make_scene, source, rays):
    assert make_scene({"source": source}).source.ray_count == rays
