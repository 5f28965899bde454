"""Rays that are drawn of lenses with an elliptic outline."""

import numpy as np

from ui.shown.frame import RAYS, some_rays
from workbench.optics.paths import ray_paths


def test_some_rays_of_an_elliptic_lens_are_spread_over_it(make_scene):
    scene = make_scene({"lens.outline": "ellipse", "lens.half_width": [1.0, 0.5]})
    heights = {"exit": np.full(scene.optic.net_shape, 0.5)}
    some = some_rays(ray_paths(scene, heights, (RAYS, RAYS)), 9)
    x, y = some.points[:, 1, 0], some.points[:, 1, 1] / 0.5
    assert len(x) == 81
    assert np.hypot(x, y).max() < 1
    assert np.hypot(x, y).max() > 0.8
