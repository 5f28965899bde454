"""Beams of light onto pixels, exactly, by what crosses their edges; and the adjoint.

By Green's theorem the light of a triangle in a pixel is a sum over the edges of the triangle. An
edge that two triangles share is walked once, with the difference of their densities. It adds to
the pixels that it crosses; what all pixels to the right of these get is a sum along the row, done
at the end, once for all edges. Fonts are drawn like this. No triangle is ever clipped.

Triangles carry a sign: one that is folded over has a negative area, so a negative density, and the
product is light again. All of it is computed in float64: where the density is high, the sum along a
row cancels.

In each cell of nodes [i, i+1] × [j, j+1] the diagonal begins at (i, j) where i + j is even, else at
(i+1, j): errors by the twist of the light cancel between neighbours. Grids of several that lie side
by side are drawn one by one. Triangle 0 holds the edge from
(i, j) to (i+1, j), triangle 1 the opposite one.
"""

import numpy as np

from workbench.compiled import jit
from workbench.optics.kernels.beam_edge import add_edge, see_edge

_ZERO, _ONE, _TWO = (np.uintp(k) for k in range(3))

# A triangle that is narrower than this, in pixels, lights the one pixel in which its middle is. Its
# width is its area by its length, or by a pixel if it is shorter. Where the light of a long one is
# in a pixel would be a difference of great numbers, and its gradient that of greater ones: with
# 1e-7 rounding changes a gradient of 13 × 13 × 48² cells by 3e-5, with 1e-6 by 3e-7.
SLIVER = 1e-6
# Pixels with less than this part of all light are dark: so much is the rounding of sums along rows.
ROUNDING = 1e-15
# Hits further from the image than this, in pixels, stay there: nothing overflows.
FARTHEST = 1e7


@jit(allocates=False, error_model="numpy", forceinline=True)
def _corners(i, j, triangle):  # type: ignore[no-untyped-def]
    """Nodes of a triangle, in the order of its edges."""
    if (i + j) % 2 == 0:
        if triangle == 0:
            return i, j, i + 1, j, i + 1, j + 1
        return i, j, i + 1, j + 1, i, j + 1
    if triangle == 0:
        return i, j, i + 1, j, i, j + 1
    return i + 1, j, i + 1, j + 1, i, j + 1


@jit(allocates=False, error_model="numpy", forceinline=True)
def _is_sliver(x_1, y_1, x_2, y_2, area):  # type: ignore[no-untyped-def]
    """Whether a triangle is too narrow to be drawn; it is given by two of its sides."""
    length = max(abs(x_1), abs(y_1), abs(x_2), abs(y_2), 1.0)
    return abs(area) <= SLIVER * length


@jit(allocates=False, error_model="numpy", forceinline=True)
def _half_flux(flux, parts, i, j):  # type: ignore[no-untyped-def]
    """Flux of each of the two triangles of a cell."""
    along_u, along_v = parts
    low, high = along_v[j, 1], along_v[j + 1, 0]
    return 0.5 * (
        along_u[i, 1] * (low * flux[i, j] + high * flux[i, j + 1])
        + along_u[i + 1, 0] * (low * flux[i + 1, j] + high * flux[i + 1, j + 1])
    )


@jit(allocates=False, error_model="numpy")
def densities(column, row, flux, parts, begin, end, density, image):  # type: ignore[no-untyped-def]
    """Flux per area of triangles, for cells with numbers from ``begin`` to ``end`` along u.

    `column`, `row` (n + 1, m + 1): hits of the nodes; infinite for those without; `flux` (n + 1, m
    + 1): flux of the nodes; those at the rim have a half or a quarter of a cell's; `parts` (n + 1,
    3) and (m + 1, 3): parts of a node's flux that go to the cells before and behind it along u, and
    along v; and 1 for nodes between two cells of equal width; `begin`, `end`: which cells;
    `density` (n + 2, m + 2, 2): the result: flux per pixel area, with the sign of the area; 0 where
    there is none, and in a ring of cells around all others, so that each edge lies between two;
    `image` (n_y, n_x): triangles that are too narrow are added to it. Returns flux of all triangles
    whose corners hit the plane, on the image or beside it.
    """
    lands = 0.0
    for i in range(begin, end):
        for j in range(column.shape[1] - 1):
            half = _half_flux(flux, parts, i, j)
            for triangle in range(2):
                a, b, c, d, e, f = _corners(i, j, triangle)
                x, y = column[a, b], row[a, b]
                x_1, y_1 = column[c, d] - x, row[c, d] - y
                x_2, y_2 = column[e, f] - x, row[e, f] - y
                area = 0.5 * (x_1 * y_2 - x_2 * y_1)
                if not np.isfinite(area):
                    density[i + 1, j + 1, triangle] = 0.0
                    continue
                lands += half
                if not _is_sliver(x_1, y_1, x_2, y_2, area):
                    density[i + 1, j + 1, triangle] = half / area
                    continue
                density[i + 1, j + 1, triangle] = 0.0
                x, y = x + (x_1 + x_2) / 3, y + (y_1 + y_2) / 3
                if 0 <= x < image.shape[1] and 0 <= y < image.shape[0]:
                    image[int(y), int(x)] += half
    return lands


@jit(allocates=False, error_model="numpy", forceinline=True)
def _edge(kind, i, j):  # type: ignore[no-untyped-def]
    """One of the three edges that belong to a node: along u, along v, or the cell's diagonal."""
    even = (i + j) % _TWO == _ZERO
    one = _ONE  # cell (i, j) comes behind the ring
    if kind == 0:
        return i, j, i + one, j, i + one, j + one, _ZERO, i + one, j, _ONE
    if kind == 1:
        which = _ONE if even else _ZERO
        return i, j, i, j + one, i, j + one, which, i + one, j + one, which
    if even:
        return i, j, i + one, j + one, i + one, j + one, _ONE, i + one, j + one, _ZERO
    return i + one, j, i, j + one, i + one, j + one, _ZERO, i + one, j + one, _ONE


