"""The image of beams as a step that torch differentiates; compiled, by threads.

Between nodes hits are interpolated linearly, and where the map from lens to receiver bends that is
off by h²/12 times the second derivative along each axis, on average over a cell. The nodes are
shifted by as much the other way, but for those at the rim. This halves the error of three images
by 384² cells, and divides it by 3 by 1024² cells (0.58 to 0.17 %).
"""

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.optics.kernels import kind_of, threads
from workbench.optics.kernels.beam_raster import (
    FARTHEST,
    ROUNDING,
    add_edges,
    densities,
    densities_back,
    edges_back,
)
from workbench.optics.kernels.cell_image import Back, Splits, cell_image
from workbench.optics.kernels.polygons import compile_drawing

_TWELFTH = 1 / 12
_ONE, _TWO, _THREE = np.uintp(1), np.uintp(2), np.uintp(3)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _second_diff(before, here, after):  # type: ignore[no-untyped-def]
    """Second difference of hits; those of neighbours are exact in float32, too."""
    return (before - here) + (after - here)


@jit(allocates=False, error_model="numpy")
def shift(hits, parts, begin, end, shifted):  # type: ignore[no-untyped-def]
    """Shift the hits of some rows of nodes.

    `hits` (n + 1, m + 1): columns or rows in which rays hit; infinite for those that never do;
    `parts`: see `workbench.optics.kernels.beam_raster.densities`; what ends a grid stays where it
    is, and so does what has a neighbour that hits nowhere or far away; `begin`, `end`: which rows
    of nodes; `shifted` (n + 1, m + 1): the result; infinite or within ``FARTHEST``.
    """
    along_u, along_v = parts
    m, kind = np.uintp(hits.shape[1]), hits.dtype.type
    zero, twelfth, far = kind(0), kind(_TWELFTH), kind(FARTHEST)
    for i in range(np.uintp(begin), np.uintp(end)):
        # Loops along a row have no branches: the compiler makes vectors of them.
        for j in range(m):
            shifted[i, j] = hits[i, j]
        if along_u[i, 2] > 0.0:
            for j in range(m):
                second_diff = _second_diff(hits[i - _ONE, j], hits[i, j], hits[i + _ONE, j])
                shifted[i, j] -= twelfth * second_diff if abs(second_diff) < far else zero
        for j in range(_ONE, m - _ONE):
            second_diff = _second_diff(hits[i, j - _ONE], hits[i, j], hits[i, j + _ONE])
            part = twelfth * kind(along_v[j, 2])
            shifted[i, j] -= part * second_diff if abs(second_diff) < far else zero
        for j in range(m):
            place = min(max(shifted[i, j], -far), far)
            shifted[i, j] = place if abs(hits[i, j]) < np.inf else np.inf


@jit(allocates=False, error_model="numpy", forceinline=True)
def _unshift(hits, along_u, cotangent, i, counts):  # type: ignore[no-untyped-def]
    """What the shifts along u of a row of nodes let the cotangents of its hits count elsewhere."""
    m, kind = np.uintp(hits.shape[1]), cotangent.dtype.type
    zero, twelfth, far = kind(0), kind(_TWELFTH), hits.dtype.type(FARTHEST)
    if i >= np.uintp(hits.shape[0]) or not along_u[i, 2] > 0.0:  # also behind the rim's other side
        for j in range(m):
            counts[j] = zero
        return
    for j in range(m):
        second_diff = _second_diff(hits[i - _ONE, j], hits[i, j], hits[i + _ONE, j])
        counts[j] = -twelfth * cotangent[i, j] if abs(second_diff) < far else zero


@jit(error_model="numpy")
def shift_back(hits, parts, cotangent, begin, end, result):  # type: ignore[no-untyped-def]
    """Adjoint of `shift`, for some rows of nodes.

    `hits`, `parts`, `begin`, `end`: see `shift`; `cotangent` (n + 1, m + 1): cotangent of what was
    shifted; `result` (n + 1, m + 1): that of the hits, in their float type.
    """
    along_u, along_v = parts
    m, first, kind = np.uintp(hits.shape[1]), np.uintp(begin), cotangent.dtype.type
    zero, two, twelfth, far = kind(0), kind(2), kind(_TWELFTH), hits.dtype.type(FARTHEST)
    total, along = np.empty(m, kind), np.zeros(m, kind)
    # The matrix is symmetric, but for the rim: a node there is not shifted, but counts in the
    # shift of its neighbour.
    around = np.empty((3, m), kind)  # the rows before, here and behind, in turns
    _unshift(hits, along_u, cotangent, first - _ONE, around[0])
    _unshift(hits, along_u, cotangent, first, around[1])
    for i in range(first, np.uintp(end)):
        turn = (i - first) % _THREE
        here, behind = around[(turn + _ONE) % _THREE], around[(turn + _TWO) % _THREE]
        before = around[turn]
        _unshift(hits, along_u, cotangent, i + _ONE, behind)
        for j in range(m):
            total[j] = cotangent[i, j] + before[j] - two * here[j] + behind[j]
        for b in range(_ONE, m - _ONE):
            second_diff = _second_diff(hits[i, b - _ONE], hits[i, b], hits[i, b + _ONE])
            counts = -twelfth * kind(along_v[b, 2]) * cotangent[i, b]
            along[b] = counts if abs(second_diff) < far else zero
        for j in range(m - _ONE):
            total[j] += along[j + _ONE]
        for j in range(m):
            total[j] -= two * along[j]
        for j in range(_ONE, m):
            total[j] += along[j - _ONE]
        for j in range(m):
            result[i, j] = total[j] if abs(hits[i, j]) < far else zero


