"""Random errors of a face."""

import math
from dataclasses import replace

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline
from scipy.ndimage import gaussian_filter

from workbench.arrays import Array
from workbench.geometry.surface import ControlNet

_SPANS = 4  # knot spans per length of the noise, enough for any degree


def with_noise(
    net: ControlNet, control_points: Array, amplitude: float, scale: float, rng: np.random.Generator
) -> Array:
    """Return control heights of a face with a random error, on a net as fine as the error needs.

    `amplitude`: RMS of the error about its mean, scene units; `scale`: correlation length, as in
    exp(−r² / scale²), from `tolerance_fields.FINEST` of the lens's width up to its width.
    """
    for axis, (r, n, p) in enumerate(zip(net.half_width, net.shape, net.degree, strict=True)):
        split = math.ceil(_SPANS * 2 * r / (scale * (n - p)))
        control_points = _refined(control_points, axis, r, p, split)
    finer = replace(net, shape=control_points.shape)
    return control_points + amplitude * _noise(finer, scale, rng)


def _refined(control_points: Array, axis: int, half_width: float, degree: int, split: int) -> Array:
    """Split each knot span along an axis evenly; the face stays the same."""
    spans = control_points.shape[axis] - degree
    coarse, fine = (_knots(half_width, count, degree) for count in (spans, spans * split))
    face = BSpline(coarse, np.moveaxis(control_points, axis, 0), degree)
    # The spline on the finer knots that interpolates the face is the face.
    places = np.array([fine[i + 1 : i + degree + 1].mean() for i in range(len(fine) - degree - 1)])
    places = places.clip(-half_width, half_width)  # which means miss by rounding
    finer = make_interp_spline(places, face(places), degree, t=fine).c
    return np.ascontiguousarray(np.moveaxis(finer, 0, axis))


def _noise(net: ControlNet, scale: float, rng: np.random.Generator) -> Array:
    """Control heights of a random face with mean 0 and RMS 1."""
    samplers, widths = [], []
    for r, n, p in zip(net.half_width, net.shape, net.degree, strict=True):
        knots = _knots(r, n - p, p)
        middles = (np.arange(4 * (n - p)) + 0.5) * (r / (2 * (n - p))) - r
        samplers.append(BSpline(knots, np.eye(n), p)(middles))
        # White noise after a Gaussian filter of σ has the correlation exp(−r² / 4σ²).
        widths.append(scale / 2 / (2 * r / (n - p)))
    # Filtered beyond the edge, so that the noise is stationary there.
    margins = [min(math.ceil(4 * width), n) for width, n in zip(widths, net.shape, strict=True)]
    size = [n + 2 * m for n, m in zip(net.shape, margins, strict=True)]
    white = gaussian_filter(rng.standard_normal(size), widths, mode="wrap")
    heights = white[margins[0] : size[0] - margins[0], margins[1] : size[1] - margins[1]]
    surface = samplers[0] @ heights @ samplers[1].T
    return np.asarray((heights - surface.mean()) / surface.std())


def _knots(half_width: float, spans: int, degree: int) -> Array:
    ends = np.full(degree, half_width)
    return np.concatenate([-ends, np.linspace(-half_width, half_width, spans + 1), ends])
