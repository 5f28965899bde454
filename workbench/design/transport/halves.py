"""Values of cells on grids of cells twice and half as large."""

import numpy as np

from workbench.arrays import Array


def halved(mass: Array) -> Array:
    """Mass in cells twice as large."""
    return np.asarray(mass[::2, ::2] + mass[1::2, ::2] + mass[::2, 1::2] + mass[1::2, 1::2])


def doubled(values: Array) -> Array:
    """Smooth values at the middles of cells half as large."""
    for _ in range(2):  # along one axis, then along the other
        ends = 2 * values[[0, -1]] - values[[1, -2]]
        wide = np.concatenate([ends[:1], values, ends[1:]])
        finer = np.empty((2 * len(values), values.shape[1]))
        finer[::2] = 0.75 * wide[1:-1] + 0.25 * wide[:-2]
        finer[1::2] = 0.75 * wide[1:-1] + 0.25 * wide[2:]
        values = finer.T
    return np.ascontiguousarray(values)
