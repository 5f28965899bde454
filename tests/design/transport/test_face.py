"""Faces from slopes."""

import numpy as np
import pytest

from workbench.design.transport.face import SlopeFit
from workbench.geometry.surface import ControlNet


@pytest.mark.parametrize(
    ("shape", "degree"), [((9, 14), (3, 3)), ((2, 5), (1, 2)), ((40, 30), (2, 5))]
)
def test_a_face_comes_back_from_its_slopes(rng, shape, degree):
    net = ControlNet(shape, degree, (1.5, 0.4))
    places = (np.arange(64) + 0.5) / 64
    fit = SlopeFit(net, 64)
    heights = rng.normal(size=shape)
    surface, slope_x, slope_y = net.grid(places, places).evaluate(heights)
    assert fit.surface(heights) == pytest.approx(surface, abs=1e-12)
    found = fit.heights(slope_x, slope_y)
    assert np.ptp(found - heights) < 1e-6


def test_rotational_slopes_are_fitted_by_least_squares():
    net = ControlNet((12, 12), (3, 3), (1.0, 1.0))
    places = (np.arange(48) + 0.5) / 48
    x = 2 * places - 1
    slope_x, slope_y = np.broadcast_arrays(-x[None, :], x[:, None])
    found = SlopeFit(net, 48).heights(slope_x, slope_y)
    _, made_x, made_y = net.grid(places, places).evaluate(found)
    # The best face is not zero on a square, but it is perpendicular to what is left.
    left = ((slope_x - made_x) * made_x + (slope_y - made_y) * made_y).mean()
    assert left == pytest.approx(0.0, abs=1e-9)
    assert np.mean((slope_x - made_x) ** 2 + (slope_y - made_y) ** 2) > 0.05
