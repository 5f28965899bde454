"""Boxes from hits of a grid, and onto pixels, exactly, by their four corners; and the adjoint.

Along columns and along rows the interval of a box comes from the four hits p, q, r and s of its
cell, p and q by rays of a row, r and s by those behind them in the next one,

    c = (p + q + r + s) / 4,  a = (q − p + s − r) / 2,  b = (r − p + s − q) / 2,  w² = a² + b²,

and the interval goes from c − w/2 to c + w/2. The light of a box in a pixel is a product of the
parts of both intervals. Each part is a double sum: light begins at one end of an interval and stops
at the other. An end a part p behind the beginning of its pixel counts 1 − p there and p in the next
pixel. So a box of any size is four numbers at each corner: its density, and that times p along
columns, along rows, and along both. The sums are done once for all boxes. Ends beside the image are
moved to its border.

The adjoint uses sums of the cotangent from each place to the end of the image along both axes. They
are bilinear within a pixel: the four corners give the integral of the cotangent over a box, the
slopes there those along its sides. Large sums cancel: they are in float64, boxes in the float type
of the hits.
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
    (n, m): of the rays; see `beam_image`; `parts` (2, n) and (2, m): which
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


_ONE, _TWO, _THREE, _FOUR = (np.uintp(k) for k in range(1, 5))
# Where in the numbers of an image columns and rows begin in which ends of boxes are.
_LEFT, _RIGHT, _TOP, _BOTTOM, _ENDS = (np.uintp(RAYS * k) for k in range(5))


@jit(allocates=False, error_model="numpy", forceinline=True)
def _find_corners(lanes, row, t, at):  # type: ignore[no-untyped-def]
    """Where the corners of a batch of boxes are; ``row`` is how many numbers a row has."""
    for lane in range(lanes):
        at[_LEFT + lane] = np.uintp(np.int64(t[X + LOW_PIXEL + lane])) * _FOUR
        at[_RIGHT + lane] = np.uintp(np.int64(t[X + HIGH_PIXEL + lane])) * _FOUR
        at[_TOP + lane] = np.uintp(np.int64(t[Y + LOW_PIXEL + lane])) * row
        at[_BOTTOM + lane] = np.uintp(np.int64(t[Y + HIGH_PIXEL + lane])) * row


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _add_corner(here, density, part_x, part_y, corners):  # type: ignore[no-untyped-def]
    """Add one corner of a box."""
    by_y = density * part_y
    one, two = corners[here] + density, corners[here + _ONE] + density * part_x
    three, four = corners[here + _TWO] + by_y, corners[here + _THREE] + by_y * part_x
    corners[here] = one
    corners[here + _ONE] = two
    corners[here + _TWO] = three
    corners[here + _THREE] = four


@jit(fastmath=FAST, error_model="numpy")
def add_boxes(hits, flux, parts, corners):  # type: ignore[no-untyped-def]
    """Add the boxes of all cells of a grid of rays.

    `hits`, `flux`, `parts`: see `workbench.optics.kernels.box_raster.find_boxes`; `corners` (n_y +
    1, n_x + 1, 4): changed: the numbers at all corners; ends of boxes are in pixels up to n_y and
    n_x. Returns flux of all boxes, on the image or beside it.
    """
    pixels, row = (corners.shape[1] - 1, corners.shape[0] - 1), _FOUR * np.uintp(corners.shape[1])
    flat, t, at = corners.reshape(-1), np.empty(END, hits.dtype), np.empty(_ENDS, np.uintp)
    cells = flux.shape[1] - 1
    blocks = (cells + RAYS - 2) // (RAYS - 1)
    landed = 0.0
    for i in range(np.uintp(flux.shape[0] - 1)):
        for block in range(blocks):
            j, lanes = _batch(block, blocks, cells)
            landed += find_boxes(hits, flux, parts, i, j, lanes, pixels, t)
            _find_corners(lanes, row, t, at)
            for lane in range(lanes):
                left, right, top, bottom = _ends(lane, at)
                a, b, c, d = _parts(lane, t)
                density = np.float64(t[FLUX + lane]) * t[X + BY_WIDTH + lane]
                density *= t[Y + BY_WIDTH + lane]
                _add_corner(top + left, density, a, c, flat)
                _add_corner(top + right, -density, b, c, flat)
                _add_corner(bottom + left, -density, a, d, flat)
                _add_corner(bottom + right, density, b, d, flat)
    return landed


@jit(allocates=False, error_model="numpy", forceinline=True)
def _batch(block, blocks, cells):  # type: ignore[no-untyped-def]
    """First cell of a batch, and how many it has."""
    begin = cells * block // blocks
    return np.uintp(begin), np.uintp(cells * (block + 1) // blocks - begin)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _ends(lane, at):  # type: ignore[no-untyped-def]
    """Where the columns and rows begin in which the ends of a box are."""
    return at[_LEFT + lane], at[_RIGHT + lane], at[_TOP + lane], at[_BOTTOM + lane]


@jit(allocates=False, error_model="numpy", forceinline=True)
def _parts(lane, t):  # type: ignore[no-untyped-def]
    """How far behind the beginning of their pixels left, right, upper and lower ends are."""
    return (
        np.float64(t[X + LOW_PART + lane]),
        np.float64(t[X + HIGH_PART + lane]),
        np.float64(t[Y + LOW_PART + lane]),
        np.float64(t[Y + HIGH_PART + lane]),
    )


@jit(allocates=False, error_model="numpy", forceinline=True)
def _corner(here, sums):  # type: ignore[no-untyped-def]
    """A pixel's sum at its beginning, its slopes along columns and rows, and its twist."""
    return sums[here], sums[here + _ONE], sums[here + _TWO], sums[here + _THREE]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _see_box(lane, t, at, sums):  # type: ignore[no-untyped-def]
    """Means of the cotangent in one box and along its sides."""
    left, right, top, bottom = _ends(lane, at)
    a, b, c, d = _parts(lane, t)
    by_x, by_y = t[X + BY_WIDTH + lane], t[Y + BY_WIDTH + lane]
    k, k_x, k_y, k_xy = _corner(top + left, sums)
    l, l_x, l_y, l_xy = _corner(top + right, sums)  # noqa: E741
    m, m_x, m_y, m_xy = _corner(bottom + left, sums)
    n, n_x, n_y, n_xy = _corner(bottom + right, sums)
    # Slopes of the integral by the four ends; sums fall where the cotangent is positive.
    on_left, on_right = k_x + c * k_xy - m_x - d * m_xy, l_x + c * l_xy - n_x - d * n_xy
    on_top, on_bottom = k_y + a * k_xy - l_y - b * l_xy, m_y + a * m_xy - n_y - b * n_xy
    behind_left = k + c * k_y - m - d * m_y + a * on_left
    behind_right = l + c * l_y - n - d * n_y + b * on_right
    mean = (behind_left - behind_right) * by_x * by_y
    t[MEAN + lane] = mean
    _put(lane, X, -on_left * by_y, -on_right * by_y, mean, t)
    _put(lane, Y, -on_top * by_x, -on_bottom * by_x, mean, t)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _put(lane, axis, begin, end, mean, t):  # type: ignore[no-untyped-def]
    """Put what is seen at both ends of an interval; there is nothing before the image."""
    begin = begin if t[axis + LOW + lane] >= 0.0 else 0.0
    end = end if t[axis + HIGH + lane] >= 0.0 else 0.0
    t[axis + MORE + lane] = end - begin
    t[axis + OUTER + lane] = 0.5 * (begin + end) - mean


