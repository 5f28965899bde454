"""Whether the two traces of the check agree, and whether the image of the run agrees with them.

The image by cells has a bound of its error, and random rays have noise. If the two differ by more
than both explain, one of them is wrong, and the check has failed.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple, Self

import numpy as np
from scipy.stats import t as student

from workbench.analysis.scatter import CorrectedDistance
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.said import Said

# Of two tests, each gives a false alarm in one of 80,000 checks at most: Student's t of the batches
# of rays on each side. Batches that exclude each other scatter less together than these allow.
_T = float(student.isf(1.25e-5 / 2, BATCHES - 1))
# With fewer rays on the receiver, or beside it, their scatter is that of counts.
_COUNTED = 10 * BATCHES
# An image of fewer rays has pixels that few of them meet: batches do not tell how it scatters.
_IMAGED = 2000
# The bound of cells is an estimate from three sizes of cells: twice as much is allowed, and what
# any check may be off.
_MARGIN, _LEAST = 2.0, 1e-3
# The image of a run has larger cells than the check: so far off is as usual.
_OF_RUN, _SHARE_OF_RUN = 0.02, 0.005


class RandomShare(NamedTuple):
    """The part of the light that random rays find on the receiver."""

    value: float  # part of the emitted flux
    noise: float  # its standard error
    rays: int  # rays of all batches

    @classmethod
    def of(cls, value: float, batches: Sequence[float], rays: int) -> Self:
        """The share of all rays, and its noise from those of the batches."""
        return cls(value, float(np.std(batches, ddof=1)) / math.sqrt(BATCHES), rays)

    def off(self, expected: float, bound: float) -> float:
        """How far the share is from an expected one beyond noise and the bound of that; else 0."""
        noise, part = self.noise, min(expected, 1 - expected)
        if part * self.rays < _COUNTED:
            noise = max(noise, math.sqrt(max(part, 1 / self.rays) / self.rays))
        return max(abs(self.value - expected) - _T * noise - bound, 0.0)


class Agreement(NamedTuple):
    """How far the image by cells and random rays are apart."""

    by_cells: float  # part of the emitted light that cells find on the receiver
    bound: float  # bound of the error of that part
    share: RandomShare  # the same of random rays
    image_bound: float  # bound of the relative error of the image by cells
    image: CorrectedDistance  # distance of the two images without the scatter of the rays

    @property
    def contradiction(self) -> Said | None:
        """That the two differ by more than noise and bounds explain; None where they do not."""
        if self.share.off(self.by_cells, _MARGIN * self.bound + _LEAST * self.by_cells):
            return Said(
                "the check contradicts itself: {cells:.4g} % of the light on the receiver by "
                "cells, {rays:.4g} % by random rays; no figure of this check is reliable",
                cells=100 * self.by_cells,
                rays=100 * self.share.value,
            )
        if not math.isfinite(self.image_bound) or self.share.value * self.share.rays < _IMAGED:
            return None
        allowed = max(_MARGIN * self.image_bound, _LEAST)
        if self.image.surely_above(allowed, _T):
            return Said(
                "the check contradicts itself: the images by cells and by random rays are "
                "{apart:.3g} % apart, which noise and error bound do not explain; no figure of "
                "this check is reliable",
                apart=100 * self.image.distance,
            )
        return None


def run_apart(
    image_apart: float, image_off: float, share: float, by_check: float, share_off: float
) -> Said | None:
    """That the image of a run differs from the check by more than both may be off.

    `image_apart`, `image_off`: relative L2 difference of the two images, and how far that of the
    check may be off; `share`, `by_check`, `share_off`: part of the emitted light on the receiver by
    the run and by the check, and how far that of the check may be off. Returns None where they
    agree.
    """
    if abs(share - by_check) > share_off + _SHARE_OF_RUN:
        return Said(
            "the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: "
            "use the figures of the check",
            run=100 * share,
            check=100 * by_check,
        )
    if image_apart > image_off + _OF_RUN:
        return Said(
            "the image of the run is {apart:.3g} % off the image of the check: use the figures "
            "of the check",
            apart=100 * image_apart,
        )
    return None
