"""Lenses of given shapes, and steps of their checks."""

from scipy.interpolate import make_interp_spline

from workbench.geometry.surface import ControlNet
from workbench.progress import finished


def net_of(scene, height):
    """Control heights of the spline that interpolates a height function."""
    net = ControlNet.of(scene.optic)
    (x, y), (p, q), (r_x, r_y) = net.positions, scene.optic.degree, scene.optic.half_width
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, (r_x, r_y), strict=True)]
    values = height(x[:, None], y[None, :])
    values = make_interp_spline(x, values, p, t=knots[0]).c
    return make_interp_spline(y, values.T, q, t=knots[1]).c.T.copy()


def followed(steps):
    """What steps return, whose progress goes from 0 to 1."""
    parts = [0.0]
    found = finished(steps, parts.append)
    assert parts == sorted(parts) and parts[-1] <= 1
    return found