@jit(fastmath=FAST, error_model="numpy")
def see_boxes(hits, flux, parts, sums, d_hits, d_flux):  # type: ignore[no-untyped-def]
    """Adjoint of `add_boxes`.

    `hits`, `flux`, `parts`: as there; `sums` (n_y + 1, n_x + 1, 4): of the cotangent of the image,
    from the upper left of each pixel to the end of the image along both axes; how much they are
    more at its upper right and at its lower left; and what that leaves at its lower right;
    `d_hits`, `d_flux` (2, n, m) and (n, m): cotangents of the rays; changed.
    """
    pixels, row = (sums.shape[1] - 1, sums.shape[0] - 1), _FOUR * np.uintp(sums.shape[1])
    flat, t, at = sums.reshape(-1), np.empty(END, hits.dtype), np.empty(_ENDS, np.uintp)
    cells = flux.shape[1] - 1
    blocks = (cells + RAYS - 2) // (RAYS - 1)
    for i in range(np.uintp(flux.shape[0] - 1)):
        for block in range(blocks):
            j, lanes = _batch(block, blocks, cells)
            find_boxes(hits, flux, parts, i, j, lanes, pixels, t)
            _find_corners(lanes, row, t, at)
            for lane in range(lanes):
                _see_box(lane, t, at, flat)
            boxes_back(parts, i, j, lanes, t, d_hits, d_flux)
