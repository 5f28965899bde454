"""Boxes onto pixels, exactly, by their four corners; and the adjoint.

The light of a box in a pixel is a product of two parts, of its intervals along columns and along
rows. Each is a double sum: light begins at one end of an interval and stops at the other, and an
end that is a part p behind the beginning of its pixel counts 1 − p there and p in the next one. So
a box of any size is four numbers at each of its corners: its density of light, and that times p
along columns, along rows, and along both. All sums are done once, for all boxes. No border of the
image needs a check: ends beside it are moved to it.

On the way back sums of the cotangent, from each place to the end of the image along both axes, are
bilinear within each pixel. At the four corners they give the cotangent's integral over a box, and
their slopes give those along its sides.

All sums and what they are of are in float64, as large ones cancel. Boxes are in the float type of
the hits.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.box_cells import (
    BY_WIDTH,
    END,
    FLUX,
    HIGH,
    HIGH_PART,
    HIGH_PIXEL,
    LOW,
    LOW_PART,
    LOW_PIXEL,
    MEAN,
    MORE,
    OUTER,
    RAYS,
    X,
    Y,
    boxes_back,
    find_boxes,
)
from workbench.optics.kernels.taps import FAST

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

    `hits`, `flux`, `parts`: see `workbench.optics.kernels.box_cells.find_boxes`; `corners` (n_y +
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
