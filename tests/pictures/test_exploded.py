"""Distances drawn shorter: rays still run from the source to their place in the image."""

import numpy as np
import pytest

from workbench.optics.paths import ray_paths
from workbench.pictures.camera import scene_corners
from workbench.pictures.compressed import compress_distances, compress_paths

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


@pytest.mark.parametrize("source", [POINT, GRID])
def test_rays_begin_at_the_source_and_end_in_the_image(make_scene, source):
    scene = make_scene({"screen.z": 300.0, "screen.half_width": [30.0, 30.0], "source": source})
    drawn = compress_distances(scene)
    paths = ray_paths(scene, {"exit": np.full((12, 10), 0.5)}, (5, 5))
    points = compress_paths(paths.points, scene)
    np.testing.assert_array_equal(points[:, 1:3], paths.points[:, 1:3])
    np.testing.assert_allclose(points[:, 3, 2], drawn.receiver.z)
    before = scene.receiver.to_pixels(*paths.points[:, 3, :2].T)
    np.testing.assert_allclose(drawn.receiver.to_pixels(*points[:, 3, :2].T), before)
    starts = ray_paths(drawn, {"exit": np.full((12, 10), 0.5)}, (5, 5)).points[:, 0]
    np.testing.assert_allclose(points[:, 0], starts)
