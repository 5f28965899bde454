"""The error of a lens by cells, and whether random rays and the run agree with it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Self

import numpy as np
from scipy.special import stdtrit

from workbench.analysis.cells.image import CellImage, imaging
from workbench.analysis.metrics import paper_loss, relative_l2, root
from workbench.analysis.scatter import CorrectedDistance, IndependentError, tracing_independently
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.arrays import Array
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.progress import Steps, within
from workbench.scene import AnyReceiver, Scene

# Student's t of the batches: each of two tests gives a false alarm in at most one of 80,000 checks.
_T = float(-stdtrit(BATCHES - 1, 1.25e-5 / 2))
# With fewer rays on the receiver, or beside it, their noise is that of counts.
_COUNTED = 10 * BATCHES
# With fewer rays in an image, the batches do not give its noise.
_IMAGED = 2000
# The bound of cells is an estimate from three cell sizes: allow twice as much, and at least 1e-3.
_MARGIN, _LEAST = 2.0, 1e-3
# The image of a run has larger cells than the check: its usual error.
_OF_RUN, _SHARE_OF_RUN = 0.02, 0.005


class RandomShare(NamedTuple):
    """Part of the emitted flux that random rays find on the receiver, with its standard error."""

    value: float
    noise: float
    rays: int  # of all batches

    @classmethod
    def of(cls, value: float, batches: Sequence[float], rays: int) -> Self:
        """Return the share of all rays, with the noise from the shares of the batches."""
        return cls(value, float(np.std(batches, ddof=1)) / math.sqrt(BATCHES), rays)

    def off(self, expected: float, bound: float) -> float:
        """Return the distance to an expected share beyond noise and its error bound; else 0."""
        noise, part = self.noise, min(expected, 1 - expected)
        if part * self.rays < _COUNTED:
            noise = max(noise, math.sqrt(max(part, 1 / self.rays) / self.rays))
        return max(abs(self.value - expected) - _T * noise - bound, 0.0)


class Agreement(NamedTuple):
    """Agreement of the image by cells with random rays."""

    by_cells: float  # part of the emitted flux on the receiver, by cells
    bound: float  # error bound of ``by_cells``
    share: RandomShare
    image_bound: float  # bound of the relative error of the image by cells
    image: CorrectedDistance  # between the two images

    @property
    def contradiction(self) -> Message | None:
        """Message if the two differ by more than noise and bounds explain."""
        if self.share.off(self.by_cells, _MARGIN * self.bound + _LEAST * self.by_cells):
            return Message(
                "the check contradicts itself: {cells:.4g} % of the light on the receiver by "
                "cells, {rays:.4g} % by random rays; no figure of this check is reliable",
                cells=100 * self.by_cells,
                rays=100 * self.share.value,
            )
        if not math.isfinite(self.image_bound) or self.share.value * self.share.rays < _IMAGED:
            return None
        allowed = max(_MARGIN * self.image_bound, _LEAST)
        if self.image.surely_above(allowed, _T):
            return Message(
                "the check contradicts itself: the images by cells and by random rays are "
                "{apart:.3g} % apart, which noise and error bound do not explain; no figure of "
                "this check is reliable",
                apart=100 * self.image.distance,
            )
        return None


def run_apart(
    image_apart: float, image_off: float, share: float, by_check: float, share_off: float
) -> Message | None:
    """Return a message if the image of a run differs from the check by more than their errors.

    `image_apart`: relative L2 difference of the images; `share`, `by_check`: part of the emitted
    flux on the receiver by the run and by the check; `image_off`, `share_off`: errors of the check.
    """
    if abs(share - by_check) > share_off + _SHARE_OF_RUN:
        return Message(
            "the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: "
            "use the figures of the check",
            run=100 * share,
            check=100 * by_check,
        )
    if image_apart > image_off + _OF_RUN:
        return Message(
            "the image of the run is {apart:.3g} % off the image of the check: use the figures "
            "of the check",
            apart=100 * image_apart,
        )
    return None


# Cells whose bound is so many times the requested accuracy are dropped if random rays are better.
_FAR = 10
# Above this bound image and efficiency come from random rays: with an emitter of two half-widths,
# 1e-4 before the lens, cells found 5 % of the light where 26 % land.
_NOTHING = 0.5


@dataclass(frozen=True)
class ByCells:
    """Deterministic error of a lens, compared with random rays."""

    relative_l2_corrected: float  # ‖I − T‖ / ‖T‖ of image and target, each divided by its sum
    # By the error bound of the image, or by independent images.
    relative_l2_corrected_interval: tuple[float, float]
    loss: float  # of the paper (section 2.4)
    efficiency: float  # part of the emitted flux on the receiver
    account: Account  # where the light goes, without the scatter of rays
    bound: float  # of the error of the image, over its norm; see `imaging`
    wanted: float  # requested accuracy
    cells: tuple[int, int]  # along x and y
    difference: float  # ‖R − I‖ / ‖I‖ of the image R of random rays
    noise: float  # part of the difference that is noise of the rays
    unscattered: CorrectedDistance  # the difference without noise
    irradiance: Array  # (n_y, n_x), row 0 at +y
    agreement: Agreement | None = None  # None for a ray file, whose rays are all that is known
    independent: IndependentError | None = None  # source of the error where it is more exact

    @classmethod
    def of(
        cls,
        image: CellImage,
        target: Array,
        receiver: AnyReceiver,
        of_rays: Array,
        unscattered: CorrectedDistance,
        share: RandomShare | None,
        account: Account,
        independent: IndependentError | None = None,
    ) -> "ByCells":
        """Compare the image by cells with the target and the image of random rays, in any scale.

        ``account`` is that of the random rays.
        """
        by_cells, apart = image.error(target)
        error, interval = by_cells, (max(by_cells - apart, 0.0), by_cells + apart)
        irradiance = image.irradiance
        lit = receiver.total(irradiance)
        whole = lit + sum(image.lost.values())  # 1, but for the error of sums over cells
        own = Account(lit / whole, {name: part / whole for name, part in image.lost.items()})
        if independent is not None:
            error, interval, *_ = independent.unscattered
            if image.bound > _NOTHING:
                irradiance, own = of_rays, account
                by_cells = relative_l2(of_rays, target)
        difference = relative_l2(of_rays, image.irradiance)
        flux = image.irradiance * receiver.pixel_measure
        # The error of the sum of all pixels, by the Cauchy-Schwarz inequality.
        off = image.bound * float(np.linalg.norm(flux)) * math.sqrt(flux.size)
        agreement = Agreement(lit, off, share, image.bound, unscattered) if share else None
        return cls(
            relative_l2_corrected=error,
            relative_l2_corrected_interval=interval,
            loss=paper_loss(irradiance, target) * (error / by_cells if by_cells else 1.0),
            efficiency=receiver.total(irradiance),
            account=own,
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
        """Whether the error is far less exact than requested, and than random rays' interval."""
        low, high = self.relative_l2_corrected_interval
        return self.bound > _FAR * self.wanted and high - low > interval[1] - interval[0]

    @property
    def difference_over_noise(self) -> float | None:
        """Difference to random rays in units of their noise: 1 if both are right."""
        return self.difference / self.noise if self.noise > 0 else None

    @property
    def contradiction(self) -> Message | None:
        """Message if random rays contradict the cells; see `Agreement`."""
        return self.agreement and self.agreement.contradiction

    @property
    def way(self) -> str:
        """Method of the check in words."""
        if self.independent is None:
            return f"{self.cells[0]} x {self.cells[1]} cells, without random rays"
        return f"{BATCHES} independent images of {self.independent.rays:,} random rays together"

    @property
    def less_exact(self) -> Message | None:
        """Message if the error is less exact than requested, with the reason."""
        off, why = self.bound, Message("finer cells would take too long")
        if self.independent is not None:
            off, why = self.independent.unscattered.off, Message("that needs more rays")
        if off <= self.wanted:
            return None
        return Message(
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
            "ledger": self.account.to_data(),
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


_IMAGE = 0.7  # estimated fraction of the work for the image, where its error has to be found, too


def without_scatter(
    scene: Scene,
    heights: Mapping[str, Array],
    target: Array,
    accuracy: float,
    pose: Pose | None,
    threads: int | None,
    random_rays: int,
) -> Steps[tuple[CellImage | None, IndependentError | None]]:
    """Compute the image by cells, and the error by independent images where that is more exact."""
    steps = imaging(scene, heights, accuracy, pose, threads, random_rays, target)
    image = yield from within(steps, lambda part: _IMAGE * part)
    if image is None or (off := image.error(target)[1]) <= image.wanted or not image.sized:
        return image, None
    rays = tracing_independently(scene, heights, target, accuracy, pose, threads, random_rays)
    independent = yield from within(rays, lambda part: _IMAGE + (1 - _IMAGE) * part)
    return image, independent if independent.unscattered.off < off else None


def _no_less(value: float) -> float:
    """Round a positive value up to two digits."""
    if not math.isfinite(value):
        return value
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(round(value / step, 6)) * step
