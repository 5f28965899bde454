"""Loops over cells: nodes are moved, and flux is spread evenly over triangles in pixels.

Each oriented edge adds what is to its right: by Green's theorem the edges of a triangle leave what
is inside of it, as in programs that fill the outlines of letters. So no polygon is clipped. Within
each row of pixels an edge adds its part to the pixels that it passes, and the same value to all
pixels behind it; a sum along the row adds the latter at the end.
"""

import numpy as np

from workbench.compiled import jit

# Triangles of less area, in pixels², are a point or a line: their light is in one pixel.
_SMALLEST = 1e-9


@jit(error_model="numpy")
def lift(nodes, flux, along):  # type: ignore[no-untyped-def]
    """Subtract a twelfth of the second differences along both axes.

    A linear interpolant of f on cells of width h errs by h² (f_uu + f_vv) / 12 in the mean, which
    shifts all light of a cell to one side. Without that, the light of a cell is only spread a
    little too wide or too narrow, which is even out over a pixel and more.

    At a rim of the light, only the difference along it is subtracted: the mean error of a chord of
    a curve is the same twelfth, so that the outline of the light keeps its place.

    Parameters
    ----------
    nodes : array, shape (m, n, 2)
        Places.
    flux : array, shape (m, n)
        Their flux; there is no place without it.
    along : tuple[bool, bool]
        Along which axes.

    Returns
    -------
    array, shape (m, n, 2)
        The moved places.
    """
    m, n = flux.shape
    lifted = np.empty_like(nodes)
    for i in range(m):
        for j in range(n):
            x, y = nodes[i, j, 0], nodes[i, j, 1]
            d_x = d_y = 0.0
            if along[0] and 0 < i < m - 1 and flux[i - 1, j] > 0 and flux[i + 1, j] > 0:
                d_x += nodes[i - 1, j, 0] - 2 * x + nodes[i + 1, j, 0]
                d_y += nodes[i - 1, j, 1] - 2 * y + nodes[i + 1, j, 1]
            if along[1] and 0 < j < n - 1 and flux[i, j - 1] > 0 and flux[i, j + 1] > 0:
                d_x += nodes[i, j - 1, 0] - 2 * x + nodes[i, j + 1, 0]
                d_y += nodes[i, j - 1, 1] - 2 * y + nodes[i, j + 1, 1]
            lifted[i, j, 0], lifted[i, j, 1] = x - d_x / 12, y - d_y / 12
    return lifted


@jit(error_model="numpy")
def fill_cells(nodes, flux, odd, canvas, mixed):  # type: ignore[no-untyped-def]
    """Add the light of cells between nodes, each split into two triangles.

    The diagonals change direction from cell to cell like the colours of a chessboard: a linear
    interpolant errs by the mixed second derivative, and in opposite directions in the two.

    Parameters
    ----------
    nodes : array, shape (m + 1, n + 1, 2)
        Column and row of each node on the screen, in pixels.
    flux : array, shape (m + 1, n + 1)
        Flux density at each node, times the area of a cell; 0 where no light comes to the screen.
    odd : int
        1 if the first cell is one whose diagonal goes from its last corner to its first, else 0.
    canvas : tuple of arrays
        Those of a canvas; get the light added.
    mixed : array of bool, shape (m, n)
        Set where light of some corners comes to the screen and that of others does not. Nothing is
        added for these cells.

    Returns
    -------
    float
        Flux of all cells that were added, light beside the screen included.
    """
    here, behind = canvas
    n_y, n_x = here.shape
    added = 0.0
    for i in range(mixed.shape[0]):
        for j in range(mixed.shape[1]):
            f_00, f_01 = flux[i, j], flux[i, j + 1]
            f_10, f_11 = flux[i + 1, j], flux[i + 1, j + 1]
            lit = int(f_00 > 0) + int(f_01 > 0) + int(f_10 > 0) + int(f_11 > 0)
            mixed[i, j] = 0 < lit < 4
            if lit < 4:
                continue
            a, b = nodes[i, j], nodes[i + 1, j]
            c, d = nodes[i, j + 1], nodes[i + 1, j + 1]
            if (i + j + odd) % 2 == 0:
                first, second = (f_00 + f_10 + f_01) / 6, (f_10 + f_11 + f_01) / 6
            else:
                first, second = (f_00 + f_10 + f_11) / 6, (f_00 + f_11 + f_01) / 6
            added += first + second
            column, row = np.floor(a[0]), np.floor(a[1])
            if (
                np.floor(b[0]) == column
                and np.floor(c[0]) == column
                and np.floor(d[0]) == column
                and np.floor(b[1]) == row
                and np.floor(c[1]) == row
                and np.floor(d[1]) == row
            ):  # as most do where cells are fine
                if 0 <= column < n_x and 0 <= row < n_y:
                    here[int(row), int(column)] += first + second
            elif (i + j + odd) % 2 == 0:
                _triangle(a, b, c, first, here, behind)
                _triangle(b, d, c, second, here, behind)
            else:
                _triangle(a, b, d, first, here, behind)
                _triangle(a, d, c, second, here, behind)
    return added


