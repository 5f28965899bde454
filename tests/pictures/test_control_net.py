"""Control points in the 3D scene, off screen: shown, picked, marked."""

import numpy as np
import pytest
import pyvista

from workbench.pictures.control_net import ControlNetPicture
from workbench.pictures.lens import LensPicture


@pytest.fixture
def plotter():
    made = pyvista.Plotter(off_screen=True, window_size=[640, 400])
    yield made
    made.close()


@pytest.fixture
def net(make_scene, plotter):
    """The net of 12 × 10 control points, seen as the default view has it; one of them marked."""
    scene = make_scene()
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    net = ControlNetPicture(plotter, scene.lens)
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


def test_nothing_is_picked_beside_the_lens_or_while_hidden(net, plotter):
    assert net.pick(1, 1) is None
    net.mark(None)
    assert net.pick(*in_window(plotter, net._places[5, 4])) is None


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
