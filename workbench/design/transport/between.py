"""Values of cells at places between their middles, and the places where they are as wanted.

Places are counted in cells from the middle of the first one. Beyond the middles of the outer cells
the nearest of these counts.
"""

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads

Pair = tuple[Array, Array]

# Newton steps of a search, at most; the part of all cells that each goes at most; the least area
# of a cell there, as a part of what it was; and how near a search comes, in cells. So near that it
# matters to none whether one of two mirror images takes a step more: with 1e-3, first lenses of
# mirrored tasks were uneven by 1e-11, with 1e-8 they are by 2e-15, and first lenses take no longer.
_MOST_STEPS, _FAR, _LEAST_AREA, _NEAR = 40, 0.1, 1e-3, 1e-8


def between(values: Array, at: Pair) -> Array:
    """Values at places, linear between the middles of cells.

    Parameters
    ----------
    values : ndarray, shape (m_0, m_1)
        One for each cell, at least two along each axis.
    at : tuple of two ndarray
        Places along both axes, of one shape.
    """
    at_0, at_1 = (np.ascontiguousarray(place, np.float64) for place in at)
    found = np.empty_like(at_0)
    flat = at_0.ravel(), at_1.ravel(), found.ravel()
    values = np.ascontiguousarray(values, np.float64)  # other layouts would be compiled anew

    def work(begin: int, end: int) -> None:
        _between(values, *flat, begin, end)

    threads.run_lines(work, found.size, found.size)
    return found


def whence(values: Pair, wanted: Pair, begin: Pair) -> Pair:
    """Places where two values are as wanted, or as near to it as a search comes.

    Newton steps, halved where they lead no nearer: where an image is dark, faces spread light over
    many times the area that it comes from.

    Parameters
    ----------
    values : tuple of two ndarray, shape (m_0, m_1)
        Where the cells go along both axes, in cells; neighbours stay neighbours.
    wanted, begin : tuple of two ndarray
        What values are searched for, and where each search begins; all of one shape.

    Returns
    -------
    tuple of two ndarray
        Places within the cells, of the shape of what is wanted.
    """
    to_0, to_1 = (np.ascontiguousarray(each, np.float64) for each in values)
    wanted_0, wanted_1 = (np.ascontiguousarray(each, np.float64) for each in wanted)
    at_0, at_1 = (np.array(each, np.float64, order="C") for each in begin)
    flat = wanted_0.ravel(), wanted_1.ravel(), at_0.ravel(), at_1.ravel()

    def work(begin: int, end: int) -> None:
        _whence(to_0, to_1, *flat, begin, end)

    threads.run_lines(work, at_0.size, at_0.size)
    return at_0, at_1


@jit(allocates=False)
def _between(values, at_0, at_1, found, begin, end):  # type: ignore[no-untyped-def]
    """The places from number ``begin`` to ``end``; see `between`."""
    m_0, m_1 = values.shape
    for k in range(begin, end):
        i, f = located(at_0[k], m_0)
        j, g = located(at_1[k], m_1)
        found[k] = mixed(values, i, f, j, g)


@jit(allocates=False)
def _whence(to_0, to_1, wanted_0, wanted_1, at_0, at_1, begin, end):  # type: ignore[no-untyped-def]
    """The places from number ``begin`` to ``end``; see `whence`."""
    m_0, m_1 = to_0.shape
    far_0, far_1 = _FAR * m_0, _FAR * m_1
    for k in range(begin, end):
        cell_0, cell_1 = at_0[k], at_1[k]
        least, step_0, step_1 = np.inf, 0.0, 0.0
        for _ in range(_MOST_STEPS):
            i, f = located(cell_0, m_0)
            j, g = located(cell_1, m_1)
            off_0 = mixed(to_0, i, f, j, g) - wanted_0[k]
            off_1 = mixed(to_1, i, f, j, g) - wanted_1[k]
            far = off_0**2 + off_1**2
            if far < least:
                least, at_0[k], at_1[k] = far, cell_0, cell_1
                if far < _NEAR**2:
                    break
                x_x, x_y = _slopes(to_0, i, f, j, g)
                y_x, y_y = _slopes(to_1, i, f, j, g)
                area = max(x_x * y_y - x_y * y_x, _LEAST_AREA)
                step_0 = min(max((y_y * off_0 - x_y * off_1) / area, -far_0), far_0)
                step_1 = min(max((x_x * off_1 - y_x * off_0) / area, -far_1), far_1)
            else:
                step_0, step_1 = step_0 / 2, step_1 / 2
            if max(abs(step_0), abs(step_1)) < _NEAR:
                break
            cell_0 = min(max(at_0[k] - step_0, -0.5), m_0 - 0.5)
            cell_1 = min(max(at_1[k] - step_1, -0.5), m_1 - 0.5)


@jit(allocates=False)
def located(place, count):  # type: ignore[no-untyped-def]
    """The cell before a place along an axis, and which part of the way to the next one it is."""
    inside = min(max(place, 0.0), count - 1.0)
    cell = min(int(inside), count - 2)
    return cell, inside - cell


@jit(allocates=False)
def mixed(values, i, f, j, g):  # type: ignore[no-untyped-def]
    """Value at parts f and g of the way from a cell to the next ones."""
    before = (1 - g) * values[i, j] + g * values[i, j + 1]
    behind = (1 - g) * values[i + 1, j] + g * values[i + 1, j + 1]
    return (1 - f) * before + f * behind


@jit(allocates=False)
def _slopes(values, i, f, j, g):  # type: ignore[no-untyped-def]
    """What a value changes by along both axes, as for `mixed`."""
    a, b, c, d = values[i, j], values[i, j + 1], values[i + 1, j], values[i + 1, j + 1]
    return (1 - g) * (c - a) + g * (d - b), (1 - f) * (b - a) + f * (d - c)
