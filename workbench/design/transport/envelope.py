"""The c-transform of a potential for a quadratic cost, in linear time.

φᶜ(y) = min_x ½ w₀ (x₀ − y₀)² + ½ w₁ (x₁ − y₁)² − φ(x), over the places of a grid with spacing 1.
It splits into lower envelopes of parabolas along the lines of each axis (Felzenszwalb and
Huttenlocher 2012, Distance transforms of sampled functions).
"""

from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads


def c_transform(potential: Array, weight_0: float, weight_1: float) -> Array:
    """The c-transform.

    Parameters
    ----------
    potential : ndarray, shape (m_0, m_1)
        φ.
    weight_0, weight_1 : float
        Weights of the squared distances along the two axes.

    Returns
    -------
    ndarray, shape (m_0, m_1)
        φᶜ on the same grid.
    """
    rows = np.ascontiguousarray(-potential)  # other layouts would be compiled anew
    return _lowest_along_rows(_lowest_along_rows(rows, weight_1), weight_0)


def _lowest_along_rows(values: Array, weight: float) -> Array:
    """min_j ½ w (k − j)² + values[a, j], transposed: shape (m_1, m_0)."""
    lowest = np.empty(values.shape[::-1])

    def work(begin: int, end: int) -> None:
        _envelopes(values, weight, begin, end, lowest)

    threads.run_lines(work, len(values), values.size)
    return lowest


@jit()
def _envelopes(values, weight, begin, end, lowest):  # type: ignore[no-untyped-def]
    """The rows from number ``begin`` to ``end``; see `_lowest_along_rows`."""
    count = values.shape[1]
    vertex, border, envelope = np.empty(count, np.int64), np.empty(count + 1), np.empty(count)
    for a in range(begin, end):
        _envelope(values[a], weight, vertex, border, envelope)
        for k in range(count):
            lowest[k, a] = envelope[k]


@jit()
def _envelope(values, weight, vertex, border, envelope) -> Any:  # type: ignore[no-untyped-def]
    """min_j ½ w (k − j)² + values[j] for each k.

    ``vertex`` lists the parabolas of the envelope from left to right, and ``border`` where each
    of them begins to be the lowest.
    """
    count = len(values)
    top = 0
    vertex[0] = 0
    border[0] = -np.inf
    for j in range(1, count):
        i = vertex[top]
        crossing = 0.5 * (i + j) + (values[j] - values[i]) / (weight * (j - i))
        while crossing <= border[top]:
            top -= 1
            i = vertex[top]
            crossing = 0.5 * (i + j) + (values[j] - values[i]) / (weight * (j - i))
        top += 1
        vertex[top] = j
        border[top] = crossing
    border[top + 1] = np.inf
    lowest = 0
    for k in range(count):
        while border[lowest + 1] < k:
            lowest += 1
        j = vertex[lowest]
        envelope[k] = 0.5 * weight * (k - j) ** 2 + values[j]
