"""Errors of images of random rays, without the scatter of the rays."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.metrics import root
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.trace import Trace
from workbench.arrays import Array
from workbench.progress import Steps, within
from workbench.scene import Scene

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
        # A square below 0 by more than its spread tells that images are evener together than ones
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


# Rays of all images at first, and at most: some ten seconds on two cores. And for each ray of the
# check at most.
_BEGIN, _MOST, _EACH = 1 << 22, 1 << 24, 4


class IndependentError(NamedTuple):
    """What independent images of random rays say of a lens."""

    unscattered: CorrectedDistance  # relative L2 distance of the lens's image to a target
    rays: int  # rays of all images together


def tracing_independently(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    accuracy: float,
    pose: Pose | None = None,
    threads: int | None = None,
    random_rays: int | None = None,
) -> Steps[IndependentError]:
    """Find the error of a lens from independent images; twice as many rays until it is exact.

    `target` (n_y, n_x): the target image in any scale; `accuracy`: how far the error may be off,
    unless that takes too many rays; `random_rays`: random rays of the check: the images have at
    most four times as many.
    """
    images = np.zeros((BATCHES, *target.shape))
    most = _MOST if random_rays is None else min(_EACH * random_rays, _MOST)
    rays, run, together = 0, 0, min(_BEGIN, most)
    while True:
        more = (together if run == 0 else together // 2) // BATCHES
        for number in range(BATCHES):
            trace = Trace(scene, heights, more, _seed(run, number), pose)
            image = yield from within(_image(trace, threads), partial(_done, run, number))
            images[number] += image.reshape(target.shape)
            rays += trace.rays
        found = CorrectedDistance.of_pairs(list(images), target)
        run, together = run + 1, 2 * together
        if found.off <= accuracy or together > most:
            return IndependentError(found, rays)


def _image(trace: Trace, threads: int | None) -> Steps[Array]:
    """Flux in the pixels of all batches of a trace."""
    flux = np.zeros(1)
    for batch in trace.batches(threads):
        if batch is not None:
            flux = flux + batch.flux[0]
        yield trace.part
    return flux


def _done(run: int, image: int, fraction: float) -> float:
    """The part of the whole that is done with a part of an image."""
    return 1 - math.pow(0.5, run + (image + fraction) / BATCHES)


def _seed(run: int, image: int) -> int:
    """A seed for rays that have nothing to do with others."""
    mixed = np.random.SeedSequence([25, run, image])
    return int(mixed.generate_state(1, np.uint64)[0])
