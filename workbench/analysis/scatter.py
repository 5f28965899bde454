"""Errors of images of random rays, without the scatter of the rays."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.metrics import enough, root
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.trace import Trace
from workbench.arrays import Array
from workbench.progress import Steps, within
from workbench.scene import Scene

FEWER = 4
"""Rays of the image over those of the second image."""

STUDENT_T = 2.131
"""Student's t for 95 % with one batch less than there are."""


class CorrectedDistance(NamedTuple):
    """Distance of an image of random rays to another image, without the noise of the rays.

    It is the root of ⟨I − T, I′ − T⟩ / ‖T‖², where I′ is a second image of fewer, other rays. The
    noise of the two is independent, so it cancels in the mean; a negative mean counts as 0.
    """

    distance: float
    interval: tuple[float, float]  # with at least 95 % confidence
    square: float  # of the distance; negative by noise
    standard_error: float  # of the square

    @classmethod
    def of(cls, products: Sequence[float]) -> "CorrectedDistance":
        """From the products with each batch of the second image; see `metrics.product`."""
        square = float(np.mean(products))
        # The noise of the first image, which has more rays, adds less than its part of the rays.
        rays = math.sqrt((1 + 1 / FEWER) / BATCHES)
        return cls.of_square(square, float(np.std(products, ddof=1)) * rays)

    @classmethod
    def of_pairs(
        cls, images: Sequence[npt.NDArray[np.floating]], reference: Array
    ) -> "CorrectedDistance":
        """From `BATCHES` independent images (n_y, n_x) in any scale.

        The mean of ⟨I_r − T, I_s − T⟩ over all pairs is free of noise; its error is that of the
        jackknife (Arvesen 1969). With a dark image the interval is infinite.
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
        """From an estimate of the square and its standard error; ``t`` of these make 95 %."""
        spread = t * standard_error
        # A square below −spread comes from images that are evener than independent ones, as parts
        # of a ray file on a grid: the true square may be as far above 0.
        most = square if square >= -spread else -square
        interval = root(square - spread), root(most + spread)
        return cls(root(square), interval, square, standard_error)

    def surely_above(self, limit: float, t: float) -> bool:
        """Whether the distance is above a limit by more than ``t`` standard errors."""
        return self.square - t * self.standard_error > limit**2

    @property
    def off(self) -> float:
        """Largest error of the distance."""
        low, high = self.interval
        return max(self.distance - low, high - self.distance)


# Rays of all images at first and at most (ten seconds on two cores), and most per ray of the check.
_BEGIN, _MOST, _EACH = 1 << 22, 1 << 24, 4


class IndependentError(NamedTuple):
    """Error of a lens by independent images of random rays."""

    unscattered: CorrectedDistance  # relative L2 distance of the image to the target
    rays: int  # of all images


def tracing_independently(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    accuracy: float,
    pose: Pose | None = None,
    threads: int | None = None,
    random_rays: int | None = None,
) -> Steps[IndependentError]:
    """Find the error of a lens by independent images, with more rays until it is accurate `enough`.

    The images have at most four times ``random_rays``.
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
        if found.off <= enough(accuracy, found.distance - found.off) or together > most:
            return IndependentError(found, rays)


def _image(trace: Trace, threads: int | None) -> Steps[Array]:
    """Sum the flux in the pixels over all batches of a trace."""
    flux = np.zeros(1)
    for batch in trace.batches(threads):
        if batch is not None:
            flux = flux + batch.flux[0]
        yield trace.part
    return flux


def _done(run: int, image: int, fraction: float) -> float:
    """Fraction of the whole that is done after a fraction of an image."""
    return 1 - math.pow(0.5, run + (image + fraction) / BATCHES)


def _seed(run: int, image: int) -> int:
    mixed = np.random.SeedSequence([25, run, image])
    return int(mixed.generate_state(1, np.uint64)[0])
