"""Loops of the independent trace over rays: where they meet the exit face, how they leave it.

Only float64, one ray at a time, and nothing shared with `workbench.optics`.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.compiled import jit

Array = npt.NDArray[np.float64]

# What becomes of a ray at the exit face.
LEFT_SIDE, REFLECTED, PASSES = 0, 1, 2
# Looks for a change of sign per knot span, along rays that may meet the face more than once.
_LOOKS = 16
# Steps of the false position, which needs some ten, and then halves what is left.
_STEPS = 100


class Spline(NamedTuple):
    """The exit face as numbers.

    Attributes
    ----------
    control : ndarray, shape (n_u, n_v)
        Control heights above the entrance face.
    along_x, along_y : ndarray, shape (spans, p + 1, p + 1)
        Polynomial coefficients, highest power first, of the p + 1 basis functions on each knot
        span; their variable runs over a span from 0 to 1.
    r_x, r_y : float
        Half-widths of the aperture.
    density_x, density_y : float
        Knot spans per length.
    entrance : float
        z of the entrance face.
    lowest, highest : float
        Lowest and highest control height above the entrance face.
    steepest_x, steepest_y : float
        Bounds of the face's slopes.
    refractive_index : float
        Of the lens.
    """

    control: Array
    along_x: Array
    along_y: Array
    r_x: float
    r_y: float
    density_x: float
    density_y: float
    entrance: float
    lowest: float
    highest: float
    steepest_x: float
    steepest_y: float
    refractive_index: float


@jit(error_model="numpy")
def heights_at(spline, places, found):  # type: ignore[no-untyped-def]
    """Heights (m,) of the face above the entrance face at places (m, 2)."""
    basis = np.empty((2, 8))
    for ray in range(len(places)):
        found[ray] = _height(spline, places[ray, 0], places[ray, 1], basis)


@jit(error_model="numpy")
def follow(spline: Any, start: Any, direction: Any, leaving: Any, fate: Any) -> None:
    """Follow rays from the entrance face through the exit face.

    Parameters
    ----------
    spline : Spline
        The face.
    start : array, shape (m, 2)
        Where the rays begin on the entrance face.
    direction : array, shape (m, 3)
        Unit vectors in the lens, upwards.
    leaving : array, shape (7, m)
        Gets x, y, z where they meet the exit face, the unit vector behind it, and its reflectance.
        What does not pass is left as it is.
    fate : array of int8, shape (m,)
        Gets what becomes of each ray.
    """
    index = spline.refractive_index
    head_on = ((index - 1) / (index + 1)) ** 2
    basis = np.empty((2, 8))
    for ray in range(len(start)):
        x, y = start[ray, 0], start[ray, 1]
        d_x, d_y, d_z = direction[ray, 0], direction[ray, 1], direction[ray, 2]
        if d_x != 0 or d_y != 0:
            rise = _meet(spline, x, y, d_x / d_z, d_y / d_z, basis)
            if rise == -math.inf:
                fate[ray] = LEFT_SIDE
                continue
            x += d_x / d_z * rise
            y += d_y / d_z * rise
        height, slope_x, slope_y = _surface(spline, x, y, basis)
        n_z = 1 / math.sqrt(slope_x * slope_x + slope_y * slope_y + 1)
        n_x, n_y = -slope_x * n_z, -slope_y * n_z
        # Snell's law enlarges the angle between ray and normal, in the plane that holds both.
        along = d_x * n_x + d_y * n_y + d_z * n_z
        a_x, a_y, a_z = d_x - along * n_x, d_y - along * n_y, d_z - along * n_z
        sine = index * math.sqrt(a_x * a_x + a_y * a_y + a_z * a_z)
        if sine >= 1 or along <= 0:
            fate[ray] = REFLECTED
            continue
        fate[ray] = PASSES
        cosine = math.cos(math.asin(sine))
        leaving[0, ray], leaving[1, ray], leaving[2, ray] = x, y, height + spline.entrance
        leaving[3, ray] = cosine * n_x + index * a_x
        leaving[4, ray] = cosine * n_y + index * a_y
        leaving[5, ray] = cosine * n_z + index * a_z
        leaving[6, ray] = head_on + (1 - head_on) * (1 - cosine) ** 5


@jit(error_model="numpy")
def land(leaving, fate, flux, turn, shift, planes, scale, pixels, image, off_screen, lost):  # type: ignore[no-untyped-def]
    """Count the rays that `follow` has followed in the pixels that they hit.

    Parameters
    ----------
    leaving, fate
        What `follow` has found.
    flux : array, shape (m,)
        Flux of each ray in the lens.
    turn, shift : array, shapes (3, 3) and (3,)
        From the lens to the scene.
    planes : array, shape (k,)
        Where screens are, z.
    scale : array, shape (2, 2)
        Column of x and row of y: factor and what is added.
    pixels : tuple[int, int]
        Along x and y.
    image : array, shape (k, n_y n_x)
        Gets the flux of the pixels added.
    off_screen : array, shape (k,)
        Gets the flux beside each screen added.
    lost : array, shape (3,)
        Gets added: flux that left the side, was totally reflected, was reflected in part.
    """
    n_x, n_y = pixels
    for ray in range(len(flux)):
        if fate[ray] != PASSES:
            lost[fate[ray]] += flux[ray]
            continue
        reflected = flux[ray] * leaving[6, ray]
        lost[2] += reflected
        x, y, z = leaving[0, ray], leaving[1, ray], leaving[2, ray]
        d_x, d_y, d_z = leaving[3, ray], leaving[4, ray], leaving[5, ray]
        from_x = turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z + shift[0]
        from_y = turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z + shift[1]
        from_z = turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z + shift[2]
        to_x = turn[0, 0] * d_x + turn[0, 1] * d_y + turn[0, 2] * d_z
        to_y = turn[1, 0] * d_x + turn[1, 1] * d_y + turn[1, 2] * d_z
        to_z = turn[2, 0] * d_x + turn[2, 1] * d_y + turn[2, 2] * d_z
        for plane in range(len(planes)):
            path = (planes[plane] - from_z) / to_z if to_z > 0 else math.inf
            column = scale[0, 0] * (from_x + to_x * path) + scale[0, 1]
            row = scale[1, 0] * (from_y + to_y * path) + scale[1, 1]
            # Also not a number, of a ray along the screen, is not in there.
            if 0 <= column < n_x and 0 <= row < n_y:
                image[plane, int(row) * n_x + int(column)] += flux[ray] - reflected
            else:
                off_screen[plane] += flux[ray] - reflected


@jit(error_model="numpy", inline="always")  # a call costs as much
def _span_of(place, half_width, density, spans):  # type: ignore[no-untyped-def]
    """Number of the knot span of a place, and how far it is through it: 0 to 1."""
    scaled = (place + half_width) * density
    span = min(max(int(scaled), 0), spans - 1)
    return span, min(max(scaled - span, 0.0), 1.0)  # 1 at the far edge: the last span's


@jit(error_model="numpy", inline="always")  # a call costs as much
def _surface(spline, x, y, basis):  # type: ignore[no-untyped-def]
    """Height and slopes of the face; ``basis`` is room for two kinds of values."""
    column, part_x = _span_of(x, spline.r_x, spline.density_x, len(spline.along_x))
    row, part_y = _span_of(y, spline.r_y, spline.density_y, len(spline.along_y))
    for j in range(spline.along_y.shape[1]):
        value, slope = spline.along_y[row, j, 0], 0.0
        for power in range(1, spline.along_y.shape[1]):
            slope = slope * part_y + value
            value = value * part_y + spline.along_y[row, j, power]
        basis[0, j], basis[1, j] = value, slope
    height = slope_x = slope_y = 0.0
    for i in range(spline.along_x.shape[1]):
        value, slope = spline.along_x[column, i, 0], 0.0
        for power in range(1, spline.along_x.shape[1]):
            slope = slope * part_x + value
            value = value * part_x + spline.along_x[column, i, power]
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
    column, part_x = _span_of(x, spline.r_x, spline.density_x, len(spline.along_x))
    row, part_y = _span_of(y, spline.r_y, spline.density_y, len(spline.along_y))
    for j in range(spline.along_y.shape[1]):
        value = spline.along_y[row, j, 0]
        for power in range(1, spline.along_y.shape[1]):
            value = value * part_y + spline.along_y[row, j, power]
        basis[0, j] = value
    height = 0.0
    for i in range(spline.along_x.shape[1]):
        value = spline.along_x[column, i, 0]
        for power in range(1, spline.along_x.shape[1]):
            value = value * part_x + spline.along_x[column, i, power]
        across = 0.0
        for j in range(spline.along_y.shape[1]):
            across += spline.control[column + i, row + j] * basis[0, j]
        height += across * value
    return height


@jit(error_model="numpy", inline="always")  # a call costs as much
def _over(spline, x, y, slope_x, slope_y, rise, basis):  # type: ignore[no-untyped-def]
    """How far a ray is below the face; both at the aperture's edge if it has passed that."""
    return _height(spline, x + slope_x * rise, y + slope_y * rise, basis) - rise


