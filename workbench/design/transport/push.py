"""Carries mass along the map that a potential defines."""

import math

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads

# Most parts along an axis into which a cell is cut where the map stretches it.
_MOST_PARTS = 8


def mapped(potential: Array, weight_0: float, weight_1: float) -> tuple[Array, Array]:
    """Where the map y = x − ∇φ(x) / w brings the places of a grid with spacing 1.

    Parameters
    ----------
    potential : ndarray, shape (m_0, m_1)
        φ.
    weight_0, weight_1 : float
        Weights of the squared distances along the two axes.

    Returns
    -------
    tuple of two ndarrays, shape (m_0, m_1)
        Coordinates along the two axes, within the cells of the grid.
    """
    to_0, to_1 = np.empty_like(potential), np.empty_like(potential)

    def work(begin: int, end: int) -> None:
        _mapped(potential, weight_0, weight_1, begin, end, to_0, to_1)

    threads.run_lines(work, len(potential), potential.size)
    return to_0, to_1


@jit(allocates=False)
def _mapped(potential, weight_0, weight_1, begin, end, to_0, to_1):  # type: ignore[no-untyped-def]
    """The lines from number ``begin`` to ``end``; see `mapped`."""
    m_0, m_1 = potential.shape
    for a in range(begin, end):
        below, above = max(a - 1, 0), min(a + 1, m_0 - 1)
        for b in range(m_1):
            left, right = max(b - 1, 0), min(b + 1, m_1 - 1)
            rise_0 = (potential[above, b] - potential[below, b]) / (above - below)
            rise_1 = (potential[a, right] - potential[a, left]) / (right - left)
            to_0[a, b] = min(max(a - rise_0 / weight_0, -0.5), m_0 - 0.5)
            to_1[a, b] = min(max(b - rise_1 / weight_1, -0.5), m_1 - 0.5)


def push(mass: Array, to_0: Array, to_1: Array, fewest: int = 1) -> Array:
    """Mass after each cell went where the map brings it.

    A cell is cut where the map stretches it, so that it leaves no holes; each part is spread over
    the four nearest places.

    Parameters
    ----------
    mass : ndarray, shape (m_0, m_1)
        Mass of each cell.
    to_0, to_1 : ndarray, shape (m_0, m_1)
        Where the middles of the cells go; see `mapped`.
    fewest : int
        Parts into which a cell is cut along an axis, at least. Those of cells 0.9 apart, uncut,
        make waves of 2 % in an even light.

    Returns
    -------
    ndarray, shape (m_0, m_1)
    """
    bounds = threads.split(len(mass), mass.size)
    pushed = np.zeros((len(bounds) - 1, *mass.shape))

    def work(part: int) -> None:
        _push(mass, to_0, to_1, fewest, bounds[part], bounds[part + 1], pushed[part])

    threads.run(work, len(pushed))
    return np.asarray(pushed.sum(axis=0))


@jit()
def _push(mass, to_0, to_1, fewest, begin, end, pushed):  # type: ignore[no-untyped-def]
    """Add the mass of the cells from line ``begin`` to ``end``; see `push`."""
    m_0, m_1 = mass.shape
    for a in range(begin, end):
        below, above = max(a - 1, 0), min(a + 1, m_0 - 1)
        for b in range(m_1):
            if mass[a, b] == 0.0:
                continue
            left, right = max(b - 1, 0), min(b + 1, m_1 - 1)
            stretch_00 = (to_0[above, b] - to_0[below, b]) / (above - below)
            stretch_10 = (to_1[above, b] - to_1[below, b]) / (above - below)
            stretch_01 = (to_0[a, right] - to_0[a, left]) / (right - left)
            stretch_11 = (to_1[a, right] - to_1[a, left]) / (right - left)
            parts_0 = max(_parts(max(abs(stretch_00), abs(stretch_10))), fewest)
            parts_1 = max(_parts(max(abs(stretch_01), abs(stretch_11))), fewest)
            share = mass[a, b] / (parts_0 * parts_1)
            for i in range(parts_0):
                s = (i + 0.5) / parts_0 - 0.5
                for j in range(parts_1):
                    t = (j + 0.5) / parts_1 - 0.5
                    place_0 = to_0[a, b] + stretch_00 * s + stretch_01 * t
                    place_1 = to_1[a, b] + stretch_10 * s + stretch_11 * t
                    place_0 = min(max(place_0, 0.0), m_0 - 1.0)
                    place_1 = min(max(place_1, 0.0), m_1 - 1.0)
                    near_0, near_1 = min(int(place_0), m_0 - 2), min(int(place_1), m_1 - 2)
                    f, g = place_0 - near_0, place_1 - near_1
                    pushed[near_0, near_1] += share * (1 - f) * (1 - g)
                    pushed[near_0 + 1, near_1] += share * f * (1 - g)
                    pushed[near_0, near_1 + 1] += share * (1 - f) * g
                    pushed[near_0 + 1, near_1 + 1] += share * f * g


@jit()
def _parts(stretch):  # type: ignore[no-untyped-def]
    return int(min(max(math.ceil(stretch), 1), _MOST_PARTS))
