"""Beams of light onto pixels, row by row of a beam mesh; and the adjoint.

Each cell between nodes (i, j) and (i + 1, j + 1) is two triangles of equal flux. A triangle whose
corners are in one pixel adds its flux there, whatever its shape, and its corners have no gradient;
on fine meshes most triangles are such. One whose corners are in two neighbouring pixels is cut by
the border between them. For all others Green's theorem applies: the light of a triangle in a pixel
is a sum over its edges. An edge that two triangles share is walked once, with the difference of
their densities. It adds to the pixels that it crosses; what all pixels to the right of these get is
a sum along the row, done at the end, once for all edges.

Triangles carry a sign: one that is folded over has a negative area, so a negative density, and the
product is light again. All of it is computed in float64: where the density is high, the sum along a
row cancels.

The diagonal of a cell begins at (i, j) where i + j is even, else at (i + 1, j): errors by the twist
of the light cancel between neighbours. Grids that lie side by side count i anew. Triangle 0 holds
the edge from (i, j) to (i + 1, j), triangle 1 the opposite one.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.beam_cells import (
    RING,
    add_cells,
    cells_back,
    flux_back,
    is_inner,
    load,
    make_rings,
    no_cells,
    turn_of,
)
from workbench.optics.kernels.beam_edge import add_edge, see_edge
from workbench.optics.kernels.node_shift import count_shift, shift_back

# Pixels with less than this part of all light are dark: so much is the rounding of sums along rows.
ROUNDING = 1e-15


@jit(allocates=False, error_model="numpy", forceinline=True)
def _list_edges(mesh, i, rings, edges):  # type: ignore[no-untyped-def]
    """List the edges of triangles with a density that begin at a row of nodes; returns how many.

    `mesh`: see `Mesh`; `edges` (5 m, 4): nodes from and to, and triangles on both sides, as
    numbers within the flat rings; changed.
    """
    density, counts, m = rings.density, rings.counts, np.int64(rings.numbers.shape[1])
    k, before, after = i % RING, (i - 1) % RING, (i + 1) % RING
    here, above = density[k], density[before]
    turn, turn_above = turn_of(mesh, i), turn_of(mesh, max(i - 1, 0))
    nodes, next_nodes, cells, cells_above = k * m, after * m, 2 * k * (m + 1), 2 * before * (m + 1)
    count = 0
    for place in range(counts[k]):
        j = np.int64(rings.cells[k, place])
        o, even = j + 1, (j + turn) % 2 == 0
        below = 1 if even else 0
        over = 0 if (j + turn_above) % 2 == 0 else 1
        if here[o, 0] != 0.0 or here[j, 1] != 0.0:
            _put_edge(edges, count, nodes + j, next_nodes + j, cells + 2 * o, cells + 2 * j + 1)
            count += 1
        if above[o, over] != 0.0 or here[o, below] != 0.0:
            sides = cells_above + 2 * o + over, cells + 2 * o + below
            _put_edge(edges, count, nodes + j, nodes + o, *sides)
            count += 1
        start, end = (nodes + j, next_nodes + o) if even else (next_nodes + j, nodes + o)
        _put_edge(edges, count, start, end, cells + 2 * o + below, cells + 2 * o + 1 - below)
        count += 1
        if here[o, 1] != 0.0 and here[o + 1, 0] == 0.0 and here[o + 1, 1] == 0.0:
            sides = cells + 2 * o + 2, cells + 2 * o + 1
            _put_edge(edges, count, nodes + o, next_nodes + o, *sides)
            count += 1
    for place in range(counts[before]):
        j = np.int64(rings.cells[before, place])
        o, over = j + 1, 0 if (j + turn_above) % 2 == 0 else 1
        if above[o, over] != 0.0 and here[o, 0] == 0.0 and here[o, 1] == 0.0:
            sides = cells_above + 2 * o + over, cells + 2 * o
            _put_edge(edges, count, nodes + j, nodes + o, *sides)
            count += 1
    return count


@jit(allocates=False, error_model="numpy", forceinline=True)
def _put_edge(edges, number, start, end, plus, minus):  # type: ignore[no-untyped-def]
    edges[number, 0], edges[number, 1] = start, end
    edges[number, 2], edges[number, 3] = plus, minus


@jit(allocates=False, error_model="numpy", forceinline=True)
def _of_edge(edges, number):  # type: ignore[no-untyped-def]
    """Nodes and triangles of an edge, as `_list_edges` puts them."""
    return (
        np.uintp(edges[number, 0]), np.uintp(edges[number, 1]),
        np.uintp(edges[number, 2]), np.uintp(edges[number, 3]),
    )  # fmt: skip


@jit(error_model="numpy")
def _flat(places):  # type: ignore[no-untyped-def]
    return places[0].reshape(-1), places[1].reshape(-1)


@jit(error_model="numpy")
def draw(mesh, begin, end, image, steps):  # type: ignore[no-untyped-def]
    """Add the light of some rows of cells to an image.

    `mesh`: see `Mesh`; `begin`, `end`: which rows of nodes; the cells behind them are drawn, and
    all edges that begin there; `image` (n_y (n_x + 1),): light of triangles without edges; changed;
    `steps` (n_y, n_x + 1): changed; minus its sums along rows is all other light. Returns the flux
    of all triangles whose corners hit the plane, on the image or beside it.
    """
    n, m = mesh.column.shape
    rings = make_rings(m)
    edges, (x, y) = np.empty((5 * m, 4), np.int32), _flat(rings.places)
    density, size, lands = rings.density.reshape(-1), (steps.shape[0], steps.shape[1] - 1), 0.0
    if begin > 0:
        load(mesh, begin - 1, size, rings)
    load(mesh, begin, size, rings)
    if begin > 0:
        add_cells(mesh, begin - 1, rings, image[:0], size)
    for i in range(begin, end):
        if i + 1 < n:
            load(mesh, i + 1, size, rings)
            lands += add_cells(mesh, i, rings, image, size)
        else:
            no_cells(i, rings)
        for edge in range(_list_edges(mesh, i, rings, edges)):
            a, b, plus, minus = _of_edge(edges, edge)
            add_edge(x[a], y[a], x[b], y[b], density[plus] - density[minus], steps)
    return lands


@jit(error_model="numpy")
def draw_back(mesh, begin, end, cotangent, seen, right, result):  # type: ignore[no-untyped-def]
    """Adjoint of `draw`, for some rows of nodes.

    `mesh`: see `Mesh`; `begin`, `end`: which rows of nodes; `cotangent` (n_y, n_x): of the image;
    `seen` (n_y (n_x + 1),): the same with a pixel more in each row; `right` (n_y, n_x + 1): its
    sums over all pixels from each one to the right end of the row; `result` (3, n, m): cotangents
    of columns, rows and flux of these nodes; changed.
    """
    n, m = mesh.column.shape
    rings = make_rings(m)
    edges, (x, y) = np.empty((5 * m, 4), np.int32), _flat(rings.places)
    moved, d_flux = np.zeros((2, RING, m)), np.zeros((RING, m))
    d_density = np.zeros((RING, m + 1, 2))
    (d_x, d_y), density, d_flat = _flat(moved), rings.density.reshape(-1), d_density.reshape(-1)
    shifts, d_cell, along = np.zeros((2, RING, m)), np.zeros(m - 1), np.empty(m)
    size, none = cotangent.shape, seen[:0]
    # Cotangents of a row of nodes are complete after the edges of the next row, and those of its
    # hits after one row more, because the shifts of both neighbours count there.
    first = max(begin - 2, 0)
    load(mesh, first, size, rings)
    for i in range(first, min(end + 2, n + 2)):
        k, before, after = i % RING, (i - 1) % RING, (i + 1) % RING
        if i + 1 < n:
            load(mesh, i + 1, size, rings)
            add_cells(mesh, i, rings, none, size)
        else:
            no_cells(i, rings)
        moved[0, after], moved[1, after], d_flux[after], d_density[k] = 0.0, 0.0, 0.0, 0.0
        count = _list_edges(mesh, i, rings, edges) if i < n else 0
        for edge in range(count):
            a, b, plus, minus = _of_edge(edges, edge)
            beside, from_start, to_end = see_edge(x[a], y[a], x[b], y[b], cotangent, right)
            jump = density[plus] - density[minus]
            across_x, across_y = (y[b] - y[a]) * jump, (x[a] - x[b]) * jump
            d_x[a] += across_x * from_start
            d_y[a] += across_y * from_start
            d_x[b] += across_x * to_end
            d_y[b] += across_y * to_end
            d_flat[plus] -= beside
            d_flat[minus] += beside
        if first < i < n:
            cells_back(mesh, i - 1, rings, seen, size, d_density, moved, d_cell)
            flux_back(mesh, i - 1, d_cell, d_flux)
        if i > n:
            shifts[0, before], shifts[1, before] = 0.0, 0.0
        elif i > 0:
            inner = is_inner(mesh, i - 1)
            count_shift(mesh.column, i - 1, inner, moved[0, before], shifts[0, before])
            count_shift(mesh.row, i - 1, inner, moved[1, before], shifts[1, before])
        if begin <= i - 2 < end:
            row = (i - 2) % RING
            for axis, hits in ((0, mesh.column), (1, mesh.row)):
                some = shifts[axis]
                each = some[(i - 3) % RING], some[row], some[before]
                shift_back(
                    hits, mesh.along_u, i - 2, moved[axis, row], each, along, result[axis, i - 2]
                )
            result[2, i - 2] = d_flux[row]
