"""Figures of images of random rays without the scatter of the rays."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.analysis.metrics import root
from workbench.analysis.tracing.sources.cells import BATCHES

FEWER = 4
"""The second image has so many times fewer rays."""

STUDENT_T = 2.131
"""Student's t for 95 % and as many batches, of which one degree of freedom goes to their mean."""


class Unscattered(NamedTuple):
    """A distance of an image of random rays to another one, without the scatter of the rays.

    Attributes
    ----------
    distance : float
        The root of ⟨I − T, I′ − T⟩ / ‖T‖², where I′ is a second image of fewer, other rays. The two
        scatter independently, so the mean of the product has no scatter in it; a negative one
        counts as 0.
    interval : tuple[float, float]
        Where it lies: at least 95 % confidence.
    """

    distance: float
    interval: tuple[float, float]

    @classmethod
    def of(cls, products: Sequence[float]) -> "Unscattered":
        """From the products with each batch of the second image; see `metrics.product`."""
        square = float(np.mean(products))
        # The scatter of the second image shows in the products. That of the first, which has more
        # rays, adds less to the variance than its part of the rays says.
        spread = STUDENT_T * float(np.std(products, ddof=1)) * math.sqrt((1 + 1 / FEWER) / BATCHES)
        return cls(root(square), (root(square - spread), root(square + spread)))
