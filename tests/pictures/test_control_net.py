"""Control points in the 3D scene, off screen: shown, picked, marked."""

import numpy as np
import pytest

from workbench.pictures.control_net import ControlNetPicture
from workbench.pictures.lens import LensPicture


@pytest.fixture
def net(make_scene, plotter):
    """The net of 12 × 10 control points, seen as the default view has it; one of them marked."""
    scene = make_scene()
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    net = ControlNetPicture(plotter, scene.optic, "exit")
    net.update(np.full((12, 10), 0.5))
    net.mark((0, 0))
    plotter.render()
    return net


def drawn(plotter):
    plotter.render()
    return plotter.screenshot(return_img=True).astype(int)


def in_window(plotter, point):
    """Pixels of a point of the scene, from the lower left."""
    plotter.renderer.SetWorldPoint(*point, 1.0)
    plotter.renderer.WorldToDisplay()
    return plotter.renderer.GetDisplayPoint()[:2]


def test_each_point_is_picked_where_it_is_seen(net, plotter):
    for index in np.ndindex(12, 10):
        x, y = in_window(plotter, net._places[index])
        assert net.pick(x, y) == index


def test_points_are_picked_where_they_have_moved(net, plotter, rng):
    net.update(rng.uniform(0.3, 0.7, (12, 10)))
    for index in [(0, 0), (11, 0), (4, 7)]:
        x, y = in_window(plotter, net._places[index])
        assert net.pick(x, y) == index


def test_the_surface_between_points_picks_the_nearest(net, plotter):
    between = 0.7 * net._places[5, 4] + 0.3 * net._places[6, 4]
    assert net.pick(*in_window(plotter, between)) == (5, 4)


def test_nothing_is_picked_beside_the_lens(net, plotter):
    assert net.pick(1, 1) is None


def test_points_of_the_entrance_face_lie_outside_the_glass(make_scene, plotter):
    scene = make_scene({"lens.entrance": {"shape": "freeform", "control_points": [6, 7]}})
    LensPicture(plotter, scene, np.ones((32, 32))).fit("entrance")
    net = ControlNetPicture(plotter, scene.optic, "entrance")
    net.update(np.zeros((6, 7)))
    net.show(True)
    assert shown(net._points) == 42 and (net._points._mesh.points[:, 2] < 0).all()
    plotter.render()
    for index in [(0, 0), (5, 0), (2, 4)]:
        assert net.pick(*in_window(plotter, net.places[index])) == index


def test_the_marked_point_stands_out(net, plotter):
    plain = drawn(plotter)
    net.mark((8, 8))
    marked = drawn(plotter)
    x, y = in_window(plotter, net._places[8, 8])
    spots = np.argwhere(np.abs(marked - plain).sum(axis=-1) > 30)
    seen = np.array([400 - 1 - y, x])
    assert np.linalg.norm(spots - seen, axis=1).min() < 3
    red, green, blue = marked[round(seen[0]), round(seen[1])]
    assert min(red, blue) > green + 60


@pytest.fixture
def fine(make_scene, plotter):
    """A net of 192 × 192 points, too many to be shown."""
    scene = make_scene({"lens.control_points": [192, 192]})
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    net = ControlNetPicture(plotter, scene.optic, "exit")
    net.update(np.full((192, 192), 0.5))
    net.show(True)
    plotter.render()
    return net


def shown(dots):
    return dots._mesh.n_points if dots._actor.visibility else 0


def test_a_coarse_net_is_shown_whole_with_its_lines(net, plotter):
    net.mark(None)
    assert shown(net._points) == 0
    net.show(True)
    assert shown(net._points) == 120
    assert net._net_lines.visibility and net._lines.n_lines == 22
    plotter.camera.zoom(0.2)
    net.update(np.full((12, 10), 0.5))
    assert not net._net_lines.visibility and shown(net._points) == 120  # too close together
    net.show(False)
    assert shown(net._points) == 0 and not net._net_lines.visibility


def test_a_fine_net_is_shown_near_the_brush_alone(fine, plotter):
    assert shown(fine._points) == 0
    plotter.camera.zoom(20)
    fine.update(np.full((192, 192), 0.5))
    fine.brush((100, 3), 0.05)
    assert shown(fine._points) == 25 * 16
    assert fine._lines.n_lines == 25 + 16
    fine.brush(None)
    assert shown(fine._points) == 0 and not fine._net_lines.visibility


@pytest.mark.parametrize("view", ["", "side", "top", "axis"])
def test_points_of_a_fine_net_are_picked_where_they_are_seen(make_scene, plotter, view, rng):
    scene = make_scene({"lens.control_points": [64, 50]})
    LensPicture(plotter, scene, np.ones((32, 32))).fit(view)
    net = ControlNetPicture(plotter, scene.optic, "exit")
    # Tilted, so that none hides another when seen from the side or from above.
    tilt = np.linspace(-0.2, 0.2, 64)[:, None] + np.linspace(-0.1, 0.1, 50)
    net.update(0.5 + tilt)
    net.show(True)
    plotter.camera.zoom(4)
    plotter.render()
    for index in rng.integers(0, (64, 50), (20, 2)):
        place = net.places[tuple(index)]
        i, j = net.pick(*in_window(plotter, place))
        seen = np.array([in_window(plotter, place), in_window(plotter, net.places[i, j])])
        assert np.abs(seen[0] - seen[1]).max() < 1.5  # itself, or another on the same pixel


def test_the_brush_highlights_what_it_takes_along(net):
    net.show(True)
    net.brush((5, 5), 0.0)
    assert shown(net._brushed) == 1
    net.brush((5, 5), 0.5)
    reached = net._brushed._mesh.points
    assert 9 < len(reached) < 120
    assert np.hypot(*(reached[:, :2] - net.places[5, 5, :2]).T).max() < 0.5


def test_locked_points_are_squares_of_another_colour(net, plotter):
    locked = np.zeros((12, 10), dtype=bool)
    locked[8, 8] = True
    net.mark(None)
    net.lock(locked)
    assert shown(net._locks) == 0  # only with the net
    net.show(True)
    plotter.camera.focal_point = net.places[8, 8]
    plotter.camera.zoom(5)
    net._net_lines.SetVisibility(False)
    plain = drawn(plotter)
    assert shown(net._locks) == 1
    assert shown(net._points) == 119
    x, y = in_window(plotter, net.places[8, 8] + (0, 0, 0.008))
    row, column = 400 - 1 - round(y), round(x)
    red, _, blue = np.moveaxis(plain[row - 6 : row + 7, column - 6 : column + 7], -1, 0)
    rows, columns = np.nonzero(red > blue + 40)
    across = np.ptp(rows) + 1, np.ptp(columns) + 1
    assert min(across) >= 6 and len(rows) == across[0] * across[1]  # corners and all
    net.lock(None)
    assert shown(net._locks) == 0
