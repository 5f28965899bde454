"""Compiled loops over balls: what many of them leave of the stock, and where one touches a face."""

import math
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array, Index
from workbench.compiled import jit

LEAF_ROWS, LEAF_SPANS = 2, 4
"""Rows and pieces of a row in the smallest block of `Blocks`."""
_GUESSES = 3  # steps from the centre above a place to the ball that sweeps over it
_NEWTON = 24  # steps from a point of a lattice to where a ball touches; two are the rule
_STRAY = 2.0  # lattice steps that one step of Newton's method may go


class Blocks(NamedTuple):
    """Bounds of the centres of a grid of balls in blocks, each of which holds 2 × 2 smaller ones.

    Level after level, row after row, the smallest blocks first.

    Attributes
    ----------
    lowest : ndarray, shape (m,)
        Lowest centre of each block, scene units.
    slope_x, slope_y : ndarray, shape (m,)
        Slopes of a plane that no centre of the block is below.
    side : ndarray, shape (m,)
        Lowest side, above the grid's first point, of balls with centres on that plane.
    begin, rows, columns : ndarray of int, shape (levels,)
        Where each level begins in these, and its shape.
    """

    lowest: Array
    slope_x: Array
    slope_y: Array
    side: Array
    begin: Index
    rows: Index
    columns: Index


class Pieces(NamedTuple):
    """A B-spline face as polynomials on its knot spans, continued by straight lines at its rim.

    Attributes
    ----------
    control : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    along_x, along_y : ndarray, shape (spans, p + 1, p + 1)
        Coefficients, lowest power first, of the p + 1 basis functions on each knot span; their
        variable goes from 0 to 1 over the span.
    r_x, r_y : float
        Half-widths, scene units.
    """

    control: Array
    along_x: Array
    along_y: Array
    r_x: float
    r_y: float


@jit(error_model="numpy")
def lowest_sides(  # type: ignore[no-untyped-def]
    centre, blocks, grid, radius, x, y, height, normal
):
    """Find the lowest side of all balls above places: exact, by branch and bound.

    Centres go along straight lines from one column of the grid to the next within a row.

    Parameters
    ----------
    centre : array, shape (m_y, m_x)
        Heights of the centres.
    blocks : Blocks
        Their lowest.
    grid : tuple of float
        First x, step in x, first y, step in y.
    radius : float
        Radius of all balls.
    x, y : array, shape (m,)
        Places.
    height : array, shape (m,)
        Gets the height of the side; infinite where no ball is above.
    normal : array, shape (m, 3)
        Gets the unit vector from the place on the side to the centre of its ball, or 0.
    """
    x_0, step_x, y_0, step_y = grid
    rows, columns = centre.shape
    levels = len(blocks.begin)
    stack = np.empty((4 * levels + 4, 3), np.int64)
    for k in range(len(x)):
        # A first candidate near the lowest, so that few blocks can hold a lower one.
        i = min(max(int((x[k] - x_0) / step_x), 0), columns - 2)
        j = min(max(int((y[k] - y_0) / step_y + 0.5), 0), rows - 1)
        for _ in range(_GUESSES):
            near = min(j, rows - 2)
            slope_x = (centre[j, i + 1] - centre[j, i]) / step_x
            slope_y = (centre[near + 1, i] - centre[near, i]) / step_y
            reach = radius / math.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
            i = min(max(int((x[k] - reach * slope_x - x_0) / step_x), 0), columns - 2)
            j = min(max(int((y[k] - reach * slope_y - y_0) / step_y + 0.5), 0), rows - 1)
        best, along, aside = _side(centre, grid, radius, x[k], y[k], j, i)
        filled = 1
        stack[0, 0], stack[0, 1], stack[0, 2] = levels - 1, 0, 0
        while filled > 0:
            filled -= 1
            level, row, column = stack[filled, 0], stack[filled, 1], stack[filled, 2]
            place = blocks.begin[level] + row * blocks.columns[level] + column
            rise_x, rise_y = blocks.slope_x[place], blocks.slope_y[place]
            if blocks.side[place] + rise_x * (x[k] - x_0) + rise_y * (y[k] - y_0) >= best:
                continue
            first_j, first_i = row * (LEAF_ROWS << level), column * (LEAF_SPANS << level)
            last_j = min(first_j + (LEAF_ROWS << level), rows) - 1
            last_i = min(first_i + (LEAF_SPANS << level), columns - 1)
            off_x = max(x_0 + first_i * step_x - x[k], x[k] - x_0 - last_i * step_x, 0.0)
            off_y = max(y_0 + first_j * step_y - y[k], y[k] - y_0 - last_j * step_y, 0.0)
            under = radius * radius - off_x * off_x - off_y * off_y
            if under <= 0 or blocks.lowest[place] - math.sqrt(under) >= best:
                continue
            if level == 0:
                for j in range(first_j, last_j + 1):
                    for i in range(first_i, last_i):
                        side, to_x, to_y = _side(centre, grid, radius, x[k], y[k], j, i)
                        if side < best:
                            best, along, aside = side, to_x, to_y
                continue
            for below in range(4):
                j, i = 2 * row + (below >> 1), 2 * column + (below & 1)
                if j < blocks.rows[level - 1] and i < blocks.columns[level - 1]:
                    stack[filled, 0], stack[filled, 1], stack[filled, 2] = level - 1, j, i
                    filled += 1
        height[k] = best
        above = radius * radius - along * along - aside * aside
        inside = best < math.inf
        normal[k, 0] = along / radius if inside else 0.0
        normal[k, 1] = aside / radius if inside else 0.0
        normal[k, 2] = math.sqrt(max(above, 0.0)) / radius if inside else 0.0


