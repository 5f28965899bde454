"""Figures of images of random rays without the scatter of the rays."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.metrics import root
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.arrays import Array

FEWER = 4
"""The second image has so many times fewer rays."""

STUDENT_T = 2.131
"""Student's t for 95 % and as many batches, of which one degree of freedom goes to their mean."""


class CorrectedDistance(NamedTuple):
    """A distance of an image of random rays to another one, without the scatter of the rays."""

    # The root of ⟨I − T, I′ − T⟩ / ‖T‖², where I′ is a second image of fewer, other rays. The two
    # scatter independently, so the mean of the product has no scatter in it; a negative one counts
    # as 0.
    distance: float
    # Where it lies: at least 95 % confidence, also where images are evener than independent ones.
    interval: tuple[float, float]
    square: float  # its square; scatter may make it negative
    standard_error: float  # of the square

    @classmethod
    def of(cls, products: Sequence[float]) -> "CorrectedDistance":
        """From the products with each batch of the second image; see `metrics.product`."""
        square = float(np.mean(products))
        # The scatter of the second image shows in the products. That of the first, which has more
        # rays, adds less to the variance than its part of the rays says.
        rays = math.sqrt((1 + 1 / FEWER) / BATCHES)
        return cls.of_square(square, float(np.std(products, ddof=1)) * rays)

    @classmethod
    def of_pairs(
        cls, images: Sequence[npt.NDArray[np.floating]], reference: Array
    ) -> "CorrectedDistance":
        """From images of other rays each, as many: all pairs of two scatter independently.

        The mean of ⟨I_r − T, I_s − T⟩ over all pairs has no scatter in it. How it varies where one
        of the images is left out tells how far it is off: the jackknife (Arvesen 1969).

        `images` (n_y, n_x): `BATCHES` images by independent rays, in any scale. A dark one has no
        shape: nothing is then known, and the interval is without end; `reference` (n_y, n_x): what
        they are compared with, in any scale.
        """
        count, wanted = len(images), reference / reference.sum()
        if not all(image.any() for image in images):
            return cls(0.0, (0.0, math.inf), 0.0, math.inf)
        apart = np.array(
            [(image / image.sum(dtype=np.float64) - wanted).ravel() for image in images]
        )
        products = apart @ apart.T / float(np.square(wanted).sum())
        np.fill_diagonal(products, 0.0)
        square = float(products.sum()) / (count * (count - 1))
        without = (products.sum() - 2 * products.sum(axis=1)) / ((count - 1) * (count - 2))
        variance = (count - 1) / count * float(np.square(without - square).sum())
        return cls.of_square(square, math.sqrt(variance))

    @classmethod
    def of_square(
        cls, square: float, standard_error: float, t: float = STUDENT_T
    ) -> "CorrectedDistance":
        """From an estimate of the square, its standard error, and how many of these make 95 %."""
        spread = t * standard_error
        # a square below 0 by more than its spread tells that images are evener together than ones
        # that are independent, as parts of a file whose rays are laid out evenly: by so much the
        # true one may be above 0 as well.
        most = square if square >= -spread else -square
        interval = root(square - spread), root(most + spread)
        return cls(root(square), interval, square, standard_error)

    def surely_above(self, limit: float, t: float) -> bool:
        """Whether the distance is above a limit by more than ``t`` standard errors."""
        return self.square - t * self.standard_error > limit**2

    @property
    def off(self) -> float:
        """How far the distance may be off."""
        low, high = self.interval
        return max(self.distance - low, high - self.distance)
