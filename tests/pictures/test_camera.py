"""The camera of the 3D scene is led around, beside and nearer."""

import numpy as np
import pytest

from workbench.pictures.camera import FittedCamera
from workbench.pictures.sight import Sight

HEIGHT = 400  # of the plotter


@pytest.fixture(params=[False, True], ids=["parallel", "perspective"])
def camera(request, plotter, make_scene):
    made = FittedCamera(plotter, make_scene(), perspective=request.param)
    made.fit("axis")
    return made


def test_it_turns_about_the_middle(camera, plotter):
    seen, middle = plotter.camera, np.array(plotter.camera.focal_point)

    def toward():
        return (np.array(seen.position) - middle) / seen.distance

    camera.turn(30, 0)
    np.testing.assert_allclose(toward(), [0.5, 0, np.sqrt(0.75)], atol=1e-9)
    camera.turn(60, 30)
    np.testing.assert_allclose(toward(), [np.sqrt(0.75), 0.5, 0], atol=1e-9)
    assert not camera.untouched
    camera.turn(-90, 0)
    camera.turn(0, -30)
    np.testing.assert_allclose(toward(), [0, 0, 1], atol=1e-9)  # one way and back
    assert seen.up == (0, 1, 0)


def test_it_stops_short_of_the_top(camera, plotter):
    for _ in range(40):
        camera.turn(0, 5)
    assert np.dot(plotter.camera.direction, (0, -1, 0)) == pytest.approx(np.sin(np.radians(85)))
    camera.turn(0, -170)
    assert np.dot(plotter.camera.direction, (0, 1, 0)) == pytest.approx(np.sin(np.radians(85)))


def test_it_moves_by_parts_of_the_picture(camera, plotter):
    camera.turn(20, -30)
    middle, direction = np.array(plotter.camera.focal_point), plotter.camera.direction
    sight = Sight(plotter)
    before = sight.pixels(middle[None])
    camera.move(0.25, 0.1)
    moved = before - sight.pixels(middle[None])
    np.testing.assert_allclose(moved, [[0.25 * HEIGHT, 0.1 * HEIGHT]], atol=1e-6)
    np.testing.assert_allclose(plotter.camera.direction, direction, atol=1e-9)


def test_it_comes_nearer_to_the_middle(camera, plotter):
    middle = np.array(plotter.camera.focal_point)
    places = middle + np.array([[0, 0, 0], [0.2, 0.1, 0]])
    sight = Sight(plotter)
    before = sight.pixels(places)
    camera.zoom(1.25)
    after = sight.pixels(places)
    np.testing.assert_allclose(after[0], before[0], atol=1e-6)
    np.testing.assert_allclose(after[1] - after[0], 1.25 * (before[1] - before[0]), atol=1e-6)
