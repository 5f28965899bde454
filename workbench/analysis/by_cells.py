"""The error of a lens by cells, and whether random rays and the run agree with it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Self

import numpy as np
from scipy.stats import t as student

from workbench.analysis.cells.image import CellImage, imaging
from workbench.analysis.metrics import paper_loss, relative_l2, root
from workbench.analysis.scatter import CorrectedDistance, IndependentError, tracing_independently
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.arrays import Array
from workbench.progress import Steps, within
from workbench.said import Said
from workbench.scene import AnyReceiver, Scene

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


# Cells that are off by so many times what was asked for are left out if random rays know better.
_FAR = 10
# Of cells that may be off by so much of the image, random rays give image and efficiency where they
# give the error. With an emitter of two half-widths, 1e-4 before the lens, cells found 5 % of the
# light where 26 % land.
_NOTHING = 0.5


@dataclass(frozen=True)
class ByCells:
    """Error of a lens without random rays, and random rays as the second opinion."""

    # ‖I − T‖ / ‖T‖ of image and target, each divided by its sum. No rays scatter here.
    relative_l2_corrected: float
    # Where it lies: by the bound of the image's error, or that of independent images.
    relative_l2_corrected_interval: tuple[float, float]
    loss: float  # Paper's loss (section 2.4)
    efficiency: float  # part of the emitted flux that lands on the screen
    bound: float  # bound of the error of the image, over its norm; see `imaging`
    wanted: float  # what this, or how far the error is off, was to be at most
    cells: tuple[int, int]  # cells along x and y
    difference: float  # ‖R − I‖ / ‖I‖ of the image R of random rays
    noise: float  # what that would be by the scatter of the rays alone
    unscattered: CorrectedDistance  # the same difference without their scatter
    irradiance: Array  # (n_y, n_x), flux per area on the screen, row 0 at +y
    # How far the two traces are apart; None where some rays of a file are all that is known of the
    # light, for which cells only stand.
    agreement: Agreement | None = None
    # Where the error is from independent images of random rays, as these are more exact.
    independent: IndependentError | None = None

    @classmethod
    def of(
        cls,
        image: CellImage,
        target: Array,
        receiver: AnyReceiver,
        of_rays: Array,
        unscattered: CorrectedDistance,
        share: RandomShare | None,
        independent: IndependentError | None = None,
    ) -> "ByCells":
        """Compare an image with the target and with one of random rays.

        `image`: the image by cells; `target`, `of_rays` (n_y, n_x): the target and the image of
        random rays, in any scale; `receiver`: what the images are on; `unscattered`: distance of
        these two without the scatter of the rays; `share`: part of the light of the random rays on
        the receiver; None where cells only stand for the rays of a file; `independent`: what has
        the error, in place of the image by cells.
        """
        by_cells, apart = image.error(target)
        error, interval = by_cells, (max(by_cells - apart, 0.0), by_cells + apart)
        irradiance = image.irradiance
        if independent is not None:
            error, interval, *_ = independent.unscattered
            if image.bound > _NOTHING:
                irradiance = of_rays
                by_cells = relative_l2(of_rays, target)
        difference = relative_l2(of_rays, image.irradiance)
        flux = image.irradiance * receiver.pixel_measure
        # By Cauchy and Schwarz, the error of the sum of all pixels.
        off = image.bound * float(np.linalg.norm(flux)) * math.sqrt(flux.size)
        lit = receiver.total(image.irradiance)
        agreement = Agreement(lit, off, share, image.bound, unscattered) if share else None
        return cls(
            relative_l2_corrected=error,
            relative_l2_corrected_interval=interval,
            loss=paper_loss(irradiance, target) * (error / by_cells if by_cells else 1.0),
            efficiency=receiver.total(irradiance),
            bound=image.bound,
            wanted=image.wanted,
            cells=image.cells,
            difference=difference,
            noise=root(difference**2 - unscattered.square),
            unscattered=unscattered,
            irradiance=irradiance,
            agreement=agreement,
            independent=independent,
        )

    def poorer_than(self, interval: tuple[float, float]) -> bool:
        """Whether the error is by far less exact than asked for, and than by random rays.

        `interval`: where the error lies by random rays.
        """
        low, high = self.relative_l2_corrected_interval
        return self.bound > _FAR * self.wanted and high - low > interval[1] - interval[0]

    @property
    def difference_over_noise(self) -> float | None:
        """How far random rays are from this image, in units of their noise: 1 if both are right."""
        return self.difference / self.noise if self.noise > 0 else None

    @property
    def contradiction(self) -> Said | None:
        """That random rays contradict the cells; see `Agreement`."""
        return self.agreement and self.agreement.contradiction

    @property
    def way(self) -> str:
        """How the error was found."""
        if self.independent is None:
            return f"{self.cells[0]} x {self.cells[1]} cells, without random rays"
        return f"{BATCHES} independent images of {self.independent.rays:,} random rays together"

    @property
    def less_exact(self) -> Said | None:
        """That the error is less exact than was asked for, and why; None where it is not."""
        off, why = self.bound, Said("finer cells would take too long")
        if self.independent is not None:
            off, why = self.independent.unscattered.off, Said("that needs more rays")
        if off <= self.wanted:
            return None
        return Said(
            "off by up to {off:g} %, not {wanted:.2g} %: {why}",
            off=_no_less(100 * off),
            wanted=100 * self.wanted,
            why=why,
        )

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "relative_l2": self.relative_l2_corrected,
            "relative_l2_interval": list(self.relative_l2_corrected_interval),
            "loss": self.loss,
            "efficiency": self.efficiency,
            "error_bound": self.bound,
            "error_bound_wanted": self.wanted,
            "cells": list(self.cells),
            "independent_rays": self.independent and self.independent.rays,
            "difference": self.difference,
            "noise": self.noise,
            "difference_over_noise": self.difference_over_noise,
            "difference_corrected": self.unscattered.distance,
            "difference_corrected_interval": list(self.unscattered.interval),
        }


def without_scatter(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    accuracy: float,
    pose: Pose | None,
    threads: int | None,
    random_rays: int,
) -> Steps[tuple[CellImage | None, IndependentError | None]]:
    """Find the image by cells, and independent ones where these tell its error more exactly.

    `target` (n_y, n_x): the target image in any scale.
    """
    steps = imaging(scene, heights, accuracy, pose, threads, random_rays)
    image = yield from within(steps, lambda part: part / 2)
    if image is None or (off := image.error(target)[1]) <= accuracy or not image.sized:
        return image, None
    rays = tracing_independently(scene, heights, target, accuracy, pose, threads, random_rays)
    independent = yield from within(rays, lambda part: 0.5 + part / 2)
    return image, independent if independent.unscattered.off < off else None


def _no_less(value: float) -> float:
    """A value above 0 on two digits, rounded up: 0.104 would be said to be no more than 0.1."""
    if not math.isfinite(value):
        return value
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(round(value / step, 6)) * step
