"""A lens with its light: the one value that goes from the tracer to files and views."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import Shortfall
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.optics.account import Account

if TYPE_CHECKING:
    from torch import Tensor


@dataclass(frozen=True, eq=False)
class FurtherLight:
    """The light of a lens on the receiver of a further image."""

    irradiance: Array  # (n_y, n_x), flux per area there, row 0 at +y
    loss: float  # Paper's loss of this image alone
    account: Account  # where the light goes


@dataclass(frozen=True, eq=False)
class LensState:
    """A lens and what has been computed of it."""

    heights: ControlHeights
    irradiance: Array  # (n_y, n_x), flux per area on the screen, row 0 at +y
    # Paper's loss (section 2.4) as the optimiser sees it; with further images that of an image
    # whose squared relative error is the weighted mean of all of them.
    loss: float
    account: Account  # where the light goes
    # What the task needs beyond the limits of the heights, where that is known to hinder it.
    shortfall: Shortfall | None = None
    further: tuple[FurtherLight, ...] = ()  # the light of each further image, in their order

    @property
    def lights(self) -> "tuple[LensState | FurtherLight, ...]":
        """What has the irradiance and the account of each image, the first one first."""
        return (self, *self.further)

    def of_image(self, number: int, target: Array) -> Self:
        """The lens with the light of one of its images alone, whose target is given."""
        light = self.lights[number]
        loss = _paper_loss(light.irradiance, target)
        return replace(
            self, irradiance=light.irradiance, loss=loss, account=light.account, further=()
        )

    @classmethod
    def traced(
        cls,
        heights: "Mapping[str, Tensor]",
        flux: "Tensor",
        pixel_measure: float | Array,
        loss: "Tensor",
        account: Account,
    ) -> Self:
        """What a tracer has computed, out of its device and float type.

        `heights` (n_u, n_v): control heights of each freeform face by its name; `flux` (n_y, n_x):
        light in each pixel; `pixel_measure`: what each pixel covers; see
        `workbench.scene.AnyReceiver`; `loss`: Paper's loss, one number; `account`: where the light
        goes. Raises `UnbalancedAccount` if it does not add up; see
        `workbench.optics.account.Account.settled`.
        """
        settled = account.settled()
        irradiance = _copy(flux)
        irradiance /= pixel_measure
        if settled.on_screen != account.on_screen:
            irradiance *= settled.on_screen / account.on_screen
        copies = FaceArrays({face: _sealed(_copy(each)) for face, each in heights.items()})
        return cls(copies, _sealed(irradiance), loss.item(), settled)

    def scaled(self, factor: float, densities: Sequence[float]) -> Self:
        """The same lens with lengths in another unit.

        `factor`: so many of them are one of now; `densities`: by these the irradiance of each image
        is divided.
        """
        first, *others = (
            _sealed(light.irradiance / density)
            for light, density in zip(self.lights, densities, strict=True)
        )
        return replace(
            self,
            heights=scaled(self.heights, factor),
            irradiance=first,
            shortfall=self.shortfall and self.shortfall.scaled(factor),
            further=tuple(
                replace(light, irradiance=irradiance)
                for light, irradiance in zip(self.further, others, strict=True)
            ),
        )


def _paper_loss(irradiance: Array, target: Array) -> float:
    """Loss of de Koning et al. (2023), eq. 30."""
    total = irradiance.sum() or 1.0  # an image without light differs by all of the target
    difference = irradiance / total - target / target.max() / (target / target.max()).sum()
    return float(np.linalg.norm(difference) / difference.size**0.5)


def scaled(heights: ControlHeights, factor: float) -> ControlHeights:
    """Control heights in another unit, ``factor`` of which are one of now."""
    return FaceArrays({face: _sealed(each * factor) for face, each in heights.items()})


def frozen(values: Array) -> Array:
    """A copy of an array that nobody can change."""
    return _sealed(values.copy())


def _sealed(values: Array) -> Array:
    """An array of one's own, which nobody can change from here on."""
    values.flags.writeable = False
    return values


def _copy(values: "Tensor") -> Array:
    return np.array(values.detach().cpu().numpy(), dtype=np.float64)


class Step(NamedTuple):
    """One evaluated lens."""

    # The lens, with the net of its stage, and its light; losses can be compared over the run.
    state: LensState
    notes: tuple[str, ...] = ()  # what was chosen for this lens's trace, and what was left out
    # What the best lens has least of, where that is not the loss alone; infinite without light on
    # the screen.
    merit: float | None = None
    # The lens in light that it was not fitted to, where a run has looked at that.
    judged: "Step | None" = None