@jit(allocates=False, error_model="numpy")
def add_edges(column, row, density, begin, end, steps):  # type: ignore[no-untyped-def]
    """Add what crosses the edges that belong to nodes from ``begin`` to ``end`` along u.

    `column`, `row`, `density`: see `densities`; `begin`, `end`: which nodes; `steps` (n_y, n_x +
    1): changed; minus its sums along rows are the image.
    """
    count_i, count_j = np.uintp(column.shape[0] - 1), np.uintp(column.shape[1] - 1)
    for i in range(np.uintp(begin), np.uintp(end)):
        for j in range(count_j + _ONE):
            for kind in range(3):
                if (i == count_i and kind != 1) or (j == count_j and kind != 0):
                    continue
                a, b, c, d, k, l, m, n, o, p = _edge(kind, i, j)  # noqa: E741
                jump = density[k, l, m] - density[n, o, p]
                add_edge(column[a, b], row[a, b], column[c, d], row[c, d], jump, steps)


@jit(allocates=False, error_model="numpy")
def edges_back(column, row, density, cotangent, right, begin, end, d_column, d_row, d_density):  # type: ignore[no-untyped-def]
    """Adjoint of `add_edges`, for nodes from ``begin`` to ``end`` along u.

    `column`, `row`, `density`: see `densities`; `cotangent` (n_y, n_x): cotangent of the image;
    `right` (n_y, n_x + 1): its sums over all pixels from each one to the right end of the row;
    `begin`, `end`: which nodes; `d_column`, `d_row` (end - begin + 1, m + 1): cotangents of the
    hits of these nodes and the next ones; changed; `d_density` (end - begin + 1, m + 2, 2): those
    of the densities in the cells before these nodes, and behind them; changed.
    """
    count_i, count_j = np.uintp(column.shape[0] - 1), np.uintp(column.shape[1] - 1)
    first = np.uintp(begin)
    for i in range(first, np.uintp(end)):
        for j in range(count_j + _ONE):
            for kind in range(3):
                if (i == count_i and kind != 1) or (j == count_j and kind != 0):
                    continue
                a, b, c, d, k, l, m, n, o, p = _edge(kind, i, j)  # noqa: E741
                x, y, to_x, to_y = column[a, b], row[a, b], column[c, d], row[c, d]
                if not (abs(x + y) < np.inf and abs(to_x + to_y) < np.inf):
                    continue
                beside, from_start, to_end = see_edge(x, y, to_x, to_y, cotangent, right)
                jump = density[k, l, m] - density[n, o, p]
                across_x, across_y = (to_y - y) * jump, (x - to_x) * jump
                a, c, k, n = a - first, c - first, k - first, n - first
                d_column[a, b] += across_x * from_start
                d_row[a, b] += across_y * from_start
                d_column[c, d] += across_x * to_end
                d_row[c, d] += across_y * to_end
                d_density[k, l, m] -= beside
                d_density[n, o, p] += beside


@jit(allocates=False, error_model="numpy")
def densities_back(  # type: ignore[no-untyped-def]
    column, row, density, parts, cotangent, d_density, begin, end, d_column, d_row, d_flux
):
    """Adjoint of `densities`, for cells with numbers from ``begin`` to ``end`` along u.

    `column`, `row`, `density`, `parts`, `cotangent`, `begin`, `end`: see `densities` and
    `edges_back`; `d_density` (n + 2, m + 2, 2): cotangent of the densities; `d_column`, `d_row`,
    `d_flux` (end - begin + 1, m + 1): those of the nodes from ``begin`` on; changed.
    """
    along_u, along_v = parts
    for i in range(begin, end):
        left, right = along_u[i, 1], along_u[i + 1, 0]
        for j in range(column.shape[1] - 1):
            below, above = along_v[j, 1], along_v[j + 1, 0]
            d_half = 0.0
            for triangle in range(2):
                a, b, c, d, e, f = _corners(i, j, triangle)
                x, y = column[a, b], row[a, b]
                x_1, y_1 = column[c, d] - x, row[c, d] - y
                x_2, y_2 = column[e, f] - x, row[e, f] - y
                area = 0.5 * (x_1 * y_2 - x_2 * y_1)
                if not np.isfinite(area):
                    continue
                if _is_sliver(x_1, y_1, x_2, y_2, area):
                    x, y = x + (x_1 + x_2) / 3, y + (y_1 + y_2) / 3
                    if 0 <= x < cotangent.shape[1] and 0 <= y < cotangent.shape[0]:
                        d_half += cotangent[int(y), int(x)]
                    continue
                mean = d_density[i + 1, j + 1, triangle] / area  # over the triangle
                d_half += mean
                d_area = -0.5 * mean * density[i + 1, j + 1, triangle]
                a, c, e = a - begin, c - begin, e - begin
                d_column[a, b] -= d_area * (y_2 - y_1)
                d_column[c, d] += d_area * y_2
                d_column[e, f] -= d_area * y_1
                d_row[a, b] += d_area * (x_2 - x_1)
                d_row[c, d] -= d_area * x_2
                d_row[e, f] += d_area * x_1
            d_half *= 0.5
            k = i - begin
            d_flux[k, j] += left * below * d_half
            d_flux[k, j + 1] += left * above * d_half
            d_flux[k + 1, j] += right * below * d_half
            d_flux[k + 1, j + 1] += right * above * d_half
