"""The light of rays over pixels, a batch of rays at a time, as `workbench.optics.images`.

A tracer fills ``column``, ``row`` and ``weight`` for up to ``BATCH`` rays, which then are in the
first-level cache, and calls `scatter`; on the way back it fills the same again and calls `gather`,
the adjoint. Everything but the memory access of the taps vectorises.

A canvas is the image with ghost pixels and room for their taps around it: 2 (ν − 1)/2 pixels more
on each side, so that no tap needs a check of its own. A box filter has none of that.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.optics.kernels.taps import FAST, Taps, fill_taps, make_taps
from workbench.scene import Filter

# Rays that are dealt with at a time: all arrays of a batch fit into the first-level cache.
BATCH = 256


class Spread(NamedTuple):
    """Image and filter as the kernels want them; numbers in the trace's float type."""

    # Columns and rows between which a ray counts as one on the receiver.
    left: np.floating[Any]
    right: np.floating[Any]
    top: np.floating[Any]
    bottom: np.floating[Any]
    pixels: tuple[int, int]  # (n_x, n_y)
    # The filter along x and y.
    taps_x: Taps
    taps_y: Taps


class Workspace(NamedTuple):
    """Room for a batch; see `workspace`."""

    numbers: AnyArray  # batches of numbers: ``_LIGHT`` and so on, then taps and their slopes
    start: npt.NDArray[np.uintp]  # (BATCH,), where in the canvas the upper left tap of each ray is


# What is where in a workspace: the weight of rays that light any pixel, else 0; 1 for these, else
# 0; offsets of the hits; four batches for the taps' intermediate results.
_LIGHT, _KEPT, _OFFSET_X, _OFFSET_Y, _STATE = (np.uintp(BATCH * k) for k in range(5))
_TAPS = np.uintp(BATCH * 8)
_STEP = np.uintp(BATCH)


def make_spread(pixels: tuple[int, int], filter: Filter, kind: type[np.floating[Any]]) -> Spread:
    """Prepare an image and a filter for kernels of a float type.

    `pixels`: (n_x, n_y); `filter`: how the flux of a ray is spread over them; `kind`: float type of
    the kernels.
    """
    (n_x, n_y), zero = pixels, kind(0)
    taps = (make_taps(filter.alpha, size, kind) for size in filter.size)
    return Spread(zero, kind(n_x), zero, kind(n_y), (n_x, n_y), *taps)


def make_canvases(spread: Spread, count: int) -> Array:
    """Dark canvases, one for each part of the rays, shape (count, rows, columns).

    In float64 whatever the trace: many rays in one pixel add less each than float32 can tell.
    """
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    return np.zeros((count, n_y + 2 * m_y, n_x + 2 * m_x))


def add_up(spread: Spread, canvases: Array) -> AnyArray:
    """The image (n_y, n_x) of all canvases."""
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    canvas = canvases[0] if len(canvases) == 1 else canvases.sum(axis=0)
    image: AnyArray = canvas[m_y : m_y + n_y, m_x : m_x + n_x].astype(spread.left.dtype)
    return image


def pad(spread: Spread, cotangent: AnyArray) -> AnyArray:
    """A cotangent of the image (n_y, n_x) as a canvas for `gather`."""
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    canvas = np.zeros((n_y + 2 * m_y, n_x + 2 * m_x), spread.left.dtype)
    canvas[m_y : m_y + n_y, m_x : m_x + n_x] = cotangent
    return canvas


def _margins(spread: Spread) -> tuple[int, int]:
    return 2 * spread.taps_x.half_size, 2 * spread.taps_y.half_size


