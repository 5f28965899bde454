"""A lens with its light: the one value that goes from the tracer to files and views."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Self

import numpy as np
import numpy.typing as npt

from workbench.design.shortfall import Shortfall
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.optics.account import Account

if TYPE_CHECKING:
    from torch import Tensor

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LensState:
    """A lens and what has been computed of it.

    Attributes
    ----------
    heights : ControlHeights
        Control heights of each freeform face by its name, scene units.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen, row 0 at +y.
    loss : float
        Paper's loss (section 2.4) as the optimiser sees it.
    account : Account
        Where the light goes.
    shortfall : Shortfall, optional
        What the task needs beyond the limits of the heights, where that is known to hinder it.
    """

    heights: ControlHeights
    irradiance: Array
    loss: float
    account: Account
    shortfall: Shortfall | None = None

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

        Parameters
        ----------
        heights : mapping of str to Tensor, shape (n_u, n_v)
            Control heights of each freeform face by its name.
        flux : Tensor, shape (n_y, n_x)
            Light in each pixel.
        pixel_measure : float or ndarray
            What each pixel covers; see `workbench.scene.AnyReceiver`.
        loss : Tensor
            Paper's loss, one number.
        account : Account
            Where the light goes.
        """
        irradiance = _copy(flux)
        irradiance /= pixel_measure
        copies = FaceArrays({face: _sealed(_copy(each)) for face, each in heights.items()})
        return cls(copies, _sealed(irradiance), loss.item(), account)

    def scaled(self, factor: float, density: float) -> Self:
        """The same lens with lengths in another unit.

        Parameters
        ----------
        factor : float
            So many of them are one of now.
        density : float
            By this the irradiance is divided.
        """
        return replace(
            self,
            heights=scaled(self.heights, factor),
            irradiance=_sealed(self.irradiance / density),
            shortfall=self.shortfall and self.shortfall.scaled(factor),
        )


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
