"""The exit face: evaluation at points, orientation of its axes."""

import numpy as np
import pytest
from scipy.interpolate import NdBSpline

from workbench.geometry.surface import ControlNet

NETS = [
    ControlNet((4, 4), (3, 3), (1.0, 1.0)),
    ControlNet((9, 14), (2, 5), (0.5, 3.0)),
    ControlNet((20, 8), (7, 1), (2.0, 0.02)),
]


@pytest.fixture(params=NETS, ids=str)
def net(request):
    return request.param


def scipy_surface(net, heights, u, v, order):
    values = NdBSpline(net.knots, heights, net.degree)(np.stack([u, v], axis=-1), nu=order)
    return values / (2 * net.half_width[0]) ** order[0] / (2 * net.half_width[1]) ** order[1]


def test_points_agree_with_scipy(net, rng):
    heights = rng.normal(size=net.shape)
    u, v = np.concatenate([rng.random((2, 300)), [[0, 1, 1, 0], [0, 1, 0, 1]]], axis=1)
    for ours, order in zip(
        net.points(u, v).evaluate(heights), [(0, 0), (1, 0), (0, 1)], strict=True
    ):
        theirs = scipy_surface(net, heights, u, v, order)
        assert np.abs(ours - theirs).max() <= 1e-12 * max(1, np.abs(theirs).max())


def test_a_plane_over_the_positions_is_a_plane(net, rng):
    x, y = net.positions
    heights = 0.3 + 2 * x[:, None] - 5 * y[None, :]
    u, v = rng.random(50), rng.random(50)
    z, slope_x, slope_y = net.points(u, v).evaluate(heights)
    plane = 0.3 + 2 * (2 * u - 1) * net.half_width[0] - 5 * (2 * v - 1) * net.half_width[1]
    assert np.abs(z - plane).max() < 1e-12
    assert slope_x == pytest.approx(2, abs=1e-11)
    assert slope_y == pytest.approx(-5, abs=1e-9)
