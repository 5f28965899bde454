"""The image of boxes as a step that torch differentiates; compiled, by threads.

One call draws several grids of rays: what a grid needs stays in the cache.
"""

from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.optics.kernels import kind_of, threads
from workbench.optics.kernels.beam_raster import ROUNDING
from workbench.optics.kernels.box_raster import add_boxes, see_boxes
from workbench.optics.kernels.cell_image import Back, Splits, cell_image, repeated
from workbench.optics.kernels.node_shift import count_shift, shift, shift_back
from workbench.optics.kernels.taps import FAST


class Grids(NamedTuple):
    """Grids that lie side by side along the first axis of their nodes."""

    first: AnyArray  # (grids + 1,), first row of each; behind them the number of all rows
    # (grids,), first row of each in ``along_u``: where all are alike, it has those of one.
    behind: AnyArray
    # (n, 3) and (m, 3), splits along both axes; see
    # `workbench.optics.kernels.beam_cells.Mesh`.
    along_u: Array
    along_v: Array
    # (2, n) and (2, m), their parts of flux, in the float type of the nodes; see `find_boxes`.
    parts_u: AnyArray
    parts_v: AnyArray

    @classmethod
    def of(cls, nodes: AnyArray, splits: Splits) -> "Grids":
        """Grids of nodes, shape (3, n, m)."""
        rows = _grids_of(splits, nodes.shape[1:]) or [slice(0, nodes.shape[1])]
        alike = nodes.shape[1] > len(splits[1])
        along_u, along_v = _splits_of_grids(splits, rows[0] if alike else slice(0, nodes.shape[1]))
        parts_u, parts_v = (
            each[:, :2].T.astype(nodes.dtype, order="C") for each in (along_u, along_v)
        )
        first = np.array([*(each.start for each in rows), nodes.shape[1]])
        behind = np.zeros_like(first[:-1]) if alike else first[:-1]
        return cls(first, behind, along_u, along_v, parts_u, parts_v)


@jit(fastmath=FAST, error_model="numpy")
def add_grids(nodes, grids, begin, end, corners):  # type: ignore[no-untyped-def]
    """Add the boxes of some grids.

    `nodes` (3, n, m): columns and rows in which rays hit, and their flux; `grids`: of these;
    `begin`, `end`: which of them; `corners`: see `workbench.optics.kernels.box_raster.add_boxes`;
    changed. Returns flux of all boxes, on the image or beside it.
    """
    landed = 0.0
    for grid in range(begin, end):
        split, parts = _of_grid(grids, grid)
        hits = _moved(nodes, grids, grid, split)
        landed += add_boxes(
            hits, nodes[2, grids.first[grid] : grids.first[grid + 1]], parts, corners
        )
    return landed


@jit(fastmath=FAST, error_model="numpy")
def see_grids(nodes, grids, begin, end, sums, result):  # type: ignore[no-untyped-def]
    """Adjoint of `add_grids`.

    `nodes`, `grids`, `begin`, `end`: as there; `sums`: see
    `workbench.optics.kernels.box_raster.see_boxes`; `result` (3, n, m): cotangents of the nodes;
    those of these grids are changed.
    """
    for grid in range(begin, end):
        first, last = grids.first[grid], grids.first[grid + 1]
        split, parts = _of_grid(grids, grid)
        hits = _moved(nodes, grids, grid, split)
        d_hits, d_flux = np.zeros_like(hits), result[2, first:last]
        d_flux[:] = d_flux.dtype.type(0)
        see_boxes(hits, nodes[2, first:last], parts, sums, d_hits, d_flux)
        for k in range(2):
            _move_back(nodes[k, first:last], split, d_hits[k], result[k, first:last])


@jit(error_model="numpy")
def _move_back(hits, split, moved, result):  # type: ignore[no-untyped-def]
    """Adjoint of the shifts of a grid."""
    rows, m = hits.shape
    counts, along = np.zeros((rows + 2, m), moved.dtype), np.empty(m, moved.dtype)
    for i in range(rows):
        count_shift(hits, i, split[0][i, 2] > 0.0, moved[i], counts[i + 1])
    for i in range(rows):
        around = counts[i], counts[i + 1], counts[i + 2]
        shift_back(hits, split[1], i, moved[i], around, along, result[i])


@jit(error_model="numpy")
def _moved(nodes, grids, grid, split):  # type: ignore[no-untyped-def]
    """Hits of a grid, shifted."""
    first, last = grids.first[grid], grids.first[grid + 1]
    hits = np.empty((2, last - first, nodes.shape[2]), nodes.dtype)
    for k in range(2):
        for i in range(last - first):
            shift(nodes[k, first:last], split[1], i, split[0][i, 2] > 0.0, hits[k, i])
    return hits


