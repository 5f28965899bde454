"""Light of points: what tests of its rays and of samples of the exit face share."""

import numpy as np
import torch
from scipy.interpolate import make_interp_spline
from scipy.optimize import brentq

from workbench.geometry.surface import ControlNet

INDEX = 1.5
POINT = {"kind": "point", "position": [0.3, -0.2, -5.0], "rays": 4096}
GRID = {"kind": "grid", "center": [0, 0.1, -5], "half_width": [1, 1], "points": [5, 4], "rays": 200}
DTYPES = [torch.float32, torch.float64]

OVAL = {"lens.control_points": [60, 50], "lens.degree": [5, 5]}
OVAL_DISTANCE = 3.0  # of its point
_VERTEX, _FOCUS = 0.6, 5.0

THIN_PLATE = {
    "lens.base": {"shape": "flat", "height": 1e-6},
    "lens.height_range": [-1e-6, 1e-6],
    "lens.min_thickness": 0,
    "screen.z": 1.0,
    "filter": {"kind": "box"},
    "screen.pixels": [10, 10],
}


def smooth(scene, amplitude=0.05):
    """A lens of soft waves, which keeps rays away from the rim of its side."""
    net = ControlNet.of(scene.optic)
    x, y = (torch.as_tensor(c) for c in net.positions)
    return 0.5 + amplitude * torch.sin(3 * x[:, None] + 1) * torch.cos(2 * y[None, :])


def interpolating(net, height):
    """Control heights of the spline that interpolates a height function."""
    (x, y), (p, q) = net.positions, net.degree
    knots = [(2 * k - 1) * r for k, r in zip(net.knots, net.half_width, strict=True)]
    values = height(x[:, None], y[None, :])
    values = make_interp_spline(x, values, p, t=knots[0], axis=0).c
    return torch.as_tensor(make_interp_spline(y, values.T, q, t=knots[1], axis=0).c.T.copy())


def oval(net):
    """Control heights of a face of equal optical paths: all light of a point in one point.

    It is found by its rays: a ray from (0, −d) that crosses the entrance face at radius ρ is
    refracted there; how far it goes in the glass is what makes its optical path to the focus
    that along the axis.
    """
    d, n = OVAL_DISTANCE, INDEX
    axial = d + n * _VERTEX + _FOCUS - _VERTEX
    radii, heights = [], []
    for rho in np.linspace(0, 1.7, 400):
        outer = np.arctan2(rho, d)
        inner = np.arcsin(np.sin(outer) / n)

        def path_difference(s, rho=rho, outer=outer, inner=inner):
            r, z = rho + s * np.sin(inner), s * np.cos(inner)
            return d / np.cos(outer) + n * s + np.hypot(r, _FOCUS - z) - axial

        s = brentq(path_difference, -2, 3, xtol=1e-15, rtol=1e-15)
        radii.append(rho + s * np.sin(inner))
        heights.append(s * np.cos(inner))
    # Even in the radius, so that it is smooth in x and y.
    radii, heights = np.array(radii), np.array(heights)
    even = np.concatenate([-radii[:0:-1], radii]), np.concatenate([heights[:0:-1], heights])
    profile = make_interp_spline(*even, k=7)
    return interpolating(net, lambda x, y: profile(np.hypot(x, y)))


def behind_thin_plate(scene, emission, power):
    """Flux in each pixel: a thin plate leaves the inverse square and the cosines."""
    edge = np.linspace(-1, 1, 10 * 40 + 1)
    centre = (edge[1:] + edge[:-1]) / 2
    cos = 2 / np.sqrt(4 + centre[:, None] ** 2 + centre[None, :] ** 2)
    share = 0.96 * (1 - (1 - cos) ** 5)
    profile = (cos**power * share**2).reshape(10, 40, 10, 40).mean(axis=(1, 3))
    # Intensity on the axis: 1 over the solid angle of the cap, or over that of its projection.
    rim = 1 / np.sqrt(3)
    whole = 2 * np.pi * (1 - rim) if emission == "uniform" else np.pi * (1 - rim**2)
    return profile * scene.receiver.pixel_measure / (whole * 4)
