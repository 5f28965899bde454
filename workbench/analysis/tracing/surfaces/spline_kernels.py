"""The loop over rays that meet a B-spline."""

import math
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit

# Looks for a change of sign per knot span, along rays that may meet the face more than once.
_LOOKS = 16
# Steps of the false position, which needs some ten, and then halves what is left.
_STEPS = 100


class Spline(NamedTuple):
    """The face as numbers.

    Attributes
    ----------
    control : ndarray, shape (n_u, n_v)
        Control heights.
    along_x, along_y : ndarray, shape (spans, p + 1, p + 1)
        Polynomial coefficients, highest power first, of the p + 1 basis functions on each knot
        span; their variable runs over a span from 0 to 1.
    r_x, r_y : float
        Half-widths of the aperture.
    density_x, density_y : float
        Knot spans per length.
    lowest, highest : float
        Lowest and highest control height.
    steepest_x, steepest_y : float
        Bounds of the face's slopes.
    curved : bool
        Whether the aperture is an ellipse, not a rectangle.
    """

    control: Array
    along_x: Array
    along_y: Array
    r_x: float
    r_y: float
    density_x: float
    density_y: float
    lowest: float
    highest: float
    steepest_x: float
    steepest_y: float
    curved: bool


@jit(error_model="numpy")
def meet(  # type: ignore[no-untyped-def]
    spline, position, direction, flux, place, normal, met
):
    """Find where rays first meet the face.

    Parameters
    ----------
    spline : Spline
        The face.
    position, direction, flux
        The rays, upwards; see `workbench.analysis.tracing.elements.TracedRays`.
    place, normal : array, shape (m, 3)
        Get where rays meet the face, and its upper unit normal there; the columns of other rays are
        left as they are.
    met : array, shape (m,)
        Gets the flux of the rays that meet it, 0 for the others, which leave the lens at its side.
    """
    basis = np.empty((2, 8))
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        met[ray] = 0.0
        if flux[ray] == 0:
            continue
        x, y, z = position[ray, 0], position[ray, 1], position[ray, 2]
        k = ray * step
        d_x, d_y, d_z = direction[k, 0], direction[k, 1], direction[k, 2]
        if d_x != 0 or d_y != 0:
            rise = _meet(spline, x, y, z, d_x / d_z, d_y / d_z, basis)
            if rise == -math.inf:
                continue
            x += d_x / d_z * rise
            y += d_y / d_z * rise
        met[ray] = flux[ray]
        height, slope_x, slope_y = _surface(spline, x, y, basis)
        n_z = 1 / math.sqrt(slope_x * slope_x + slope_y * slope_y + 1)
        place[ray, 0], place[ray, 1], place[ray, 2] = x, y, height
        normal[ray, 0], normal[ray, 1], normal[ray, 2] = -slope_x * n_z, -slope_y * n_z, n_z


@jit(error_model="numpy")
def surface(spline, x, y, height, slope_x, slope_y):  # type: ignore[no-untyped-def]
    """Get heights and slopes at places; all arrays of shape (m,)."""
    basis = np.empty((2, 8))
    for k in range(len(x)):
        height[k], slope_x[k], slope_y[k] = _surface(spline, x[k], y[k], basis)


@jit(error_model="numpy", inline="always")  # a call costs as much
def _span_of(place, half_width, density, spans):  # type: ignore[no-untyped-def]
    """Number of the knot span of a place, and how far it is through it: 0 to 1."""
    scaled = (place + half_width) * density
    span = min(max(int(scaled), 0), spans - 1)
    return span, min(max(scaled - span, 0.0), 1.0)  # 1 at the far edge: the last span's


@jit(error_model="numpy", inline="always")  # a call costs as much
def _surface(spline, x, y, basis):  # type: ignore[no-untyped-def]
    """Height and slopes of the face; ``basis`` is room for two kinds of values."""
    column, local_x = _span_of(x, spline.r_x, spline.density_x, len(spline.along_x))
    row, local_y = _span_of(y, spline.r_y, spline.density_y, len(spline.along_y))
    for j in range(spline.along_y.shape[1]):
        value, slope = spline.along_y[row, j, 0], 0.0
        for power in range(1, spline.along_y.shape[1]):
            slope = slope * local_y + value
            value = value * local_y + spline.along_y[row, j, power]
        basis[0, j], basis[1, j] = value, slope
    height = slope_x = slope_y = 0.0
    for i in range(spline.along_x.shape[1]):
        value, slope = spline.along_x[column, i, 0], 0.0
        for power in range(1, spline.along_x.shape[1]):
            slope = slope * local_x + value
            value = value * local_x + spline.along_x[column, i, power]
        across = across_slope = 0.0
        for j in range(spline.along_y.shape[1]):
            across += spline.control[column + i, row + j] * basis[0, j]
            across_slope += spline.control[column + i, row + j] * basis[1, j]
        height += across * value
        slope_x += across * slope
        slope_y += across_slope * value
    return height, slope_x * spline.density_x, slope_y * spline.density_y


