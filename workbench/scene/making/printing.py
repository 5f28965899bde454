"""Resin printing."""

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import ConfigDict

from workbench.powers import rounded
from workbench.scene.element import Element
from workbench.scene.fields import LENGTH, about
from workbench.scene.making.process import Process, Shrinkage, check_width
from workbench.scene.making.relief import Terraces
from workbench.scene.part import NonNegative, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_WIDEST = 0.25  # of the half-width


class Printing(Process):
    """Resin printing in layers along z, which pixels of light cure; then dipping or coating."""

    model_config = ConfigDict(title="Resin printing")

    kind: Literal["printing"] = "printing"
    layer_height: Annotated[
        Positive, LENGTH, about("Layer height", "Thickness of each layer, along z.")
    ]
    pixel_size: Annotated[
        Positive, LENGTH, about("Pixel size", "Width of the pixels of light that cure a layer.")
    ]
    dip_width: Annotated[
        NonNegative,
        LENGTH,
        about(
            "Dip width",
            "Rms width of the Gaussian by which a dip in resin, or a coat of varnish, averages "
            "the face; 0 for none.",
        ),
    ] = 0.0
    shrinkage: Shrinkage = 0.0

    @property
    def smoothing(self) -> float:
        """The dip, and the width of a pixel as that of a uniform distribution."""
        return math.hypot(self.dip_width, self.pixel_size / math.sqrt(12))

    @property
    def shrunk(self) -> float:
        """Its shrinkage."""
        return self.shrinkage

    @property
    def reliefs(self) -> tuple[Terraces, ...]:
        """Steps between layers."""
        return (Terraces(self.layer_height, self.smoothing),)

    def check_for(self, element: Element) -> None:
        """Refuse layers and pixels that leave no shape."""
        for name in ("layer_height", "pixel_size", "dip_width"):
            check_width(name, getattr(self, name), element, _WIDEST)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Layers and pixels that are fine beside the lens."""
        size = rounded(0.001 * min(scene.optic.half_width), 1)
        return {"layer_height": size, "pixel_size": size, "dip_width": 4 * size}
