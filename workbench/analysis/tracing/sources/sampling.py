"""Even and random places of squares, discs and faces."""

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


_GOLDEN = (math.sqrt(5) - 1) / 2


def in_disc(count: int) -> tuple[Array, Array]:
    """Places of a sunflower (Vogel 1979): all stand for as much of the disc."""
    number = np.arange(count)
    return (number + 0.5) / count, np.asarray(_GOLDEN * number % 1)


def pairs(random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Random pairs in [0, 1]², each number in another of ``count`` equal parts."""
    a, b = ((random.permutation(count) + random.random(count)) / count for _ in range(2))
    return a, b


def in_square(count: int) -> tuple[Array, Array]:
    """Places of a lattice by the golden ratio."""
    number = np.arange(count)
    return (number + 0.5) / count, np.asarray((_GOLDEN * number + 0.5) % 1)


# A point at the plane, or behind it where the face leans, gives no light: it needs some distance.
_LEAST = 1e-15


def near_places(
    a: Array, b: Array, points: Array, half_width: tuple[float, float]
) -> tuple[Array, Array, Array]:
    """Places for pairs that fill a square evenly, and the area that each stands for.

    A point at a distance d lights a plane as (d² + r²)^-2, with r from its foot, where it is
    Lambertian. Along x places are as dense as the light of whole lines of the plane,
    (d² + x²)^-3/2. Along each line, which is q² = d² + x² from the point, they are as dense as
    (q² + y²)^-3/2, whose sum has a closed form. Rays that each stand for the area of their place
    then carry almost the same flux: their image scatters least.

    `a`, `b` (m,): in [0, 1]; `points` (m, 3): where each ray begins as the lens sees it, before the
    plane z = 0; one point may stand for all; `half_width`: of the rectangle that the places fill.
    Returns (m,): x, y and areas, whose mean is that of the rectangle.

    Examples
    --------
    >>> import numpy as np
    >>> a, b = np.meshgrid((np.arange(200) + 0.5) / 200, (np.arange(200) + 0.5) / 200)
    >>> point = np.array([[0.5, 0.0, -1.0]])
    >>> x, y, area = near_places(a.ravel(), b.ravel(), point, (2.0, 1.0))
    >>> bool(abs(x).max() < 2 and abs(y).max() < 1), area.mean().round(1).item()
    (True, 8.0)
    """
    r_x, r_y = half_width
    foot_x, foot_y, z = points.T
    distance = np.maximum(-z, _LEAST * max(half_width))
    x, along_x = _along(a, distance, foot_x, r_x)
    y, along_y = _along(b, np.hypot(distance, x - foot_x), foot_y, r_y)
    return x, y, along_x * along_y


def _along(part: Array, distance: Array, foot: Array, half: float) -> tuple[Array, Array]:
    """Places between both ends of a line, and the length that each stands for."""
    low, high = ((end - foot) / np.hypot(distance, end - foot) for end in (-half, half))
    sine = low + (high - low) * part
    with np.errstate(divide="ignore"):  # rounding may make a sine 1
        away = distance * sine / np.sqrt(1 - sine**2)
    place = (foot + away).clip(-half, half)
    length = (high - low) * np.hypot(distance, place - foot) ** 3 / distance**2
    return place, length