@jit(error_model="numpy")
def _room(half_width, place, slope):  # type: ignore[no-untyped-def]
    """Rise of a ray up to the lens's side."""
    if slope == 0:
        return math.inf
    return (half_width - place if slope > 0 else half_width + place) / abs(slope)


@jit(error_model="numpy")
def _meet(spline, x, y, slope_x, slope_y, basis):  # type: ignore[no-untyped-def]
    """Rise of an inclined ray to where it first meets the face; −∞ if it leaves at the side."""
    side = min(_room(spline.r_x, x, slope_x), _room(spline.r_y, y, slope_y))
    slack = 1e-13 * spline.highest
    low, high = min(side, spline.lowest - slack), min(side, spline.highest + slack)
    at_high = _over(spline, x, y, slope_x, slope_y, high, basis)
    # A face that climbs slower than a ray is met but once; else the ray looks on its way.
    if abs(slope_x) * spline.steepest_x + abs(slope_y) * spline.steepest_y >= 1:
        spans_x = abs(slope_x) * spline.density_x
        spans_y = abs(slope_y) * spline.density_y
        looks = _LOOKS * (2 + int((spans_x + spans_y) * (high - low)))
        bottom, width = low, (high - low) / looks
        for look in range(1, looks):
            here = bottom + look * width
            value = _over(spline, x, y, slope_x, slope_y, here, basis)
            if value <= 0:
                high, at_high = here, value
                break
            low = here
    if side <= spline.lowest or at_high > 0:
        return -math.inf
    at_low = _over(spline, x, y, slope_x, slope_y, low, basis)
    return _false_position(spline, x, y, slope_x, slope_y, low, high, at_low, at_high, basis)


@jit(error_model="numpy")
def _false_position(  # type: ignore[no-untyped-def]
    spline, x, y, slope_x, slope_y, low, high, at_low, at_high, basis
):
    """Rise between low, below the face, and high, not below it: the Illinois algorithm."""
    kept = 0  # +1: the upper end stayed, −1: the lower one
    middle = high
    for step in range(_STEPS):
        share = 0.5
        if step % 8 < 7:
            share = at_low / (at_low - at_high) if at_low > max(at_high, 0.0) else 0.0
        middle = low + share * (high - low)
        value = _over(spline, x, y, slope_x, slope_y, middle, basis)
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
