"""Between the scene and its picture."""

import numpy as np
import pytest

from workbench.pictures.lens import LensPicture
from workbench.pictures.projection import Projection


@pytest.fixture(params=["parallel", "perspective"])
def plotter(request, plotter):
    plotter.camera.position, plotter.camera.focal_point = (4.0, -5.0, 3.0), (0.2, 0.1, 0.5)
    plotter.camera.up = (0.0, 0.0, 1.0)
    plotter.camera.parallel_projection = request.param == "parallel"
    plotter.camera.parallel_scale = 2.0
    plotter.camera.clipping_range = (0.1, 20.0)
    plotter.render()
    return plotter


def test_points_are_where_vtk_draws_them(plotter, rng):
    points = rng.uniform(-1, 1, (20, 3))
    seen = Projection(plotter).pixels(points)
    for point, pixel in zip(points, seen, strict=True):
        plotter.renderer.SetWorldPoint(*point, 1.0)
        plotter.renderer.WorldToDisplay()
        np.testing.assert_allclose(pixel, plotter.renderer.GetDisplayPoint()[:2], atol=0.02)


def test_the_line_of_sight_goes_through_its_point(plotter):
    point = np.array([[0.4, -0.3, 0.7]])
    sight = Projection(plotter)
    start, end = sight.line(*sight.pixels(point)[0])
    along = (end - start) / np.linalg.norm(end - start)
    away = point[0] - start
    assert np.linalg.norm(away - (away @ along) * along) < 2e-3


@pytest.fixture
def scene_sight(make_scene, plotter):
    """Looks at a picture of a scene from its first place."""
    scene = make_scene()
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    plotter.render()
    return scene, Projection(plotter)


def test_a_look_finds_the_body_under_the_pointer(scene_sight):
    scene, sight = scene_sight
    for place in ([0.2, 0.3, 0.5], [-0.4, 0.1, scene.receiver.z]):  # the exit face, the screen
        (pixel,) = sight.pixels(np.array([place]))
        np.testing.assert_allclose(sight.point(*pixel), place, atol=1e-3)