@jit(error_model="numpy", inline="always")  # a call costs as much
def _side(centre, grid, radius, x, y, j, i):  # type: ignore[no-untyped-def]
    """Lowest side above a place of a ball that goes along one piece, and where its centre is."""
    x_0, step_x, y_0, step_y = grid
    aside = y_0 + j * step_y - y
    square = radius * radius - aside * aside
    if square <= 0:
        return math.inf, 0.0, 0.0
    slope = (centre[j, i + 1] - centre[j, i]) / step_x
    along = -math.sqrt(square) * slope / math.sqrt(1 + slope * slope)
    begin = x_0 + i * step_x - x
    along = min(max(along, begin), begin + step_x)
    under = square - along * along
    if under <= 0:
        return math.inf, 0.0, 0.0
    return centre[j, i] + slope * (along - begin) - math.sqrt(under), along, aside


@jit(error_model="numpy")
def touching(pieces, radius, stray, x, y, at_x, at_y, tip):  # type: ignore[no-untyped-def]
    """Find how far down balls may go, by Newton's method from where they nearly touch.

    Parameters
    ----------
    pieces : Pieces
        The face.
    radius : float
        Radius of all balls.
    stray : float
        How far apart points of the lattice are that the search began with.
    x, y : array, shape (m,)
        Where the balls are.
    at_x, at_y : array, shape (m,)
        Where they nearly touch; replaced by where they touch.
    tip : array, shape (m,)
        Gets the height of the lowest point of each ball.
    """
    basis = np.empty((6, max(pieces.along_x.shape[1], pieces.along_y.shape[1])))
    for k in range(len(x)):
        u, v = at_x[k] - x[k], at_y[k] - y[k]
        best, move_x, move_y = -math.inf, 0.0, 0.0
        far = _STRAY * stray
        for _ in range(_NEWTON):
            square = radius * radius - u * u - v * v
            if square <= 0:
                break
            z, p, q, r, s, t = _derivatives(pieces, x[k] + u, y[k] + v, basis)
            above = math.sqrt(square)
            if z + above <= best:  # by rounding, or past a place where the face bends otherwise
                move_x, move_y = move_x / 2, move_y / 2
                u, v = u - move_x, v - move_y
                continue
            best, at_x[k], at_y[k] = z + above, x[k] + u, y[k] + v
            # The largest z + above: slopes g and second derivatives of it are
            g_x, g_y = p - u / above, q - v / above
            xx = r - (1 + u * u / square) / above
            yy = t - (1 + v * v / square) / above
            xy = s - u * v / (square * above)
            whole = xx * yy - xy * xy
            if xx < 0 and whole > 0:
                move_x, move_y = (xy * g_y - yy * g_x) / whole, (xy * g_x - xx * g_y) / whole
                size = math.sqrt(move_x * move_x + move_y * move_y)
                if size <= 1e-7 * radius:  # what is gained then goes with its square
                    break
            else:  # a hollow that is tighter than the ball: upwards, to its side
                move_x, move_y = g_x, g_y
                size = math.sqrt(g_x * g_x + g_y * g_y)
                if size <= 1e-12:
                    break
                move_x, move_y, size = move_x / size * far, move_y / size * far, far
            part = min(far / size, 1.0)
            move_x, move_y = part * move_x, part * move_y
            u, v = u + move_x, v + move_y
        tip[k] = best - radius


@jit(error_model="numpy", inline="always")  # a call costs as much
def _along(place, half_width, along, basis, first):  # type: ignore[no-untyped-def]
    """Values, slopes and second derivatives of the basis functions at a place; their span."""
    spans, count = along.shape[0], along.shape[1]
    inner = min(max(place, -half_width), half_width)
    density = spans / (2 * half_width)
    scaled = (inner + half_width) * density
    span = min(int(scaled), spans - 1)
    local = scaled - span
    for j in range(count):
        value = slope = curve = 0.0
        for power in range(count - 1, -1, -1):
            curve = curve * local + slope
            slope = slope * local + value
            value = value * local + along[span, j, power]
        beyond = place - inner
        basis[first, j] = value + slope * density * beyond
        basis[first + 1, j] = slope * density
        basis[first + 2, j] = 2 * curve * density * density if beyond == 0 else 0.0
    return span


@jit(error_model="numpy", inline="always")  # a call costs as much
def _derivatives(pieces, x, y, basis):  # type: ignore[no-untyped-def]
    """Height and derivatives z_x, z_y, z_xx, z_xy, z_yy at a place."""
    column = _along(x, pieces.r_x, pieces.along_x, basis, 0)
    row = _along(y, pieces.r_y, pieces.along_y, basis, 3)
    z = p = q = r = s = t = 0.0
    for i in range(pieces.along_x.shape[1]):
        across = slope = curve = 0.0
        for j in range(pieces.along_y.shape[1]):
            control = pieces.control[column + i, row + j]
            across += control * basis[3, j]
            slope += control * basis[4, j]
            curve += control * basis[5, j]
        z += across * basis[0, i]
        p += across * basis[1, i]
        r += across * basis[2, i]
        q += slope * basis[0, i]
        s += slope * basis[1, i]
        t += curve * basis[0, i]
    return z, p, q, r, s, t