@jit(error_model="numpy")
def _of_grid(grids, grid):  # type: ignore[no-untyped-def]
    """Splits of a grid, and its parts of flux."""
    begin = grids.behind[grid]
    here = slice(begin, begin + grids.first[grid + 1] - grids.first[grid])
    return (grids.along_u[here], grids.along_v), (grids.parts_u[:, here], grids.parts_v)


# Grids of so few rows are drawn as one: what lies between them costs less than a call for each.
_SMALL = 32
# Nodes of grids that are alike and drawn as one: their boxes fit into the cache of a processor.
_TOGETHER = 1 << 16


def _grids_of(splits: Splits, shape: tuple[int, ...]) -> list[slice]:
    """Rows of grids that lie side by side, if there are several that are drawn one by one."""
    along_v, (rows, columns) = splits[1], shape
    if (alike := rows // len(along_v)) > 1:
        each = len(along_v)
        few = max(_TOGETHER // (each * columns), 1)
        return [
            slice(each * begin, each * min(begin + few, alike)) for begin in range(0, alike, few)
        ]
    first = np.flatnonzero(along_v[:, 0] == 0)
    if len(first) < 2:
        return []
    counts = np.diff(first, append=len(along_v))
    if counts.max() <= _SMALL:
        return []
    return [slice(*ends) for ends in pairwise([*first.tolist(), len(along_v)])]


def _splits_of_grids(splits: Splits, rows: slice) -> tuple[Array, Array]:
    """Splits of some grids, along the first axis of their nodes, then along the second."""
    along_u, along_v = splits
    if rows.stop <= len(along_v):
        return along_v[rows], along_u
    return repeated(along_v, rows.stop - rows.start), along_u


# Parts where none needs an image of its own: no thread then waits long for another.
_PARTS = 32


def compiled_box_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.images.beams.box_image`, on the CPU."""
    return cell_image(_draw, nodes, pixels, splits)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by an image of one cell."""
    nodes = np.zeros((3, 2, 2), kind_of(dtype))
    splits = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    grids = Grids.of(nodes, (splits, splits))
    _forward(nodes, (2, 2), grids)
    _back(nodes, np.zeros((2, 2)), grids)


def _draw(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float, Back]:
    """See `workbench.optics.kernels.cell_image.Draw`."""
    grids = Grids.of(nodes, splits)
    return *_forward(nodes, pixels, grids), partial(_back, grids=grids)


def _forward(nodes: AnyArray, pixels: tuple[int, int], grids: Grids) -> tuple[Array, float]:
    """The image, and the flux that lands on its plane."""
    n_x, n_y = pixels
    at = _bounds(grids, threads.images(4 * n_x * n_y))
    corners, landed = np.zeros((len(at) - 1, n_y + 1, n_x + 1, 4)), [0.0] * (len(at) - 1)

    def work(part: int) -> None:
        landed[part] = add_grids(nodes, grids, at[part], at[part + 1], corners[part])

    threads.run(work, len(at) - 1)
    image = _summed(corners)
    image[image < ROUNDING * sum(landed)] = 0.0
    return image, sum(landed)


def _summed(corners: Array) -> Array:
    """The image of what all parts have at corners of boxes; see `add_boxes`."""
    whole, by_x, by_y, by_both = np.moveaxis(corners.sum(axis=0), -1, 0)
    steps = whole - by_x - by_y + by_both
    steps[:, 1:] += (by_x - by_both)[:, :-1]
    steps[1:] += (by_y - by_both)[:-1]
    steps[1:, 1:] += by_both[:-1, :-1]
    return np.asarray(steps.cumsum(axis=0).cumsum(axis=1)[:-1, :-1])


def _back(nodes: AnyArray, cotangent: Array, grids: Grids) -> AnyArray:
    """Cotangent of the nodes from that of the image."""
    sums, result = _sums(cotangent), np.empty_like(nodes)
    at = _bounds(grids, _PARTS)

    def work(part: int) -> None:
        see_grids(nodes, grids, at[part], at[part + 1], sums, result)

    threads.run(work, len(at) - 1)
    return result


def _bounds(grids: Grids, parts: int) -> list[int]:
    """Where so many parts of some grids begin, and where the last ends."""
    count = len(grids.behind)
    return threads.bounds(count, min(parts, count))


def _sums(cotangent: Array) -> Array:
    """Sums of a cotangent of the image, as `see_boxes` takes them."""
    n_y, n_x = cotangent.shape
    whole = np.zeros((n_y + 2, n_x + 2))
    whole[-3::-1, -3::-1] = cotangent[::-1, ::-1].cumsum(axis=0).cumsum(axis=1)
    here, right, below, beyond = whole[:-1, :-1], whole[:-1, 1:], whole[1:, :-1], whole[1:, 1:]
    return np.stack([here, right - here, below - here, beyond - right - below + here], axis=-1)
