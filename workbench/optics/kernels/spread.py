"""Spreads the light of rays over pixels, a batch of rays at a time; `irradiance`'s twin.

A tracer fills ``column``, ``row`` and ``weight`` for up to ``BATCH`` rays, which then are in the
first-level cache, and calls `scatter`; on the way back it fills the same again and calls `gather`,
the adjoint. Everything but the memory access of the taps vectorises.

A canvas is the image with ghost pixels and room for their taps around it: 2 (ν − 1)/2 pixels more
on each side, so that no tap needs a check of its own. A box filter has none of that.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from numba import njit

from workbench.optics.kernels.taps import FAST, Taps, fill_taps, make_taps
from workbench.scene import Filter, GaussianFilter, Screen

AnyArray = npt.NDArray[np.floating[Any]]

# Rays that are dealt with at a time: all arrays of a batch fit into the first-level cache.
BATCH = 256


class Spread(NamedTuple):
    """Screen and filter as the kernels want them; numbers in the trace's float type.

    Attributes
    ----------
    column_0, per_x : floating
        A hit at x is at column ``column_0 + per_x x`` of the image, see `Screen.to_pixels`.
    row_0, per_y : floating
        A hit at y is at row ``row_0 + per_y y``; ``per_y`` is negative.
    pixels : tuple[int, int]
        (n_x, n_y).
    taps_x, taps_y : Taps
        The filter along x and y.
    """

    column_0: np.floating[Any]
    per_x: np.floating[Any]
    row_0: np.floating[Any]
    per_y: np.floating[Any]
    pixels: tuple[int, int]
    taps_x: Taps
    taps_y: Taps


class Workspace(NamedTuple):
    """Room for a batch; see `workspace`."""

    light: AnyArray  # weight of the rays that light any pixel, else 0
    kept: AnyArray  # 1 for these rays, else 0
    offset_x: AnyArray
    offset_y: AnyArray
    start: npt.NDArray[np.uintp]  # where a ray's upper left tap is in the canvas
    state: AnyArray
    tap_x: AnyArray
    tap_y: AnyArray
    slope_x: AnyArray
    slope_y: AnyArray


def make_spread(screen: Screen, filter: Filter, kind: type[np.floating[Any]]) -> Spread:
    """Prepare a screen and a filter for kernels of a float type."""
    size = filter.size if isinstance(filter, GaussianFilter) else (1, 1)
    alpha = filter.alpha if isinstance(filter, GaussianFilter) else 0.0
    r_x, r_y = screen.half_width
    column_0, row_0 = screen.to_pixels(0.0, 0.0)
    column_1, row_1 = screen.to_pixels(r_x, r_y)
    return Spread(
        kind(column_0),
        kind((column_1 - column_0) / r_x),
        kind(row_0),
        kind((row_1 - row_0) / r_y),
        screen.pixels,
        make_taps(alpha, size[0], kind),
        make_taps(alpha, size[1], kind),
    )


def make_canvases(spread: Spread, count: int) -> AnyArray:
    """Dark canvases, one for each part of the rays, shape (count, rows, columns)."""
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    return np.zeros((count, n_y + 2 * m_y, n_x + 2 * m_x), spread.per_x.dtype)


def add_up(spread: Spread, canvases: AnyArray) -> tuple[AnyArray, float]:
    """The image (n_y, n_x) of all canvases, and the flux that fell on the pixels around it."""
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    canvas = canvases[0] if len(canvases) == 1 else canvases.sum(axis=0)
    image = np.ascontiguousarray(canvas[m_y : m_y + n_y, m_x : m_x + n_x])
    around = canvas.sum(dtype=np.float64) - image.sum(dtype=np.float64)
    return image, float(around) if m_x or m_y else 0.0


def pad(spread: Spread, cotangent: AnyArray) -> AnyArray:
    """A cotangent of the image (n_y, n_x) as a canvas for `gather`."""
    (n_x, n_y), (m_x, m_y) = spread.pixels, _margins(spread)
    canvas: AnyArray = make_canvases(spread, 1)[0]
    canvas[m_y : m_y + n_y, m_x : m_x + n_x] = cotangent
    return canvas


def _margins(spread: Spread) -> tuple[int, int]:
    return 2 * spread.taps_x.reach, 2 * spread.taps_y.reach


@njit(cache=True, nogil=True)
def workspace(spread, like):  # type: ignore[no-untyped-def]
    """Room that `scatter` and `gather` need; ``like`` is any array of the trace's float type."""
    kind = like.dtype
    size_x, size_y = 2 * spread.taps_x.reach + 1, 2 * spread.taps_y.reach + 1
    return Workspace(
        np.empty(BATCH, kind),
        np.empty(BATCH, kind),
        np.empty(BATCH, kind),
        np.empty(BATCH, kind),
        np.empty(BATCH, np.uintp),
        np.empty((4, BATCH), kind),
        np.empty((size_x, BATCH), kind),
        np.empty((size_y, BATCH), kind),
        np.empty((size_x, BATCH), kind),
        np.empty((size_y, BATCH), kind),
    )


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def scatter(spread, column, row, weight, count, work, canvas):  # type: ignore[no-untyped-def]
    """Add the light of a batch of rays to a canvas.

    Parameters
    ----------
    spread : Spread
        Screen and filter.
    column, row : array, shape (BATCH,)
        Hits in image coordinates; infinite or not a number for rays that go nowhere.
    weight : array, shape (BATCH,)
        Flux of the rays; finite.
    count : int
        How many rays there are, at most BATCH.
    work : Workspace
        Room for intermediate results.
    canvas : array, shape (rows, columns)
        One of `make_canvases`; changed.

    Returns
    -------
    float64
        Flux of the rays that light no pixel of the canvas.
    """
    beside = _prepare(spread, column, row, weight, count, False, work)
    flat, stride = canvas.reshape(-1), np.uintp(canvas.shape[1])
    reach_x, reach_y = spread.taps_x.reach, spread.taps_y.reach
    light, start, tap_x, tap_y = work.light, work.start, work.tap_x, work.tap_y
    if reach_x == 0 and reach_y == 0:
        for ray in range(count):
            flat[start[ray]] += light[ray]
    elif reach_x == 1 and reach_y == 1:
        _add_three(flat, stride, start, light, tap_x, tap_y, count)
    else:
        for ray in range(count):
            at = start[ray]
            for b in range(2 * reach_y + 1):
                flux = light[ray] * tap_y[b, ray]
                for a in range(np.uintp(2 * reach_x + 1)):
                    flat[at + a] += flux * tap_x[a, ray]
                at += stride
    return beside


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def gather(  # type: ignore[no-untyped-def]
    spread, column, row, weight, count, work, cotangent, d_column, d_row, d_weight
):
    """Cotangents of hits and weights from that of the image: the adjoint of `scatter`.

    Parameters
    ----------
    spread, column, row, weight, count, work
        As for `scatter`.
    cotangent : array, shape (rows, columns)
        Cotangent of the image, from `pad`.
    d_column, d_row, d_weight : array, shape (BATCH,)
        The results; 0 for rays that light nothing.
    """
    _prepare(spread, column, row, weight, count, True, work)
    flat, stride = cotangent.reshape(-1), np.uintp(cotangent.shape[1])
    reach_x, reach_y = spread.taps_x.reach, spread.taps_y.reach
    light, kept, start = work.light, work.kept, work.start
    kind = weight.dtype.type
    if reach_x == 0 and reach_y == 0:
        for ray in range(count):
            d_column[ray] = kind(0)
            d_row[ray] = kind(0)
            d_weight[ray] = flat[start[ray]]
    elif reach_x == 1 and reach_y == 1:
        _read_three(flat, stride, work, count, d_column, d_row, d_weight)
    else:
        for ray in range(count):
            at = start[ray]
            total, along_x, along_y = kind(0), kind(0), kind(0)
            for b in range(2 * reach_y + 1):
                value, rise = kind(0), kind(0)
                for a in range(np.uintp(2 * reach_x + 1)):
                    value += work.tap_x[a, ray] * flat[at + a]
                    rise += work.slope_x[a, ray] * flat[at + a]
                total += work.tap_y[b, ray] * value
                along_x += work.tap_y[b, ray] * rise
                along_y += work.slope_y[b, ray] * value
                at += stride
            d_column[ray] = along_x
            d_row[ray] = along_y
            d_weight[ray] = total
    for ray in range(count):
        d_column[ray] *= light[ray]
        d_row[ray] *= light[ray]
    for ray in range(count):
        d_weight[ray] *= kept[ray]


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def _prepare(spread, column, row, weight, count, slopes, work):  # type: ignore[no-untyped-def]
    """Everything that scatter and gather have in common, from cells to taps."""
    kind = weight.dtype.type
    n_x, n_y = spread.pixels
    m_x, m_y = spread.taps_x.reach, spread.taps_y.reach
    light, kept, start = work.light, work.kept, work.start
    left, right = kind(-m_x), kind(n_x + m_x)
    top, bottom = kind(-m_y), kind(n_y + m_y)
    for ray in range(count):
        near = (
            (column[ray] >= left) & (column[ray] < right) & (row[ray] >= top) & (row[ray] < bottom)
        )
        kept[ray] = kind(1) if near else kind(0)
    beside = kind(0)
    for ray in range(count):
        light[ray] = weight[ray] * kept[ray]
        beside += weight[ray] - light[ray]
    _cells(row, count, top, bottom, np.uintp(n_x + 4 * m_x), True, start, work.offset_y)
    _cells(column, count, left, right, np.uintp(1), False, start, work.offset_x)
    fill_taps(spread.taps_x, work.offset_x, count, slopes, work.state, work.tap_x, work.slope_x)
    fill_taps(spread.taps_y, work.offset_y, count, slopes, work.state, work.tap_y, work.slope_y)
    return np.float64(beside)


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def _cells(place, count, low, high, step, first, start, offset):  # type: ignore[no-untyped-def]
    """Pixels of rays along one axis, and how far from the pixels' centres they are."""
    kind = place.dtype.type
    for ray in range(count):
        # Rays beyond carry no light: any pixel does. Not a number is beyond, too.
        here = place[ray] if (place[ray] >= low) & (place[ray] < high) else kind(0)
        pixel = np.floor(here)
        offset[ray] = here - pixel - kind(0.5)
        cells = np.uintp(np.int32(pixel - low)) * step
        start[ray] = cells if first else start[ray] + cells


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def _add_three(flat, stride, start, light, tap_x, tap_y, count):  # type: ignore[no-untyped-def]
    """The usual filter of 3 × 3 pixels, without inner loops."""
    one, two = np.uintp(1), np.uintp(2)
    for ray in range(count):
        left, middle, right = tap_x[0, ray], tap_x[1, ray], tap_x[2, ray]
        at = start[ray]
        for b in range(3):
            flux = light[ray] * tap_y[b, ray]
            flat[at] += flux * left
            flat[at + one] += flux * middle
            flat[at + two] += flux * right
            at += stride


@njit(cache=True, nogil=True, fastmath=FAST, error_model="numpy")
def _read_three(flat, stride, work, count, d_column, d_row, d_weight):  # type: ignore[no-untyped-def]
    """The adjoint of `_add_three`."""
    kind = d_column.dtype.type
    one, two = np.uintp(1), np.uintp(2)
    tap_x, tap_y, slope_x, slope_y = work.tap_x, work.tap_y, work.slope_x, work.slope_y
    for ray in range(count):
        at = work.start[ray]
        total, along_x, along_y = kind(0), kind(0), kind(0)
        for b in range(3):
            left, middle, right = flat[at], flat[at + one], flat[at + two]
            value = tap_x[0, ray] * left + tap_x[1, ray] * middle + tap_x[2, ray] * right
            rise = slope_x[0, ray] * left + slope_x[1, ray] * middle + slope_x[2, ray] * right
            total += tap_y[b, ray] * value
            along_x += tap_y[b, ray] * rise
            along_y += slope_y[b, ray] * value
            at += stride
        d_column[ray] = along_x
        d_row[ray] = along_y
        d_weight[ray] = total