@jit(error_model="numpy")
def fill_spots(places, flux, whole, rim, canvas):  # type: ignore[no-untyped-def]
    """Add the light of spots, each split into triangles about its middle.

    Parameters
    ----------
    places : array, shape (m, k, 2)
        Column and row where the rays of each spot meet the screen, in pixels; the first of them is
        its middle.
    flux : array, shape (m, k)
        Flux of a spot whose light were all as that of the ray.
    whole : array of bool, shape (m,)
        Which of them are drawn.
    rim : array, shape (n, k)
        Weights of the rays for each corner of the outline.
    canvas : tuple of arrays
        Those of a canvas; get the light added.
    """
    here, behind = canvas
    n, k = rim.shape
    corners, light, light_of = np.empty((n, 2)), np.empty(n), np.empty(n)
    for spot in range(len(flux)):
        if not whole[spot]:
            continue
        for corner in range(n):
            x = y = f = 0.0
            for ray in range(k):
                x += rim[corner, ray] * places[spot, ray, 0]
                y += rim[corner, ray] * places[spot, ray, 1]
                f += rim[corner, ray] * flux[spot, ray]
            corners[corner, 0], corners[corner, 1], light[corner] = x, y, f
        for corner in range(n):
            total = flux[spot, 0] + light[corner] + light[(corner + 1) % n]
            light_of[corner] = total / (3 * n)
        _fan(places[spot, 0], corners, light_of, here, behind)


@jit(error_model="numpy")
def _fan(middle, corners, flux, here, behind):  # type: ignore[no-untyped-def]
    """Add the flux of triangles from a middle to each corner (n, 2) and the one behind it.

    The edge between two of them is drawn once, with the difference of both densities.
    """
    n = len(flux)
    before = 0.0
    for corner in range(-1, n):
        a, b = corners[corner], corners[(corner + 1) % n]
        area = (a[0] - middle[0]) * (b[1] - middle[1]) - (b[0] - middle[0]) * (a[1] - middle[1])
        if abs(area / 2) < _SMALLEST:
            density = 0.0
            if corner >= 0:
                _triangle(middle, a, b, flux[corner], here, behind)
        else:
            density = flux[corner] / (area / 2)
        if corner >= 0:
            _edge(middle[0], middle[1], a[0], a[1], density - before, here, behind)
            _edge(a[0], a[1], b[0], b[1], density, here, behind)
        before = density


@jit(error_model="numpy")
def _triangle(a, b, c, flux, here, behind):  # type: ignore[no-untyped-def]
    """Add flux that is spread evenly over a triangle, whichever way around it goes."""
    area = ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2
    n_y, n_x = here.shape
    if abs(area) < _SMALLEST:
        column, row = np.floor((a[0] + b[0] + c[0]) / 3), np.floor((a[1] + b[1] + c[1]) / 3)
        if 0 <= column < n_x and 0 <= row < n_y:
            here[int(row), int(column)] += flux
        return
    density = flux / area
    _edge(a[0], a[1], b[0], b[1], density, here, behind)
    _edge(b[0], b[1], c[0], c[1], density, here, behind)
    _edge(c[0], c[1], a[0], a[1], density, here, behind)


@jit(error_model="numpy")
def _edge(x_0, y_0, x_1, y_1, density, here, behind):  # type: ignore[no-untyped-def]
    """Add a density to all that is to the right of an edge that goes up, towards lower rows."""
    n_y = here.shape[0]
    if y_0 < y_1:
        density = -density
    else:
        x_0, y_0, x_1, y_1 = x_1, y_1, x_0, y_0
    if y_0 == y_1 or y_1 <= 0 or y_0 >= n_y:
        return
    slope = (x_1 - x_0) / (y_1 - y_0)
    y, last = max(y_0, 0.0), min(y_1, float(n_y))
    x = x_0 + (y - y_0) * slope
    row = int(y)
    while y < last:
        y_next = min(row + 1.0, last)
        x_next = x_1 if y_next == y_1 else x_0 + (y_next - y_0) * slope
        _add_in_row(min(x, x_next), max(x, x_next), density * (y_next - y), here[row], behind[row])
        x, y, row = x_next, y_next, row + 1


@jit(error_model="numpy")
def _add_in_row(x_0, x_1, value, here, behind):  # type: ignore[no-untyped-def]
    """Add the part of an edge from x_0 to x_1 ≥ x_0 within one row of pixels.

    ``value`` is what a pixel that is wholly to the right of it gets.
    """
    n_x = len(here)
    if x_0 >= n_x:
        return
    if x_1 <= 0:
        behind[0] += value
        return
    rate = value / (x_1 - x_0) if x_1 > x_0 else 0.0
    if x_0 < 0:
        behind[0] -= rate * x_0
        value += rate * x_0
        x_0 = 0.0
    if x_1 > n_x:
        value -= rate * (x_1 - n_x)
        x_1 = float(n_x)
    column, last = int(x_0), int(x_1)
    while column < last:
        width = column + 1 - x_0
        here[column] += rate * width * width / 2
        behind[column + 1] += rate * width
        value -= rate * width
        column += 1
        x_0 = float(column)
    if column < n_x:
        here[column] += value * (column + 1 - (x_0 + x_1) / 2)
        behind[column + 1] += value
