"""What the image by cells says of a lens, and how far random rays are from it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.cells.image import CellImage
from workbench.analysis.metrics import paper_loss, relative_l2, root
from workbench.analysis.scatter import Unscattered
from workbench.scene import AnyReceiver

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class ByCells:
    """Error of a lens without random rays, and random rays as the second opinion.

    Attributes
    ----------
    relative_l2_corrected : float
        ‖I − T‖ / ‖T‖ of image and target, each divided by its sum. No rays scatter here.
    relative_l2_corrected_interval : tuple[float, float]
        Where it lies, by the bound of the image's error.
    loss : float
        Paper's loss (section 2.4).
    efficiency : float
        Part of the emitted flux that lands on the screen.
    bound : float
        Bound of the error of the image, over its norm; see `imaging`.
    wanted : float
        What this was to be at most.
    cells : tuple[int, int]
        Cells along x and y.
    difference : float
        ‖R − I‖ / ‖I‖ of the image R of random rays.
    noise : float
        What that would be by the scatter of the rays alone.
    unscattered : Unscattered
        The same difference without their scatter.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen, row 0 at +y.
    """

    relative_l2_corrected: float
    relative_l2_corrected_interval: tuple[float, float]
    loss: float
    efficiency: float
    bound: float
    wanted: float
    cells: tuple[int, int]
    difference: float
    noise: float
    unscattered: Unscattered
    irradiance: Array

    @classmethod
    def of(
        cls,
        image: CellImage,
        target: Array,
        receiver: AnyReceiver,
        of_rays: Array,
        products: Sequence[float],
    ) -> "ByCells":
        """Compare an image with the target and with one of random rays.

        Parameters
        ----------
        image : CellImage
            The image by cells.
        target, of_rays : ndarray, shape (n_y, n_x)
            The target and the image of random rays, in any scale.
        receiver : AnyReceiver
            What the images are on.
        products : sequence of float
            Those of differences to the image by cells, for `Unscattered`.
        """
        irradiance = image.irradiance
        error, bound = image.error(target)
        difference = relative_l2(of_rays, irradiance)
        return cls(
            relative_l2_corrected=error,
            relative_l2_corrected_interval=(max(error - bound, 0.0), error + bound),
            loss=paper_loss(irradiance, target),
            efficiency=receiver.total(irradiance),
            bound=image.bound,
            wanted=image.wanted,
            cells=image.cells,
            difference=difference,
            noise=root(difference**2 - float(np.mean(products))),
            unscattered=Unscattered.of(products),
            irradiance=irradiance,
        )

    @property
    def difference_over_noise(self) -> float | None:
        """How far random rays are from this image, in units of their noise: 1 if both are right."""
        return self.difference / self.noise if self.noise > 0 else None

    @property
    def less_exact(self) -> str | None:
        """That the image is less exact than was asked for, and why; None where it is not."""
        if self.bound <= self.wanted:
            return None
        return (
            f"off by up to {100 * self.bound:.2g} %, not {100 * self.wanted:.2g} %: "
            "finer cells would take too many rays"
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
            "difference": self.difference,
            "noise": self.noise,
            "difference_over_noise": self.difference_over_noise,
            "difference_corrected": self.unscattered.distance,
            "difference_corrected_interval": list(self.unscattered.interval),
        }