@jit()
def workspace(spread, like):  # type: ignore[no-untyped-def]
    """Room that `scatter` and `gather` need; ``like`` is any array of the trace's float type."""
    taps = 2 * (2 * spread.taps_x.half_size + 1 + 2 * spread.taps_y.half_size + 1)
    return Workspace(np.empty((8 + taps) * BATCH, like.dtype), np.empty(BATCH, np.uintp))


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def scatter(spread, column, row, weight, count, work, canvas):  # type: ignore[no-untyped-def]
    """Add the light of a batch of rays to a canvas.

    `spread`: image and filter; `column`, `row` (BATCH,): hits in image coordinates; infinite or not
    a number for rays that go nowhere; `weight` (BATCH,): flux of the rays; finite; `count`: how
    many rays there are, at most BATCH; `work`: room for intermediate results; `canvas` (rows,
    columns): one of `make_canvases`; changed. Returns flux of the rays on the screen, and of those
    beside it, wherever the filter spreads it.
    """
    rays = np.uintp(count)
    numbers, start = work.numbers, work.start
    _prepare(spread, column, row, weight, rays, False, numbers, start)
    flat, stride = canvas.reshape(-1), np.uintp(canvas.shape[1])
    size_x, size_y = _size(spread.taps_x), _size(spread.taps_y)
    taps_x, taps_y = _TAPS, _TAPS + size_x * _STEP
    one, two = np.uintp(1), np.uintp(2)
    if size_x == 1 and size_y == 1:
        for ray in range(rays):
            flat[start[ray]] += numbers[_LIGHT + ray]
    elif size_x == 3 and size_y == 3:  # the usual filter, without inner loops
        for ray in range(rays):
            left, middle = numbers[taps_x + ray], numbers[taps_x + _STEP + ray]
            right = numbers[taps_x + two * _STEP + ray]
            at = start[ray]
            for b in range(3):
                flux = numbers[_LIGHT + ray] * numbers[taps_y + np.uintp(b) * _STEP + ray]
                flat[at] += flux * left
                flat[at + one] += flux * middle
                flat[at + two] += flux * right
                at += stride
    else:
        for ray in range(rays):
            at = start[ray]
            for b in range(size_y):
                flux = numbers[_LIGHT + ray] * numbers[taps_y + b * _STEP + ray]
                for a in range(size_x):
                    flat[at + a] += flux * numbers[taps_x + a * _STEP + ray]
                at += stride
    return _landing(spread, column, row, weight, rays)


@jit(allocates=False, fastmath=FAST, error_model="numpy")
def gather(  # type: ignore[no-untyped-def]
    spread, column, row, weight, count, work, cotangent, d_column, d_row, d_weight
):
    """Cotangents of hits and weights from that of the image: the adjoint of `scatter`.

    `cotangent` (rows, columns): cotangent of the image, from `pad`; `d_column`, `d_row`, `d_weight`
    (BATCH,): the results; 0 for rays that light nothing.
    """
    rays = np.uintp(count)
    numbers, start = work.numbers, work.start
    _prepare(spread, column, row, weight, rays, True, numbers, start)
    flat, stride = cotangent.reshape(-1), np.uintp(cotangent.shape[1])
    size_x, size_y = _size(spread.taps_x), _size(spread.taps_y)
    taps_x, taps_y = _TAPS, _TAPS + size_x * _STEP
    slopes = (size_x + size_y) * _STEP  # as far behind the taps
    kind = weight.dtype.type
    if size_x == 1 and size_y == 1:
        for ray in range(rays):
            d_column[ray] = kind(0)
            d_row[ray] = kind(0)
            d_weight[ray] = flat[start[ray]]
    elif size_x == 3 and size_y == 3:
        _gather_three(numbers, start, rays, flat, stride, d_column, d_row, d_weight)
    else:
        for ray in range(rays):
            total, along_x, along_y = kind(0), kind(0), kind(0)
            at, y = start[ray], taps_y + ray
            for _ in range(size_y):
                value, rise = kind(0), kind(0)
                x = taps_x + ray
                for a in range(size_x):
                    value += numbers[x] * flat[at + a]
                    rise += numbers[x + slopes] * flat[at + a]
                    x += _STEP
                total += numbers[y] * value
                along_x += numbers[y] * rise
                along_y += numbers[y + slopes] * value
                at += stride
                y += _STEP
            d_column[ray] = along_x
            d_row[ray] = along_y
            d_weight[ray] = total
    for ray in range(rays):
        d_column[ray] *= numbers[_LIGHT + ray]
        d_row[ray] *= numbers[_LIGHT + ray]
        d_weight[ray] *= numbers[_KEPT + ray]


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _gather_three(numbers, start, rays, flat, stride, d_column, d_row, d_weight):  # type: ignore[no-untyped-def]
    """`gather` for the usual filter, without inner loops; what rays of flux 1 would have."""
    kind = d_weight.dtype.type
    one, two, three = np.uintp(1), np.uintp(2), np.uintp(3)
    slopes = (three + three) * _STEP  # as far behind the taps
    for ray in range(rays):
        x = _TAPS + ray
        left, middle, right = numbers[x], numbers[x + _STEP], numbers[x + two * _STEP]
        x += slopes
        rise_left, rise_middle = numbers[x], numbers[x + _STEP]
        rise_right = numbers[x + two * _STEP]
        total, along_x, along_y = kind(0), kind(0), kind(0)
        at, y = start[ray], _TAPS + three * _STEP + ray
        for _ in range(3):
            c_left, c_middle, c_right = flat[at], flat[at + one], flat[at + two]
            value = left * c_left + middle * c_middle + right * c_right
            rise = rise_left * c_left + rise_middle * c_middle + rise_right * c_right
            total += numbers[y] * value
            along_x += numbers[y] * rise
            along_y += numbers[y + slopes] * value
            at += stride
            y += _STEP
        d_column[ray] = along_x
        d_row[ray] = along_y
        d_weight[ray] = total


