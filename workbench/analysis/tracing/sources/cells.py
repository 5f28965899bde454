"""Random places that fill a square evenly."""

import math
from collections.abc import Iterator

import numpy as np

from workbench.arrays import Array

# Batches of places, 4 × 4: enough to estimate their scatter.
_SIDE = 4
BATCHES = _SIDE * _SIDE
# Places made at once: arrays of so many rays stay within the cache.
_AT_ONCE = 1 << 15


class Cells:
    """Places on the unit square, one at random in each of equal cells.

    The cells lie in blocks of 4 × 4, and each batch of places has one of every block. A batch is
    an even sample by itself, and all of them together fill every cell.

    `count`: places in all, at least; rounded up to whole batches of a grid; `aspect`: columns over
    rows of the grid of cells; `seed`: the same seed gives the same places. `count`: places in all.
    """

    def __init__(self, count: int, aspect: float, seed: int) -> None:
        blocks = max(count, 1) / BATCHES
        self._columns = math.ceil(math.sqrt(blocks * aspect))
        self._rows = math.ceil(blocks / self._columns)
        self._seed = seed
        self.count = BATCHES * self._columns * self._rows

    def batch(self, batch: int) -> Iterator[tuple[Array, Array]]:
        """Coordinates in [0, 1], each of shape (m,), some columns of blocks at a time."""
        order = np.random.default_rng([self._seed, 0])  # the same for each batch
        jitter = np.random.default_rng([self._seed, 1 + batch])
        step = max(_AT_ONCE // self._rows, 1)
        for first in range(0, self._columns, step):
            column = np.arange(first, min(first + step, self._columns))[:, None]
            row = np.arange(self._rows)[None, :]
            size = (column.size, self._rows)
            cell = (order.integers(BATCHES, size=size) + batch) % BATCHES
            across = column + (cell // _SIDE + jitter.random(size)) / _SIDE
            up = row + (cell % _SIDE + jitter.random(size)) / _SIDE
            yield across.ravel() / self._columns, up.ravel() / self._rows
