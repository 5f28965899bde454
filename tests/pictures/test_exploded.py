"""Distances drawn shorter: rays still run from the source to their place in the image."""

import numpy as np
import pytest

from workbench.pictures.camera import scene_corners
from workbench.pictures.compressed import compress_distances

POINT = {"kind": "point", "position": [0.3, -0.2, -400.0], "rays": 100}
GRID = {
    "kind": "grid",
    "center": [0.0, 1.0, -80.0],
    "half_width": [2.0, 1.0],
    "points": [5, 5],
    "rays": 10,
}


@pytest.mark.parametrize("source", [None, POINT, GRID])
def test_a_far_and_wide_screen_leaves_the_lens_a_good_part_of_the_picture(make_scene, source):
    changes = {"screen.z": 500.0, "screen.half_width": [200.0, 100.0]}
    scene = make_scene(changes if source is None else {**changes, "source": source})
    corners = scene_corners(compress_distances(scene))
    extent = corners.max(axis=0) - corners.min(axis=0)
    assert (extent <= 2 * max(scene.optic.half_width) * np.array([1.5, 1.5, 4.5])).all()
    drawn = compress_distances(scene).receiver
    assert drawn.half_width[0] == pytest.approx(2 * drawn.half_width[1])
    assert compress_distances(scene).optic == scene.optic