# Times as many parts where a part needs no image of its own: rows take more time where light is.
_SHARES = 4
# Grids of so few rows are drawn as one: what lies between them costs less than a call for each.
_SMALL = 32
# Nodes of grids that are alike and drawn as one: their triangles fit into the cache of a processor.
_TOGETHER = 1 << 16


def compiled_beam_image(
    nodes: Tensor, pixels: tuple[int, int], splits: Splits
) -> tuple[Tensor, float]:
    """As `workbench.optics.images.beams.beam_image`, on the CPU."""
    return cell_image(_draw, nodes, pixels, splits)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by an image of one cell."""
    nodes = np.zeros((3, 2, 2), kind_of(dtype))
    splits = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    _back(nodes, np.zeros((2, 2)), _forward(nodes, (2, 2), (splits, splits))[2])
    compile_drawing()


class _Mesh(NamedTuple):
    """Triangles of light; see `densities`."""

    column: Array
    row: Array
    density: Array
    parts: tuple[Array, Array]


def _draw(nodes: AnyArray, pixels: tuple[int, int], splits: Splits) -> tuple[Array, float, Back]:
    """See `workbench.optics.kernels.cell_image.Draw`."""
    if grids := grids_of(splits, nodes.shape[1:]):
        image, landed = _forward_by_grids(nodes, pixels, splits, grids)
        return image, landed, partial(_back_by_grids, splits=splits, grids=grids)
    image, landed, mesh = _forward(nodes, pixels, splits)
    return image, landed, partial(_back, mesh=mesh)


def grids_of(splits: Splits, shape: tuple[int, ...]) -> list[slice]:
    """Rows of grids that lie side by side, if there are several that are drawn one by one.

    Diagonals of cells turn with the number of the row in its grid: small grids are drawn as one
    only if all have an even number of rows.
    """
    along_v, (rows, columns) = splits[1], shape
    if (alike := rows // len(along_v)) > 1:
        each = len(along_v)
        few = max(_TOGETHER // (each * columns), 1) if each % 2 == 0 else 1
        return [
            slice(each * begin, each * min(begin + few, alike)) for begin in range(0, alike, few)
        ]
    first = np.flatnonzero(along_v[:, 0] == 0)
    if len(first) < 2:
        return []
    counts = np.diff(first, append=len(along_v))
    if counts.max() <= _SMALL and not (counts % 2).any():
        return []
    return [slice(*ends) for ends in pairwise([*first.tolist(), len(along_v)])]


def splits_of_grids(splits: Splits, rows: slice) -> tuple[Array, Array]:
    """Splits of some grids, along the first axis of their nodes, then along the second."""
    along_u, along_v = splits
    if rows.stop <= len(along_v):
        return along_v[rows], along_u
    return repeated(along_v, rows.stop - rows.start), along_u


def repeated(along_v: Array, rows: int) -> Array:
    """Splits along v of so many rows of grids that are alike."""
    return np.tile(along_v, (rows // len(along_v), 1))


def _forward(
    nodes: AnyArray, pixels: tuple[int, int], splits: Splits
) -> tuple[Array, float, _Mesh]:
    """The image, the flux that lands on its plane, and what the way back needs."""
    n_x, n_y = pixels
    rows, columns = nodes.shape[1:]
    count = min(threads.parts(nodes[0].size), threads.images(n_x * n_y), rows)
    at = threads.bounds(rows, count)
    parts = len(at) - 1
    parted = splits[::-1]  # along the first axis of the nodes, then along the second
    column, row = np.empty((2, rows, columns))
    density = np.zeros((rows + 1, columns + 1, 2))
    slivers, steps = np.zeros((parts, n_y, n_x)), np.zeros((parts, n_y, n_x + 1))
    landed = [0.0] * parts

    def move(part: int) -> None:
        shift(nodes[0], parted, at[part], at[part + 1], column)
        shift(nodes[1], parted, at[part], at[part + 1], row)

    def spread(part: int) -> None:
        cells = at[part], min(at[part + 1], rows - 1)
        landed[part] = densities(column, row, nodes[2], parted, *cells, density, slivers[part])

    def draw(part: int) -> None:
        add_edges(column, row, density, at[part], at[part + 1], steps[part])

    for work in (move, spread, draw):
        threads.run(work, parts)
    return _finished(slivers, steps, sum(landed)), sum(landed), _Mesh(column, row, density, parted)


def _finished(slivers: Array, steps: Array, landed: float) -> Array:
    """The image of all parts."""
    image = slivers.sum(axis=0) - np.cumsum(steps.sum(axis=0)[:, :-1], axis=1)
    image[image < ROUNDING * landed] = 0.0
    return np.asarray(image)


def _forward_by_grids(
    nodes: AnyArray, pixels: tuple[int, int], splits: Splits, grids: list[slice]
) -> tuple[Array, float]:
    """As `_forward`, one grid after the other: each stays within the cache of a processor."""
    n_x, n_y = pixels
    at = threads.bounds(len(grids), min(threads.images(n_x * n_y), len(grids)))
    parts = len(at) - 1
    slivers, steps = np.zeros((parts, n_y, n_x)), np.zeros((parts, n_y, n_x + 1))
    landed = [0.0] * parts

    def work(part: int) -> None:
        for rows in grids[at[part] : at[part + 1]]:
            mesh, lands = _triangles(nodes[:, rows], splits_of_grids(splits, rows), slivers[part])
            add_edges(*mesh[:3], 0, len(mesh.row), steps[part])
            landed[part] += lands

    threads.run(work, parts)
    return _finished(slivers, steps, sum(landed)), sum(landed)


def _triangles(nodes: AnyArray, parted: tuple[Array, Array], image: Array) -> tuple[_Mesh, float]:
    """Triangles of one grid, and the flux that lands; those without area are added to an image."""
    rows, columns = nodes.shape[1:]
    column, row = np.empty((2, rows, columns))
    density = np.zeros((rows + 1, columns + 1, 2))
    shift(nodes[0], parted, 0, rows, column)
    shift(nodes[1], parted, 0, rows, row)
    lands = densities(column, row, nodes[2], parted, 0, rows - 1, density, image)
    return _Mesh(column, row, density, parted), lands


def _back_by_grids(
    nodes: AnyArray, cotangent: Array, splits: Splits, grids: list[slice]
) -> AnyArray:
    """As `_back`; the triangles are made again, which is cheaper than to keep them all."""
    at = threads.bounds(len(grids), min(threads.images(cotangent.size), len(grids)))
    right, result = _to_the_right(cotangent), np.empty_like(nodes)

    def work(part: int) -> None:
        aside = np.zeros_like(cotangent)
        for rows in grids[at[part] : at[part + 1]]:
            mesh, _ = _triangles(nodes[:, rows], splits_of_grids(splits, rows), aside)
            count, columns = mesh.row.shape
            d_nodes, d_density = np.zeros((3, count + 1, columns)), np.zeros_like(mesh.density)
            edges_back(*mesh[:3], cotangent, right, 0, count, d_nodes[0], d_nodes[1], d_density)
            densities_back(*mesh, cotangent, d_density, 0, count - 1, *d_nodes)
            result[2, rows] = d_nodes[2, :count]
            for k in range(2):
                shift_back(nodes[k, rows], mesh.parts, d_nodes[k], 0, count, result[k, rows])

    threads.run(work, len(at) - 1)
    return result


def _to_the_right(cotangent: Array) -> Array:
    """Sums over all pixels from each one to the right end of its row."""
    right = np.zeros((cotangent.shape[0], cotangent.shape[1] + 1))
    right[:, :-1] = np.cumsum(cotangent[:, ::-1], axis=1)[:, ::-1]
    return right


def _back(nodes: AnyArray, cotangent: Array, mesh: _Mesh) -> AnyArray:
    """Cotangent of the nodes from that of the image."""
    rows, columns = nodes.shape[1:]
    at = threads.split(rows, nodes[0].size, _SHARES)
    column, row, density, parted = mesh
    right = _to_the_right(cotangent)
    d_nodes, d_density = np.zeros((3, rows + 1, columns)), np.zeros_like(density)

    def look(begin: int, end: int) -> None:
        found = d_nodes[0, begin:], d_nodes[1, begin:], d_density[begin:]
        edges_back(column, row, density, cotangent, right, begin, end, *found)

    def narrow(begin: int, end: int) -> None:
        found = (part[begin:] for part in d_nodes)
        densities_back(*mesh, cotangent, d_density, begin, min(end, rows - 1), *found)

    for work in (look, narrow):
        _run_apart(work, at)
    result = np.empty_like(nodes)
    result[2] = d_nodes[2, :rows]

    def move(part: int) -> None:
        for k in range(2):
            shift_back(nodes[k], parted, d_nodes[k], at[part], at[part + 1], result[k])

    threads.run(move, len(at) - 1)
    return result


def _run_apart(work: Callable[[int, int], None], at: list[int]) -> None:
    """Work on parts at the same time, each of which also writes to the row behind its own."""
    threads.run(lambda part: work(at[part], at[part + 1] - 1), len(at) - 1)
    for end in at[1:]:  # the last row of a part writes to the first one of the next
        work(end - 1, end)