@jit(allocates=False, error_model="numpy", forceinline=True)
def _size(taps):  # type: ignore[no-untyped-def]
    return np.uintp(2 * taps.half_size + 1)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _landing(spread, column, row, weight, count):  # type: ignore[no-untyped-def]
    """Flux of rays on the screen, and beside it."""
    kind = weight.dtype.type
    on_screen, beside = kind(0), kind(0)
    for ray in range(count):
        lands = (
            (column[ray] >= spread.left)
            & (column[ray] < spread.right)
            & (row[ray] >= spread.top)
            & (row[ray] < spread.bottom)
        )
        light = weight[ray] if lands else kind(0)
        on_screen += light
        beside += weight[ray] - light  # a second choice would keep the loop from vectorising
    return np.float64(on_screen), np.float64(beside)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _prepare(spread, column, row, weight, count, slopes, numbers, start):  # type: ignore[no-untyped-def]
    """Everything that scatter and gather have in common, from cells to taps."""
    kind = weight.dtype.type
    n_x, n_y = spread.pixels
    m_x, m_y = spread.taps_x.half_size, spread.taps_y.half_size
    left, right = kind(-m_x), kind(n_x + m_x)
    top, bottom = kind(-m_y), kind(n_y + m_y)
    for ray in range(count):
        near = (
            (column[ray] >= left) & (column[ray] < right) & (row[ray] >= top) & (row[ray] < bottom)
        )
        light = weight[ray] if near else kind(0)
        numbers[_KEPT + ray] = kind(1) if near else kind(0)
        numbers[_LIGHT + ray] = light
    stride = np.uintp(n_x + 4 * m_x)
    _cells(row, count, top, bottom, stride, True, start, numbers, _OFFSET_Y)
    _cells(column, count, left, right, np.uintp(1), False, start, numbers, _OFFSET_X)
    size_x, size_y = _size(spread.taps_x), _size(spread.taps_y)
    tap = _TAPS
    slope = tap + (size_x + size_y) * _STEP
    fill_taps(spread.taps_x, numbers, _STEP, _OFFSET_X, count, slopes, _STATE, tap, slope)
    tap += size_x * _STEP
    slope += size_x * _STEP
    fill_taps(spread.taps_y, numbers, _STEP, _OFFSET_Y, count, slopes, _STATE, tap, slope)


@jit(allocates=False, fastmath=FAST, error_model="numpy", forceinline=True)
def _cells(place, count, low, high, step, first, start, numbers, offset):  # type: ignore[no-untyped-def]
    """Pixels of rays along one axis, and how far from the pixels' centres they are."""
    kind = place.dtype.type
    for ray in range(count):
        # Rays beyond carry no light: any pixel does. Not a number is beyond, too.
        here = place[ray] if (place[ray] >= low) & (place[ray] < high) else kind(0)
        pixel = np.floor(here)
        numbers[offset + ray] = here - pixel - kind(0.5)
        cells = np.uintp(np.int32(pixel - low)) * step
        start[ray] = cells if first else start[ray] + cells
