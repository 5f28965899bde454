"""Result of the independent check of a lens."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from workbench.analysis.by_cells import ByCells, RandomShare, run_apart
from workbench.analysis.metrics import Quality, relative_l2, root
from workbench.analysis.regions import RegionLight
from workbench.analysis.shading import Shading
from workbench.arrays import Array
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.scene import AnyReceiver

Interval = tuple[float, float]

_MARGIN = 2.0  # allowed difference to the run, in errors of the check


class MadeStep(NamedTuple):
    """Error of a lens after a process and those before it."""

    title: str  # of the process; empty for the lens as designed
    error: float  # relative L2 distance of the first image to its target
    interval: Interval
    change: float  # of the error by this process; 0 as designed

    def to_data(self) -> dict[str, Any]:
        """The step by names, for JSON."""
        return {
            "process": self.title or None,
            "relative_l2": self.error,
            "interval": list(self.interval),
            "change": self.change,
        }


@dataclass(frozen=True)
class Validation:
    """Result of an independent trace of a lens.

    Attributes
    ----------
    loss : float
        Loss of the paper (section 2.4): Frobenius norm of the difference between image and
        target, each divided by its sum, over √(n_x n_y).
    relative_l2 : float
        The same norm over that of the normalised target; the noise of the rays is in it.
    relative_l2_interval : tuple[float, float]
        Interval of ``relative_l2`` for other rays, with at least 95 % confidence.
    relative_l2_corrected : float
        The error without noise, by a second image of other rays; see `CorrectedDistance`.
    relative_l2_corrected_interval : tuple[float, float]
        Interval of the error of the lens, with at least 95 % confidence.
    efficiency : float
        Part of the emitted flux on the receiver.
    account : Account
        Where the light goes.
    quality : Quality
        Other figures of the image.
    rays : int
        Rays of the image.
    noise : float
        Upper estimate of the standard error of ``relative_l2``: its standard deviation over 16
        batches of the rays, over √16. The batches are stratified together, so they do not serve
        as second images for the corrected error.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the receiver, row 0 at +y.
    image_noise : float
        Noise of the image over its norm.
    share : RandomShare
        The efficiency with its noise.
    by_cells : ByCells, optional
        The deterministic check, if requested and possible.
    left_out : Message, optional
        Why the deterministic check is missing although requested.
    shading : Shading, optional
        Light that the lens or the receiver blocks, with the deterministic check.
    regions : tuple of RegionLight
        The light of each region.
    lit_area : RegionLight, optional
        The light where the target is lit, if that is one even area.
    steps : tuple of MadeStep
        Errors as designed and after each process, if these were asked for.
    further : tuple of Validation
        Results of the further images, in their order.
    weight : float
        Weight of the square of this image's error.
    """

    loss: float
    relative_l2: float
    relative_l2_interval: Interval
    relative_l2_corrected: float
    relative_l2_corrected_interval: Interval
    efficiency: float
    account: Account
    quality: Quality
    rays: int
    noise: float
    irradiance: Array
    image_noise: float
    share: RandomShare
    by_cells: ByCells | None = None
    left_out: Message | None = None
    shading: Shading | None = None
    regions: tuple[RegionLight, ...] = ()
    lit_area: RegionLight | None = None
    steps: tuple[MadeStep, ...] = ()
    further: tuple["Validation", ...] = ()
    weight: float = 1.0

    @property
    def images(self) -> tuple["Validation", ...]:
        """Results of all images, in their order."""
        return (self, *self.further)

    @property
    def areas(self) -> tuple[RegionLight, ...]:
        """The light of the lit area, if known, and of each region."""
        return self.regions if self.lit_area is None else (self.lit_area, *self.regions)

    @property
    def verified(self) -> "Validation | ByCells | CombinedError":
        """Result with the error of the lens itself: by cells, or else by random rays.

        The error of several images is the root of the weighted mean of their squares.
        """
        return CombinedError.of(self.images) if self.further else self.by_cells or self

    @property
    def contradiction(self) -> Message | None:
        """Message if the two traces contradict each other: then no figure is reliable."""
        by_cells = (image.by_cells for image in self.images if image.by_cells)
        return next((each.contradiction for each in by_cells if each.contradiction), None)

    def beside_run(self, run: Array, receiver: AnyReceiver) -> Message | None:
        """Return a message if the image (n_y, n_x) of a run differs by more than the errors."""
        share, noise = self.share, self.image_noise
        cells = self.by_cells
        if cells and cells.agreement and cells.bound < noise:
            off = _MARGIN * cells.bound
            apart = relative_l2(run, cells.irradiance)
            by_check, share_off = cells.efficiency, cells.agreement.bound
        else:
            off = noise
            apart = root(relative_l2(run, self.irradiance) ** 2 - noise**2)
            by_check, share_off = share.value, _MARGIN * share.noise
        return run_apart(apart, off, receiver.total(run), by_check, share_off)

    @property
    def loss_corrected(self) -> float:
        """``loss`` of the lens itself, without noise."""
        if self.relative_l2 == 0:
            return self.loss
        return self.loss * self.verified.relative_l2_corrected / self.relative_l2

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON; those of further images and regions in lists."""
        further = {"further_images": [each.to_data() for each in self.further]}
        regions = {"regions": [each.to_data() for each in self.regions]}
        steps = {"as_made": [step.to_data() for step in self.steps]}
        return {
            "loss": self.loss,
            "relative_l2": self.relative_l2,
            "relative_l2_interval": list(self.relative_l2_interval),
            "relative_l2_corrected": self.relative_l2_corrected,
            "relative_l2_corrected_interval": list(self.relative_l2_corrected_interval),
            **self.quality.to_data(),
            "efficiency": self.efficiency,
            "ledger": self.account.to_data(),
            "rays": self.rays,
            "noise": self.noise,
            "contradiction": self.contradiction,
            "deterministic": self.by_cells and self.by_cells.to_data(),
            "deterministic_left_out": self.left_out,
            "shading": self.shading and self.shading.to_data(),
            "lit_area": self.lit_area and self.lit_area.to_data(),
            **(regions if self.regions else {}),
            **(steps if self.steps else {}),
            **(further if self.further else {}),
        }


class CombinedError(NamedTuple):
    """The error of several images."""

    relative_l2_corrected: float
    relative_l2_corrected_interval: Interval

    @classmethod
    def of(cls, images: Sequence[Validation]) -> "CombinedError":
        """The root of the weighted mean of the squares of their errors."""
        each = [image.by_cells or image for image in images]
        weights = [image.weight for image in images]
        errors = [
            (found.relative_l2_corrected, *found.relative_l2_corrected_interval) for found in each
        ]
        error, low, high = np.sqrt(np.average(np.square(errors), axis=0, weights=weights)).tolist()
        return cls(error, (low, high))
