"""Beams of light onto pixels, row by row of a beam mesh; and the adjoint.

Each cell between nodes (i, j) and (i + 1, j + 1) is two triangles of equal flux. A cell whose
corners are in one pixel adds its flux there, whatever its shape, and its corners have no gradient;
on fine meshes most cells are such. The triangles of a cell in two neighbouring pixels are cut by
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
    densities_back,
    flux_back,
    is_inner,
    load,
    make_rings,
    no_cells,
    see_cells,
    turn_of,
)
from workbench.optics.kernels.beam_edge import add_edge, see_edge
from workbench.optics.kernels.node_shift import count_shift, shift_back

# Pixels with less than this part of all light are dark: so much is the rounding of sums along rows.
ROUNDING = 1e-15


@jit(allocates=False, error_model="numpy", forceinline=True)
def _rows(mesh, i, m):  # type: ignore[no-untyped-def]
    """Where rows begin in the flat rings, of nodes and of triangles, and turns of rows of cells.

    Nodes of row i and of the next one; triangles behind row i and before it; their turns.
    """
    k, before, after = i % RING, (i - 1) % RING, (i + 1) % RING
    turns = turn_of(mesh, i), turn_of(mesh, max(i - 1, 0))
    return k * m, after * m, 2 * k * (m + 1), 2 * before * (m + 1), turns


@jit(allocates=False, error_model="numpy", forceinline=True)
def _edge(rows, j, which):  # type: ignore[no-untyped-def]
    """Nodes from and to of an edge of a cell, and triangles on both sides, in the flat rings.

    `which`: 0 before it along u, 1 before it along v, 2 its diagonal, 3 behind it along u.
    """
    nodes, following, cells, above, (turn, turn_above) = rows
    o, below = j + 1, 1 - (j + turn) % 2
    if which == 0:
        return nodes + j, following + j, cells + 2 * o, cells + 2 * j + 1
    if which == 1:
        return nodes + j, nodes + o, above + 2 * o + (j + turn_above) % 2, cells + 2 * o + below
    if which == 3:
        return nodes + o, following + o, cells + 2 * o + 2, cells + 2 * o + 1
    start, end = (nodes + j, following + o) if below == 1 else (following + j, nodes + o)
    return start, end, cells + 2 * o + below, cells + 2 * o + 1 - below


@jit(allocates=False, error_model="numpy", forceinline=True)
def _is_empty(density, rows, j):  # type: ignore[no-untyped-def]
    """Whether a cell behind a row of nodes has no triangle with a density."""
    cell = rows[2] + 2 * (j + 1)
    return density[cell] == 0.0 and density[cell + 1] == 0.0


@jit(allocates=False, error_model="numpy", forceinline=True)
def _add(edge, places, density, steps):  # type: ignore[no-untyped-def]
    (x, y), (a, b, plus, minus) = places, edge
    add_edge(x[a], y[a], x[b], y[b], density[plus] - density[minus], steps)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _see(edge, places, density, cotangents, moved, d_density):  # type: ignore[no-untyped-def]
    """Adjoint of `_add`."""
    (x, y), (a, b, plus, minus), (d_x, d_y) = places, edge, moved
    if density[plus] == 0.0 and density[minus] == 0.0:
        return
    cotangent, right = cotangents
    beside, from_start, to_end = see_edge(x[a], y[a], x[b], y[b], cotangent, right)
    jump = density[plus] - density[minus]
    across_x, across_y = (y[b] - y[a]) * jump, (x[a] - x[b]) * jump
    d_x[a] += across_x * from_start
    d_y[a] += across_y * from_start
    d_x[b] += across_x * to_end
    d_y[b] += across_y * to_end
    d_density[plus] -= beside
    d_density[minus] += beside


@jit(error_model="numpy")
def _flat(places):  # type: ignore[no-untyped-def]
    return places[0].reshape(-1), places[1].reshape(-1)


@jit(error_model="numpy")
def draw(mesh, begin, end, image, steps):  # type: ignore[no-untyped-def]
    """Add the light of some rows of cells to an image.

    `mesh`: see `Mesh`; `begin`, `end`: which rows of cells; edges between them and others are
    walked for their own side; `image` (n_y (n_x + 1),): light of triangles without edges; changed;
    `steps` (n_y, n_x + 1): changed; minus its sums along rows is all other light. Returns the flux
    of all triangles whose corners hit the plane, on the image or beside it.
    """
    m = mesh.column.shape[1]
    rings = make_rings(m)
    places, density = _flat(rings.places), rings.density.reshape(-1)
    size, lands = (steps.shape[0], steps.shape[1] - 1), 0.0
    load(mesh, begin, size, rings)
    for i in range(begin, end + 1):
        if i < end:
            load(mesh, i + 1, size, rings)
            lands += add_cells(mesh, i, rings, image, steps)
        else:
            no_cells(i, rings)
        rows, here, above = _rows(mesh, i, m), rings.cells[i % RING], rings.cells[(i - 1) % RING]
        for place in range(rings.counts[i % RING]):
            j = np.int64(here[place])
            for which in range(3):
                _add(_edge(rows, j, which), places, density, steps)
            if _is_empty(density, rows, j + 1):  # else the next cell adds it
                _add(_edge(rows, j, 3), places, density, steps)
        for place in range(rings.counts[(i - 1) % RING]):
            j = np.int64(above[place])
            if _is_empty(density, rows, j):
                _add(_edge(rows, j, 1), places, density, steps)
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
    moved, d_flux = np.zeros((2, RING, m)), np.zeros((RING, m))
    d_density = np.zeros((RING, m + 1, 2))
    places, d_places, seen_by = _flat(rings.places), _flat(moved), (cotangent, right)
    density, d_flat = rings.density.reshape(-1), d_density.reshape(-1)
    shifts, d_cells, along = np.zeros((2, RING, m)), np.zeros((RING, m - 1)), np.empty(m)
    size = cotangent.shape
    # Cotangents of a row of nodes are complete after the edges of the next row, and those of its
    # hits after one row more, because the shifts of both neighbours count there.
    first = max(begin - 2, 0)
    load(mesh, first, size, rings)
    for i in range(first, min(end + 2, n + 2)):
        k, before, after = i % RING, (i - 1) % RING, (i + 1) % RING
        moved[0, after], moved[1, after], d_flux[after], d_density[k] = 0.0, 0.0, 0.0, 0.0
        if i + 1 < n:
            load(mesh, i + 1, size, rings)
            see_cells(mesh, i, rings, seen, seen_by, moved, d_cells[k])
        else:
            no_cells(i, rings)
        if i < n:
            rows, here, above = _rows(mesh, i, m), rings.cells[k], rings.cells[before]
            for place in range(rings.counts[k]):
                j = np.int64(here[place])
                for which in range(3):
                    _see(_edge(rows, j, which), places, density, seen_by, d_places, d_flat)
                if _is_empty(density, rows, j + 1):
                    _see(_edge(rows, j, 3), places, density, seen_by, d_places, d_flat)
            for place in range(rings.counts[before]):
                j = np.int64(above[place])
                if _is_empty(density, rows, j):
                    _see(_edge(rows, j, 1), places, density, seen_by, d_places, d_flat)
        if first < i < n:
            densities_back(mesh, i - 1, rings, d_density, moved, d_cells[before])
            flux_back(mesh, i - 1, d_cells[before], d_flux)
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