@jit(error_model="numpy", inline="always")  # a call costs as much
def _height(spline, x, y, basis):  # type: ignore[no-untyped-def]
    """Height of the face alone."""
    column, local_x = _span_of(x, spline.r_x, spline.density_x, len(spline.along_x))
    row, local_y = _span_of(y, spline.r_y, spline.density_y, len(spline.along_y))
    for j in range(spline.along_y.shape[1]):
        value = spline.along_y[row, j, 0]
        for power in range(1, spline.along_y.shape[1]):
            value = value * local_y + spline.along_y[row, j, power]
        basis[0, j] = value
    height = 0.0
    for i in range(spline.along_x.shape[1]):
        value = spline.along_x[column, i, 0]
        for power in range(1, spline.along_x.shape[1]):
            value = value * local_x + spline.along_x[column, i, power]
        across = 0.0
        for j in range(spline.along_y.shape[1]):
            across += spline.control[column + i, row + j] * basis[0, j]
        height += across * value
    return height


@jit(error_model="numpy", inline="always")  # a call costs as much
def _over(spline, x, y, z, slope_x, slope_y, rise, basis):  # type: ignore[no-untyped-def]
    """How far a ray is below the face; both at the aperture's edge if it has passed that."""
    return _height(spline, x + slope_x * rise, y + slope_y * rise, basis) - z - rise


@jit(error_model="numpy")
def _room(half_width, place, slope):  # type: ignore[no-untyped-def]
    """Rise of a ray up to the lens's side."""
    if slope == 0:
        return math.inf
    return (half_width - place if slope > 0 else half_width + place) / abs(slope)


@jit(error_model="numpy")
def _side(spline, x, y, slope_x, slope_y):  # type: ignore[no-untyped-def]
    """Rise of an inclined ray up to the lens's side."""
    if not spline.curved:
        return min(_room(spline.r_x, x, slope_x), _room(spline.r_y, y, slope_y))
    # Where the ray leaves the unit circle: a t² + 2 b t = c, with c not negative within.
    x, y = x / spline.r_x, y / spline.r_y
    slope_x, slope_y = slope_x / spline.r_x, slope_y / spline.r_y
    a, b = slope_x * slope_x + slope_y * slope_y, x * slope_x + y * slope_y
    c = max(1 - x * x - y * y, 0.0)
    root = math.sqrt(b * b + a * c)
    return c / (root + b) if b > 0 else (root - b) / a


@jit(error_model="numpy")
def _meet(spline, x, y, z, slope_x, slope_y, basis):  # type: ignore[no-untyped-def]
    """Rise of an inclined ray to where it first meets the face; −∞ if it leaves at the side."""
    side = _side(spline, x, y, slope_x, slope_y)
    slack = 1e-13 * spline.highest
    low = min(side, spline.lowest - z - slack)
    high = min(side, spline.highest - z + slack)
    at_high = _over(spline, x, y, z, slope_x, slope_y, high, basis)
    # A face that climbs slower than a ray is met but once; else the ray looks on its way.
    climb = abs(slope_x) * spline.steepest_x + abs(slope_y) * spline.steepest_y
    if climb >= 1:
        spans_x = abs(slope_x) * spline.density_x
        spans_y = abs(slope_y) * spline.density_y
        width = (high - low) / (_LOOKS * (2 + int((spans_x + spans_y) * (high - low))))
        here, value = low, _over(spline, x, y, z, slope_x, slope_y, low, basis)
        while value > 0 and here < high:
            low = here
            # The face comes no closer than this climb allows: nothing is passed over.
            here = min(here + max(value / (1 + climb), width), high)
            value = _over(spline, x, y, z, slope_x, slope_y, here, basis)
        if value <= 0:
            high, at_high = here, value
    if side <= spline.lowest - z or at_high > 0:
        return -math.inf
    at_low = _over(spline, x, y, z, slope_x, slope_y, low, basis)
    return _false_position(spline, x, y, z, slope_x, slope_y, low, high, at_low, at_high, basis)


@jit(error_model="numpy")
def _false_position(  # type: ignore[no-untyped-def]
    spline, x, y, z, slope_x, slope_y, low, high, at_low, at_high, basis
):
    """Rise between low, below the face, and high, not below it: the Illinois algorithm."""
    kept = 0  # +1: the upper end stayed, −1: the lower one
    middle = high
    for step in range(_STEPS):
        share = 0.5
        if step % 8 < 7:
            share = at_low / (at_low - at_high) if at_low > max(at_high, 0.0) else 0.0
        middle = low + share * (high - low)
        value = _over(spline, x, y, z, slope_x, slope_y, middle, basis)
        if abs(value) <= 1e-14 * abs(high):
            break
        # An end that stays twice counts half: else it would stay for ever.
        if value > 0:
            at_high = at_high / 2 if kept == 1 else at_high
            low, at_low, kept = middle, value, 1
        else:
            at_low = at_low / 2 if kept == -1 else at_low
            high, at_high, kept = middle, value, -1
    return middle
