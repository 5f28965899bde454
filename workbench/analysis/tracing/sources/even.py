"""Even places on a disc, as parts of its area within their radius and of the turn."""

import math

import numpy as np

from workbench.arrays import Array

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
