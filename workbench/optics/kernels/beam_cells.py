"""The triangles of a beam mesh that light pixels without edges, row by row; and the adjoint.

See `workbench.optics.kernels.beam_raster`. Only a few rows are kept at a time, in rings of ``RING``
rows: row i is at i % RING.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import AnyArray, Index
from workbench.compiled import jit
from workbench.optics.kernels.beam_edge import add_sliver, is_sliver, see_sliver
from workbench.optics.kernels.node_shift import shift

RING = 4
_NOWHERE = -16
_ONE = np.uintp(1)


class Mesh(NamedTuple):
    """A beam mesh.

    `column`, `row`, `flux` (n, m): of the nodes, in pixels; infinite hits for those without;
    `along_v` (n, 3), `along_u` (m, 3): parts of a node's flux that belong to the cells before and
    behind it, and 1 for nodes between two cells of equal width, along both axes; `turn` (n,): 1 for
    odd rows of the grid that they belong to. Of several grids that are alike, ``along_v`` and
    ``turn`` have the rows of one.
    """

    column: AnyArray
    row: AnyArray
    flux: AnyArray
    along_v: AnyArray
    along_u: AnyArray
    turn: Index


class Rings(NamedTuple):
    """The rows of a mesh that are at work, each (RING, …).

    `places` (2, RING, m): shifted columns and rows of the nodes; `numbers` (RING, m): of the pixels
    of the nodes; below 0 beside the image; `pairs` (RING, m - 1): those of neighbours along u that
    are in one pixel; `flux` (RING, m - 1): what nodes give to the cells behind them along u;
    `density` (RING, m + 1, 2): flux per area of the triangles of the cells, from one before the
    first cell to one behind the last; 0 for those that need no edges; `cells` (RING, m): which
    cells need edges; `counts` (RING,): how many.
    """

    places: AnyArray
    numbers: npt.NDArray[np.int32]
    pairs: npt.NDArray[np.int32]
    flux: AnyArray
    density: AnyArray
    cells: npt.NDArray[np.int32]
    counts: Index


@jit(allocates=False, error_model="numpy", forceinline=True)
def is_inner(mesh, i):  # type: ignore[no-untyped-def]
    """Whether a row of nodes lies between two rows of cells of equal width."""
    return mesh.along_v[i % len(mesh.along_v), 2] > 0.0


@jit(allocates=False, error_model="numpy", forceinline=True)
def turn_of(mesh, i):  # type: ignore[no-untyped-def]
    """1 for an odd row of a grid."""
    return mesh.turn[i % len(mesh.turn)]


@jit(allocates=False, error_model="numpy", forceinline=True)
def _parts(mesh, i):  # type: ignore[no-untyped-def]
    """Parts of the flux of two rows of nodes that belong to the cells between them."""
    count = len(mesh.along_v)
    return mesh.along_v[i % count, 1], mesh.along_v[(i + 1) % count, 0]


@jit(error_model="numpy")
def make_rings(m):  # type: ignore[no-untyped-def]
    """Return rings for rows of so many nodes."""
    numbers, pairs = np.empty((RING, m), np.int32), np.empty((RING, m - 1), np.int32)
    cells, counts = np.empty((RING, m), np.int32), np.zeros(RING, np.int64)
    places, flux = np.empty((2, RING, m)), np.empty((RING, m - 1))
    return Rings(places, numbers, pairs, flux, np.zeros((RING, m + 1, 2)), cells, counts)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _number(column, row, n_x, n_y, numbers):  # type: ignore[no-untyped-def]
    """Numbers of the pixels of a row of nodes; below 0 beside the image, by the side.

    Rows of the image have a pixel more than it shows, so that neighbours by number are neighbours.
    """
    last_x, last_y, width = np.float64(n_x), np.float64(n_y), np.int32(n_x + 1)
    for j in range(np.uintp(column.shape[0])):
        x, y = column[j], row[j]
        beside = np.int32(0)
        beside += np.int32(1) if x < 0.0 else np.int32(0)
        beside += np.int32(2) if x >= last_x else np.int32(0)
        beside += np.int32(4) if y < 0.0 else np.int32(0)
        beside += np.int32(8) if y >= last_y else np.int32(0)
        x_in, y_in = min(max(x, 0.0), last_x - 1.0), min(max(y, 0.0), last_y - 1.0)
        pixel = np.int32(y_in) * width + np.int32(x_in)
        number = -beside if beside > np.int32(0) else pixel
        numbers[j] = number if abs(x) + abs(y) < np.inf else np.int32(_NOWHERE)


@jit(allocates=False, error_model="numpy", forceinline=True)
def load(mesh, i, size, rings):  # type: ignore[no-untyped-def]
    """Put a row of nodes into the rings."""
    k = np.uintp(i % RING)
    columns, rows = rings.places[0, k], rings.places[1, k]
    numbers, pairs, flux = rings.numbers[k], rings.pairs[k], rings.flux[k]
    inner = is_inner(mesh, i)
    shift(mesh.column, mesh.along_u, i, inner, columns)
    shift(mesh.row, mesh.along_u, i, inner, rows)
    _number(columns, rows, size[1], size[0], numbers)
    none, own, along_u = np.int32(-100 - k), mesh.flux[i], mesh.along_u
    for j in range(np.uintp(len(pairs))):
        pairs[j] = numbers[j] if numbers[j] == numbers[j + _ONE] else none
    for j in range(np.uintp(len(flux))):
        flux[j] = along_u[j, 1] * own[j] + along_u[j + _ONE, 0] * own[j + _ONE]


@jit(allocates=False, error_model="numpy", forceinline=True)
def _corners(even, triangle, before, after):  # type: ignore[no-untyped-def]
    """Nodes of a triangle of a cell between two rows, in the order of its edges: row and step."""
    if triangle == 0:
        return before, 0, after, 0, after if even else before, 1
    return before if even else after, 0, after, 1, before, 1


@jit(allocates=False, error_model="numpy", forceinline=True)
def _at(values, j, corners):  # type: ignore[no-untyped-def]
    """Values at the corners of a triangle."""
    a, b, c, d, e, f = corners
    return values[a, j + np.uintp(b)], values[c, j + np.uintp(d)], values[e, j + np.uintp(f)]


@jit(allocates=False, error_model="numpy", forceinline=True)
def _sides(places, j, corners):  # type: ignore[no-untyped-def]
    """First corner of a triangle, two of its sides, and its area."""
    x, x_1, x_2 = _at(places[0], j, corners)
    y, y_1, y_2 = _at(places[1], j, corners)
    x_1, y_1, x_2, y_2 = x_1 - x, y_1 - y, x_2 - x, y_2 - y
    return x, y, x_1, y_1, x_2, y_2, 0.5 * (x_1 * y_2 - x_2 * y_1)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _axis(numbers, before, after, j, width):  # type: ignore[no-untyped-def]
    """Axis along which a cell is in two neighbouring pixels, or in one; −1 if it is in others.

    `width`: numbers from a pixel to the next one along axis 1.
    """
    p, q = numbers[before, j], numbers[before, j + _ONE]
    r, s = numbers[after, j], numbers[after, j + _ONE]
    low, high = min(min(p, q), min(r, s)), max(max(p, q), max(r, s))
    apart = high - low
    between = (p - low) * (high - p) + (q - low) * (high - q)
    between += (r - low) * (high - r) + (s - low) * (high - s)
    if low < 0 or between != 0 or (apart > 1 and apart != width):
        return -1
    return 0 if apart <= 1 else 1


@jit(allocates=False, error_model="numpy", forceinline=True)
def _alone(p, q, r):  # type: ignore[no-untyped-def]
    """Which of three numbers, two of which are equal, is alone: their turn so that it is first."""
    return 0 if q == r else 1 if p == r else 2


@jit(allocates=False, error_model="numpy", forceinline=True)
def _turned(turn, p, q, r):  # type: ignore[no-untyped-def]
    if turn == 0:
        return p, q, r
    if turn == 1:
        return q, r, p
    return r, p, q


@jit(allocates=False, error_model="numpy", forceinline=True)
def _cut(places, axis, j, corners, turn):  # type: ignore[no-untyped-def]
    """Distances of the corners of a triangle from the border of pixels that cuts it.

    That of the corner which is alone on its side comes first.
    """
    p, q, r = _at(places[axis], j, corners)
    border = np.floor(max(p, q, r))
    return _turned(turn, p - border, q - border, r - border)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _add_triangle(rings, j, corners, half, image, steps, axis):  # type: ignore[no-untyped-def]
    """Add the light of a triangle that needs no edges, or return its density; and what lands.

    `axis`: see `_axis`.
    """
    p, q, r = _at(rings.numbers, j, corners)
    if axis >= 0:
        turn = _alone(p, q, r)
        alone, other, _ = _turned(turn, p, q, r)
        x, y, z = _cut(rings.places, axis, j, corners, turn)
        below = (x - y) * (x - z) if alone != other else np.inf
        part = half * (x * x / below)
        image[alone] += part
        image[other] += half - part
        return 0.0, half
    if min(p, q, r) == _NOWHERE:
        return 0.0, 0.0
    if p < 0 and p == q and p == r:
        return 0.0, half
    x, y, x_1, y_1, x_2, y_2, area = _sides(rings.places, j, corners)
    if not is_sliver(x_1, y_1, x_2, y_2, area):
        return half / area, half
    add_sliver(x, y, x_1, y_1, x_2, y_2, half, steps)
    return 0.0, half


@jit(allocates=False, error_model="numpy", forceinline=True)
def add_cells(mesh, i, rings, image, steps):  # type: ignore[no-untyped-def]
    """Add the light of a row of cells that needs no edges, and list the cells that need some.

    `image` (n_y (n_x + 1),), `steps` (n_y, n_x + 1): changed; see `draw`. Returns the flux of all
    triangles whose corners hit the plane, on the image or beside it.
    """
    before, after = np.uintp(i % RING), np.uintp((i + 1) % RING)
    here, next, dense = rings.pairs[before], rings.pairs[after], rings.density[before]
    flux, flux_next, listed = rings.flux[before], rings.flux[after], rings.cells[before]
    first, second = _parts(mesh, i)
    dense[:] = 0.0
    count, lands, turn = 0, 0.0, turn_of(mesh, i)
    for j in range(np.uintp(len(here))):
        pixel, half = here[j], 0.5 * (first * flux[j] + second * flux_next[j])
        if pixel == next[j]:
            lands += 2.0 * half if pixel > _NOWHERE else 0.0
            if pixel >= 0:
                image[pixel] += 2.0 * half
        elif half != 0.0:
            axis = _axis(rings.numbers, before, after, j, np.int32(steps.shape[1]))
            even = (np.int64(j) + turn) % 2 == 0
            corners = _corners(even, 0, before, after)
            one, landed = _add_triangle(rings, j, corners, half, image, steps, axis)
            corners = _corners(even, 1, before, after)
            two, landed_two = _add_triangle(rings, j, corners, half, image, steps, axis)
            lands += landed + landed_two
            dense[j + _ONE, 0], dense[j + _ONE, 1] = one, two
            listed[count] = j
            count += 1 if one != 0.0 or two != 0.0 else 0
    rings.counts[before] = count
    return lands


@jit(allocates=False, error_model="numpy", forceinline=True)
def no_cells(i, rings):  # type: ignore[no-untyped-def]
    """Let a row of cells be empty: there is none."""
    rings.density[i % RING] = 0.0
    rings.counts[i % RING] = 0


@jit(allocates=False, error_model="numpy", forceinline=True)
def _put(values, j, corners, p, q, r):  # type: ignore[no-untyped-def]
    """Add to values at the corners of a triangle."""
    a, b, c, d, e, f = corners
    values[a, j + np.uintp(b)] += p
    values[c, j + np.uintp(d)] += q
    values[e, j + np.uintp(f)] += r


@jit(allocates=False, error_model="numpy", forceinline=True)
def _see_triangle(rings, j, corners, half, seen, cotangents, moved, axis):  # type: ignore[no-untyped-def]
    """Adjoint of `_add_triangle`: the density, or 0 and the cotangent of the flux."""
    p, q, r = _at(rings.numbers, j, corners)
    if axis >= 0:
        turn = _alone(p, q, r)
        alone, other, _ = _turned(turn, p, q, r)
        x, y, z = _cut(rings.places, axis, j, corners, turn)
        apart = alone != other
        by_y, by_z = 1.0 / (x - y if apart else np.inf), 1.0 / (x - z if apart else np.inf)
        each, differ = by_y * by_z, seen[alone] - seen[other]
        part = x * x * each
        d_y, d_z = half * differ * part * by_y, half * differ * part * by_z
        d_x = 2.0 * half * differ * x * each - d_y - d_z
        _put(moved[axis], j, corners, *_turned((3 - turn) % 3, d_x, d_y, d_z))
        return 0.0, seen[other] + part * differ
    if min(p, q, r) == _NOWHERE or (p < 0 and p == q and p == r):
        return 0.0, 0.0
    x, y, x_1, y_1, x_2, y_2, area = _sides(rings.places, j, corners)
    if half != 0.0 and not is_sliver(x_1, y_1, x_2, y_2, area):
        return half / area, 0.0
    d_x, d_y, mean = see_sliver(x, y, x_1, y_1, x_2, y_2, half, *cotangents)
    _put(moved[0], j, corners, *d_x)
    _put(moved[1], j, corners, *d_y)
    return 0.0, mean


@jit(allocates=False, error_model="numpy", forceinline=True)
def see_cells(mesh, i, rings, seen, cotangents, moved, d_cells):  # type: ignore[no-untyped-def]
    """Adjoint of `add_cells`, which lists the cells that need edges too.

    `seen` (n_y (n_x + 1),): cotangent of the image; `cotangents`: the same, and its sums; see
    `draw_back`; `moved` (2, RING, m): cotangents of hits; changed; `d_cells` (m - 1,): cotangents
    of the flux of cells; changed.
    """
    before, after = np.uintp(i % RING), np.uintp((i + 1) % RING)
    here, next, dense = rings.pairs[before], rings.pairs[after], rings.density[before]
    flux, flux_next, listed = rings.flux[before], rings.flux[after], rings.cells[before]
    (first, second), turn, count = _parts(mesh, i), turn_of(mesh, i), 0
    dense[:] = 0.0
    for j in range(np.uintp(len(here))):
        pixel = here[j]
        if pixel == next[j]:
            d_cells[j] = seen[pixel] if pixel >= 0 else 0.0
            continue
        half = 0.5 * (first * flux[j] + second * flux_next[j])
        axis = _axis(rings.numbers, before, after, j, np.int32(cotangents[1].shape[1]))
        even = (np.int64(j) + turn) % 2 == 0
        corners = _corners(even, 0, before, after)
        one, d_one = _see_triangle(rings, j, corners, half, seen, cotangents, moved, axis)
        corners = _corners(even, 1, before, after)
        two, d_two = _see_triangle(rings, j, corners, half, seen, cotangents, moved, axis)
        d_cells[j] = 0.5 * (d_one + d_two)
        dense[j + _ONE, 0], dense[j + _ONE, 1] = one, two
        listed[count] = j
        count += 1 if one != 0.0 or two != 0.0 else 0
    rings.counts[before] = count


@jit(allocates=False, error_model="numpy", forceinline=True)
def densities_back(mesh, i, rings, d_density, moved, d_cells):  # type: ignore[no-untyped-def]
    """Adjoint of the densities of a row of cells, by those of edges around them.

    `d_density` (RING, m + 1, 2): cotangents of densities; `moved`, `d_cells`: see `see_cells`.
    """
    before, after = np.uintp(i % RING), np.uintp((i + 1) % RING)
    turn, dense, d_dense = turn_of(mesh, i), rings.density[before], d_density[before]
    for place in range(rings.counts[before]):
        j = np.uintp(rings.cells[before, place])
        even = (np.int64(j) + turn) % 2 == 0
        for triangle in range(2):
            density = dense[j + _ONE, triangle]
            if density == 0.0:
                continue
            corners = _corners(even, triangle, before, after)
            _, _, x_1, y_1, x_2, y_2, area = _sides(rings.places, j, corners)
            mean = d_dense[j + _ONE, triangle] / area  # over the triangle
            d_area = -0.5 * mean * density
            _put(moved[0], j, corners, d_area * (y_1 - y_2), d_area * y_2, -d_area * y_1)
            _put(moved[1], j, corners, d_area * (x_2 - x_1), -d_area * x_2, d_area * x_1)
            d_cells[j] += 0.5 * mean


@jit(allocates=False, error_model="numpy", forceinline=True)
def flux_back(mesh, i, d_cell, d_flux):  # type: ignore[no-untyped-def]
    """Cotangents of the flux of two rows of nodes from those of the cells between them."""
    k, l = i % RING, (i + 1) % RING  # noqa: E741
    first, second = _parts(mesh, i)
    for j in range(np.uintp(len(d_cell))):
        d_flux[k, j] += first * mesh.along_u[j, 1] * d_cell[j]
        d_flux[l, j] += second * mesh.along_u[j, 1] * d_cell[j]
    for j in range(np.uintp(len(d_cell))):
        d_flux[k, j + _ONE] += first * mesh.along_u[j + _ONE, 0] * d_cell[j]
        d_flux[l, j + _ONE] += second * mesh.along_u[j + _ONE, 0] * d_cell[j]
