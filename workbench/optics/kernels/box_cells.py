"""From hits of a grid of rays to boxes, some cells of a row at a time; and the adjoint.

See `workbench.optics.boxes` for what a box is. Along columns and along rows its interval comes from
the four hits of its cell in the same way. With sums s and differences d of the hits of two
neighbouring rows of rays, for the cell from ray j to ray j + 1 of both,

    c = (s_j + s_j+1) / 4,  a = (s_j+1 − s_j) / 2,  b = (d_j + d_j+1) / 2,  w² = a² + b²,

and the interval goes from c − w/2 to c + w/2. All loops vectorise.
"""

import math

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST

# Rays of a batch, one more than its cells: its numbers fit into the first-level cache.
RAYS = 128
# No box is narrower, in pixels: all light in a point would be so dense that sums over the image,
# see `workbench.optics.kernels.box_raster`, lose digits.
NARROWEST = 1 / 64

_ONE = np.uintp(1)
# Numbers, in float64. Those of an interval: a and b; its ends; the pixels in which these are, once
# they are moved into the image, and how far behind the beginning of these; 1 / w. Then for the way
# back how much more cotangent is at its end than at its beginning, and at both than within.
_A, _B, LOW, HIGH, LOW_PIXEL, HIGH_PIXEL, LOW_PART, HIGH_PART, BY_WIDTH, MORE, OUTER = (
    np.uintp(RAYS * k) for k in range(11)
)
# Numbers of a batch: both intervals, flux of the boxes, the cotangent's mean within; free room.
X, Y, FLUX, MEAN, _FIRST, _SECOND, _THIRD, END = (
    np.uintp(RAYS * k) for k in (0, 11, 22, 23, 24, 25, 26, 27)
)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _find_interval(hits, i, j, lanes, axis, t):  # type: ignore[no-untyped-def]
    """Intervals of a batch along one axis; no numbers where a ray hits nowhere."""
    here, there = hits[i, j:], hits[i + _ONE, j:]
    for lane in range(lanes + _ONE):
        low, high = np.float64(here[lane]), np.float64(there[lane])
        t[_FIRST + lane] = low + high
        t[_SECOND + lane] = high - low
    for lane in range(lanes):
        before, behind = t[_FIRST + lane], t[_FIRST + lane + _ONE]
        a = 0.5 * (behind - before)
        b = 0.5 * (t[_SECOND + lane] + t[_SECOND + lane + _ONE])
        width = math.sqrt(a * a + b * b)
        narrow = width < NARROWEST  # and stays as it is, whatever the cell does
        width = NARROWEST if narrow else width
        middle = 0.25 * (before + behind)
        low, high = middle - 0.5 * width, middle + 0.5 * width
        t[axis + _A + lane] = 0.0 if narrow else a
        t[axis + _B + lane] = 0.0 if narrow else b
        t[axis + LOW + lane] = low
        t[axis + HIGH + lane] = high
        t[axis + BY_WIDTH + lane] = 1.0 / width


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _find_flux(flux, parts, i, j, lanes, t):  # type: ignore[no-untyped-def]
    """Flux of the cells of a batch."""
    along_u, along_v = parts
    here, there = flux[i, j:], flux[i + _ONE, j:]
    low, high = along_u[1, i], along_u[0, i + _ONE]
    for lane in range(lanes + _ONE):
        t[_FIRST + lane] = low * here[lane] + high * there[lane]
    behind, before = along_v[1, j:], along_v[0, j + _ONE :]
    for lane in range(lanes):
        first, second = t[_FIRST + lane], t[_FIRST + lane + _ONE]
        t[FLUX + lane] = behind[lane] * first + before[lane] * second


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _leave_out(lanes, t):  # type: ignore[no-untyped-def]
    """Make the flux of cells 0 of which a ray hits nowhere; gives all other flux."""
    total = 0.0
    for lane in range(lanes):
        lands = abs(t[X + LOW + lane]) + abs(t[Y + LOW + lane]) < np.inf
        flux = t[FLUX + lane]
        flux = flux if lands else 0.0
        t[FLUX + lane] = flux
        t[_FIRST + lane] = 1.0 if lands else 0.0
        total += flux
    return total


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _place(lanes, last, axis, t):  # type: ignore[no-untyped-def]
    """Pixels in which ends of intervals are, moved into the image; any of cells left out."""
    for lane in range(lanes):
        lands = t[_FIRST + lane] > 0.0
        a, b, by_width = t[axis + _A + lane], t[axis + _B + lane], t[axis + BY_WIDTH + lane]
        low, high = t[axis + LOW + lane], t[axis + HIGH + lane]
        low, high = low if lands else 0.0, high if lands else 0.0
        t[axis + _A + lane] = a if lands else 0.0
        t[axis + _B + lane] = b if lands else 0.0
        t[axis + BY_WIDTH + lane] = by_width if lands else 0.0
        t[axis + LOW + lane] = low
        t[axis + HIGH + lane] = high
        low, high = min(max(low, 0.0), last), min(max(high, 0.0), last)
        t[axis + LOW_PIXEL + lane] = np.floor(low)
        t[axis + LOW_PART + lane] = low - np.floor(low)
        t[axis + HIGH_PIXEL + lane] = np.floor(high)
        t[axis + HIGH_PART + lane] = high - np.floor(high)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def find_boxes(hits, flux, parts, i, j, lanes, pixels, t):  # type: ignore[no-untyped-def]
    """Find the boxes of a batch of cells.

    Parameters
    ----------
    hits : array, shape (2, n, m)
        Columns and rows in which rays hit, infinite for those that never do.
    flux : array, shape (n, m)
        Of the rays; see `workbench.optics.beams.beam_image`.
    parts : tuple of two arrays, shape (2, n) and (2, m)
        Which parts of it belong to the cells before and behind, along both axes.
    i, j : uintp
        First ray of the first cell.
    lanes : uintp
        Number of cells, below ``RAYS``.
    pixels : tuple of two int
        (n_x, n_y).
    t : array, shape (END,), float64
        The result.

    Returns
    -------
    float64
        Their flux; cells of which a ray hits nowhere have none.
    """
    _find_interval(hits[0], i, j, lanes, X, t)
    _find_interval(hits[1], i, j, lanes, Y, t)
    _find_flux(flux, parts, i, j, lanes, t)
    total = _leave_out(lanes, t)
    _place(lanes, np.float64(pixels[0]), X, t)
    _place(lanes, np.float64(pixels[1]), Y, t)
    return total


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _interval_back(d_hits, i, j, lanes, axis, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_find_interval`: adds to the cotangents of the hits.

    With X_0 and X_1 the means of the cotangent at both ends of an interval, and S that within, a
    flux F lets its middle have the cotangent F (X_1 − X_0) / w, and its width
    F ((X_0 + X_1) / 2 − S) / w.
    """
    for lane in range(lanes):
        by_width = t[axis + BY_WIDTH + lane]
        light = t[FLUX + lane] * by_width
        by_sides = 0.5 * light * t[axis + OUTER + lane] * by_width
        t[_FIRST + lane] = 0.25 * light * t[axis + MORE + lane]
        t[_SECOND + lane] = by_sides * t[axis + _A + lane]
        t[_THIRD + lane] = by_sides * t[axis + _B + lane]
    here, there = d_hits[i, j:], d_hits[i + _ONE, j:]
    for lane in range(lanes):
        middle, along, across = t[_FIRST + lane], t[_SECOND + lane], t[_THIRD + lane]
        here[lane] += middle - along - across
        there[lane] += middle - along + across
    for lane in range(lanes):
        middle, along, across = t[_FIRST + lane], t[_SECOND + lane], t[_THIRD + lane]
        here[lane + _ONE] += middle + along - across
        there[lane + _ONE] += middle + along + across


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def boxes_back(parts, i, j, lanes, t, d_hits, d_flux):  # type: ignore[no-untyped-def]
    """Adjoint of `find_boxes`.

    Parameters
    ----------
    parts, i, j, lanes
        As there.
    t : array, shape (END,)
        What it found, with ``MEAN``, ``MORE`` and ``OUTER``.
    d_hits, d_flux : array, shape (2, n, m) and (n, m)
        Cotangents of the rays; changed.
    """
    _interval_back(d_hits[0], i, j, lanes, X, t)
    _interval_back(d_hits[1], i, j, lanes, Y, t)
    along_u, along_v = parts
    low, high = along_u[1, i], along_u[0, i + _ONE]
    here, there = d_flux[i, j:], d_flux[i + _ONE, j:]
    behind, before = along_v[1, j:], along_v[0, j + _ONE :]
    for lane in range(lanes):
        d_flux_there = t[MEAN + lane] * behind[lane]
        here[lane] += low * d_flux_there
        there[lane] += high * d_flux_there
    for lane in range(lanes):
        d_flux_there = t[MEAN + lane] * before[lane]
        here[lane + _ONE] += low * d_flux_there
        there[lane + _ONE] += high * d_flux_there
