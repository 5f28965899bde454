"""From hits of a grid of rays to boxes, some cells of a row at a time; and the adjoint.

See `workbench.optics.boxes` for what a box is. Along columns and along rows its interval comes from
the four hits p, q, r and s of its cell in the same way, p and q by rays of a row, r and s by those
behind them in the next one,

    c = (p + q + r + s) / 4,  a = (q − p + s − r) / 2,  b = (r − p + s − q) / 2,  w² = a² + b²,

and the interval goes from c − w/2 to c + w/2. All loops vectorise.
"""

import math

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST

# Rays of a batch, one more than its cells: its numbers fit into the first-level cache.
RAYS = 144
# No box is narrower, in pixels: all light in a point would be so dense that sums over the image,
# see `workbench.optics.kernels.box_raster`, lose digits.
NARROWEST = 1 / 64

_ONE = np.uintp(1)
# Numbers, in the float type of the hits. Those of an interval: a and b; the pixel in which its
# first hit is; its ends counted from there, then the pixels in which these are; the same once they
# are moved into the image, and how far behind the beginning of these; 1 / w. Then for the way back
# how much more cotangent is at its end than at its beginning, and at both than within.
_A, _B, _PIXEL, LOW, HIGH, LOW_PIXEL, HIGH_PIXEL, LOW_PART, HIGH_PART, BY_WIDTH, MORE, OUTER = (
    np.uintp(RAYS * k) for k in range(12)
)
# Numbers of a batch: both intervals, flux of the boxes, the cotangent's mean within; free room.
X, Y, FLUX, MEAN, _FIRST, _SECOND, _THIRD, END = (
    np.uintp(RAYS * k) for k in (0, 12, 24, 25, 26, 27, 28, 29)
)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _find_interval(hits, i, j, lanes, axis, t):  # type: ignore[no-untyped-def]
    """Intervals of a batch along one axis; no numbers where a ray hits nowhere.

    All is counted from the first hit, and from the pixel in which it is: far out in a large image
    float32 leaves narrow boxes few digits.
    """
    kind = t.dtype.type
    zero, quarter, half, one = kind(0), kind(0.25), kind(0.5), kind(1)
    narrowest, here, there = kind(NARROWEST), hits[i, j:], hits[i + _ONE, j:]
    for lane in range(lanes):
        first = here[lane]
        along, across, both = (
            here[lane + _ONE] - first,
            there[lane] - first,
            there[lane + _ONE] - first,
        )
        a, b = half * (along + (both - across)), half * (across + (both - along))
        width = math.sqrt(a * a + b * b)
        narrow = width < narrowest  # and stays as it is, whatever the cell does
        width = narrowest if narrow else width
        pixel, far = np.floor(first), half * width
        middle = (first - pixel) + quarter * (along + across + both)
        t[axis + _A + lane] = zero if narrow else a
        t[axis + _B + lane] = zero if narrow else b
        t[axis + _PIXEL + lane] = pixel
        t[axis + LOW + lane] = middle - far
        t[axis + HIGH + lane] = middle + far
        t[axis + BY_WIDTH + lane] = one / width


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
    kind = t.dtype.type
    zero, one, total = kind(0), kind(1), kind(0)
    for lane in range(lanes):
        lands = abs(t[X + LOW + lane]) + abs(t[Y + LOW + lane]) < kind(np.inf)
        flux = t[FLUX + lane]
        flux = flux if lands else zero
        t[FLUX + lane] = flux
        t[_FIRST + lane] = one if lands else zero
        total += flux
    return np.float64(total)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _place(lanes, last, axis, t):  # type: ignore[no-untyped-def]
    """Pixels in which ends of intervals are, moved into the image; any of cells left out."""
    zero = t.dtype.type(0)
    for lane in range(lanes):
        lands = t[_FIRST + lane] > zero
        a, b, by_width = t[axis + _A + lane], t[axis + _B + lane], t[axis + BY_WIDTH + lane]
        pixel = t[axis + _PIXEL + lane]
        low, high = t[axis + LOW + lane], t[axis + HIGH + lane]
        low, high, pixel = low if lands else zero, high if lands else zero, pixel if lands else zero
        t[axis + _A + lane] = a if lands else zero
        t[axis + _B + lane] = b if lands else zero
        t[axis + BY_WIDTH + lane] = by_width if lands else zero
        low_floor, high_floor = np.floor(low), np.floor(high)
        low_pixel, high_pixel = pixel + low_floor, pixel + high_floor
        t[axis + LOW + lane] = low_pixel
        t[axis + HIGH + lane] = high_pixel
        t[axis + LOW_PIXEL + lane] = min(max(low_pixel, zero), last)
        t[axis + HIGH_PIXEL + lane] = min(max(high_pixel, zero), last)
        low_inside = (low_pixel >= zero) & (low_pixel < last)
        high_inside = (high_pixel >= zero) & (high_pixel < last)
        t[axis + LOW_PART + lane] = low - low_floor if low_inside else zero
        t[axis + HIGH_PART + lane] = high - high_floor if high_inside else zero


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def find_boxes(hits, flux, parts, i, j, lanes, pixels, t):  # type: ignore[no-untyped-def]
    """Find the boxes of a batch of cells.

    `hits` (2, n, m): columns and rows in which rays hit, infinite for those that never do; `flux`
    (n, m): of the rays; see `workbench.optics.beams.beam_image`; `parts` (2, n) and (2, m): which
    parts of it belong to the cells before and behind, along both axes; `i`, `j`: first ray of the
    first cell; `lanes`: number of cells, below ``RAYS``; `pixels`: (n_x, n_y); `t` (END,): the
    result, in the float type of the hits. Returns their flux; cells of which a ray hits nowhere
    have none.
    """
    _find_interval(hits[0], i, j, lanes, X, t)
    _find_interval(hits[1], i, j, lanes, Y, t)
    _find_flux(flux, parts, i, j, lanes, t)
    total = _leave_out(lanes, t)
    kind = t.dtype.type
    _place(lanes, kind(pixels[0]), X, t)
    _place(lanes, kind(pixels[1]), Y, t)
    return total


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _interval_back(d_hits, i, j, lanes, axis, t):  # type: ignore[no-untyped-def]
    """Adjoint of `_find_interval`: adds to the cotangents of the hits.

    With X_0 and X_1 the means of the cotangent at both ends of an interval, and S that within, a
    flux F lets its middle have the cotangent F (X_1 − X_0) / w, and its width
    F ((X_0 + X_1) / 2 − S) / w.
    """
    half, quarter = t.dtype.type(0.5), t.dtype.type(0.25)
    for lane in range(lanes):
        by_width = t[axis + BY_WIDTH + lane]
        light = t[FLUX + lane] * by_width
        by_sides = half * light * t[axis + OUTER + lane] * by_width
        t[_FIRST + lane] = quarter * light * t[axis + MORE + lane]
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

    `parts`, `i`, `j`, `lanes`: as there; `t` (END,): what it found, with ``MEAN``, ``MORE`` and
    ``OUTER``; `d_hits`, `d_flux` (2, n, m) and (n, m): cotangents of the rays; changed.
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
