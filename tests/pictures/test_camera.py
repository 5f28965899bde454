"""The camera of the 3D scene is led around, beside and nearer."""

import numpy as np
import pytest

from workbench.pictures.camera import FittedCamera, scene_corners
from workbench.pictures.compass import Compass
from workbench.pictures.projection import Projection


@pytest.fixture(params=[False, True], ids=["parallel", "perspective"])
def camera(request, plotter, make_scene):
    made = FittedCamera(plotter, make_scene(), perspective=request.param)
    made.fit("axis")
    return made


def test_camera_turns_about_the_middle(camera, plotter):
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


@pytest.mark.parametrize("factor", [1.25, 0.6])
def test_the_point_that_it_zooms_to_stays_where_it_is(camera, plotter, factor):
    camera.turn(25, -20)
    about = np.array([[0.3, -0.2, 0.4]])
    places = about + np.array([[0, 0, 0], [0.1, 0.05, 0]])
    sight = Projection(plotter)
    before = sight.pixels(places)
    away = np.array(plotter.camera.focal_point) - about[0]
    camera.zoom(factor, about[0])
    after = sight.pixels(places)
    np.testing.assert_allclose(after[0], before[0], atol=1e-6)
    assert np.linalg.norm(after[1] - after[0]) == pytest.approx(
        factor * np.linalg.norm(before[1] - before[0]), rel=0.01
    )
    np.testing.assert_allclose(np.array(plotter.camera.focal_point) - about[0], away / factor)


SCENES = [
    {"screen.z": 5.0},
    {"screen.z": 1.0},  # close to the lens
    {"screen.half_width": [6.0, 6.0]},
    {"screen.z": 500.0, "screen.half_width": [100.0, 100.0]},
    {"source": {"kind": "point", "position": [0.0, 0.0, -12.0], "rays": 1000}},
]


def outline(sight, half_width, heights):
    """Where a box about the axis is seen: left, lower, right and upper end."""
    (x, y) = half_width
    pixels = sight.pixels(
        np.array([[i * x, j * y, z] for z in heights for i in (-1, 1) for j in (-1, 1)])
    )
    return *pixels.min(axis=0), *pixels.max(axis=0)


@pytest.mark.parametrize("perspective", [False, True])
@pytest.mark.parametrize("changes", SCENES)
def test_a_look_at_the_lens_holds_it_large_and_free_of_the_screen(
    make_scene, plotter, changes, perspective
):
    scene = make_scene(changes)
    camera = FittedCamera(plotter, scene, perspective=perspective)
    camera.fit("lens")
    sight = Projection(plotter)
    left, low, right, high = outline(sight, scene.optic.half_width, (0.0, 0.5))
    width, height = plotter.window_size
    assert min(left, low) > 0 and right < width and high < height
    assert max((right - left) / width, (high - low) / height) > 0.7
    beyond = perspective and plotter.camera.position[2] < scene.receiver.z  # behind the camera
    assert beyond or outline(sight, scene.receiver.half_width, (scene.receiver.z,))[0] > right


def test_a_mirror_is_seen_from_its_reflecting_side(plotter, make_scene):
    mirror = {"half_width": [1, 1], "control_points": [8, 8]}
    aside = {"z": -5.0, "half_width": [1, 1], "pixels": [32, 32], "center": [3.0, 0.0]}
    scene = make_scene({"lens": None, "mirror": mirror, "screen": aside})
    made, lens = FittedCamera(plotter, scene), FittedCamera(plotter, make_scene())
    for view in ("", "lens"):
        made.fit(view)
        assert plotter.camera.direction[2] > 0.1  # it looks towards +z, as the light comes
        lens.fit(view)
        assert plotter.camera.direction[2] < -0.1


def test_a_flight_begins_and_ends_at_its_views_and_turns_at_one_speed(camera, plotter):
    start = camera.state()
    camera.fit("+x")
    end = camera.state()

    def toward(part):
        camera.fly(start, end, part)
        away = np.subtract(plotter.camera.position, plotter.camera.focal_point)
        return away / np.linalg.norm(away)

    np.testing.assert_allclose(toward(0.0), [0, 0, 1], atol=1e-9)
    np.testing.assert_allclose(toward(0.5), [0.5**0.5, 0, 0.5**0.5], atol=1e-9)
    assert not camera.untouched
    np.testing.assert_allclose(toward(1.0), [1, 0, 0], atol=1e-9)
    assert camera.untouched and camera.state() == end


@pytest.mark.parametrize("name", ["+x", "-x", "+y", "-y", "+z", "-z"])
def test_each_ball_of_the_compass_leads_to_its_view(camera, plotter, name):
    before = plotter.ren_win.GetRenderers().GetNumberOfItems()
    compass = Compass(plotter)
    camera.turn(33, 21)
    plotter.render()
    width, height = plotter.window_size
    found = {
        compass.pick(x, y)
        for x in range(width - 78, width, 4)
        for y in range(height - 78, height, 4)
    }
    assert found == {"", "+x", "-x", "+y", "-y", "+z", "-z"}
    assert compass.pick(width / 2, height / 2) == ""
    camera.fit(name)
    axis = "xyz".index(name[1])
    plotter.render()
    assert np.sign(plotter.camera.direction[axis]) == (-1 if name[0] == "+" else 1)
    assert compass.pick(width - 38, height - 38) == name  # its ball is in front
    compass.close()
    assert plotter.ren_win.GetRenderers().GetNumberOfItems() == before


def test_pictures_can_be_without_the_compass(plotter, make_scene):
    FittedCamera(plotter, make_scene()).fit("axis")
    compass = Compass(plotter)

    def colour():  # of the strongest pixel in the corner
        plotter.render()
        corner = plotter.screenshot(return_img=True)[:80, -80:, :3].astype(int)
        return np.ptp(corner, axis=2).max()

    assert colour() > 100
    compass.show(False)
    without = colour()
    compass.show(True)
    assert without < 50 and colour() > 100
    compass.close()


def test_a_narrow_window_looks_more_along_the_axis_and_fills_its_width(plotter, make_scene):
    scene, directions = make_scene({"screen.z": 8.0}), []
    for size in ((1200, 400), (300, 600)):
        plotter.window_size = size
        FittedCamera(plotter, scene).fit("")
        directions.append(abs(plotter.camera.direction[2]))
        places = Projection(plotter).pixels(scene_corners(scene))
        assert (places >= 0).all() and (places <= size).all()
    across = np.ptp(places[:, 0]) / size[0]
    assert across > 0.8
    assert directions[1] > directions[0]
