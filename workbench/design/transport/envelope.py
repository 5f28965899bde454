"""The c-transform of a potential for a quadratic cost, in linear time.

φᶜ(y) = min_x ½ w₀ (x₀ − y₀)² + ½ w₁ (x₁ − y₁)² − φ(x), over the places of a grid with spacing 1.
It splits into lower envelopes of parabolas along the lines of each axis (Felzenszwalb and
Huttenlocher 2012, Distance transforms of sampled functions).
"""

from typing import Any

import numpy as np

from workbench.compiled import jit


@jit()
def c_transform(potential, weight_0, weight_1):  # type: ignore[no-untyped-def]
    """The c-transform.

    Parameters
    ----------
    potential : ndarray of float64, shape (m_0, m_1)
        φ.
    weight_0, weight_1 : float
        Weights of the squared distances along the two axes.

    Returns
    -------
    ndarray, shape (m_0, m_1)
        φᶜ on the same grid.
    """
    m_0, m_1 = potential.shape
    longest = max(m_0, m_1)
    vertex, border = np.empty(longest, np.int64), np.empty(longest + 1)
    line, envelope = np.empty(longest), np.empty(longest)
    half = np.empty((m_0, m_1))
    for a in range(m_0):
        _envelope(potential[a], weight_1, vertex, border, envelope)
        half[a] = -envelope[:m_1]
    transformed = np.empty((m_0, m_1))
    for b in range(m_1):
        line[:m_0] = half[:, b]
        _envelope(line[:m_0], weight_0, vertex, border, envelope)
        transformed[:, b] = envelope[:m_0]
    return transformed


@jit()
def _envelope(values, weight, vertex, border, envelope) -> Any:  # type: ignore[no-untyped-def]
    """min_j ½ w (k − j)² − values[j] for each k.

    ``vertex`` lists the parabolas of the envelope from left to right, and ``border`` where each
    of them begins to be the lowest.
    """
    count = len(values)
    top = 0
    vertex[0] = 0
    border[0] = -np.inf
    for j in range(1, count):
        i = vertex[top]
        crossing = 0.5 * (i + j) + (values[i] - values[j]) / (weight * (j - i))
        while crossing <= border[top]:
            top -= 1
            i = vertex[top]
            crossing = 0.5 * (i + j) + (values[i] - values[j]) / (weight * (j - i))
        top += 1
        vertex[top] = j
        border[top] = crossing
    border[top + 1] = np.inf
    lowest = 0
    for k in range(count):
        while border[lowest + 1] < k:
            lowest += 1
        j = vertex[lowest]
        envelope[k] = 0.5 * weight * (k - j) ** 2 - values[j]
