"""An even rectangle from an LED that is close by."""

from typing import Annotated

from pydantic import ConfigDict

from workbench.jobs.fields import (
    Distance,
    ImageSize,
    LampDistance,
    LampFlux,
    Material,
    Pair,
    Picture,
    Size,
    Thickness,
)
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import emitter, screen
from workbench.scene import RectangleTarget, Scene
from workbench.scene.fields import LENGTH, about


class LedRectangle(LensJob):
    """An LED close to its lens lights a rectangle or another shape evenly."""

    model_config = ConfigDict(title="LED close by")

    target: Picture = RectangleTarget(width=0.85, height=0.85, viewed_from="front")
    lamp_size: Annotated[
        Pair,
        LENGTH,
        about("LED size", "Full width and height of the LED's bright face."),
    ] = (1.0, 1.0)
    lamp_flux: LampFlux = None
    lamp_distance: LampDistance = 15.0
    size: Size = (40.0, 30.0)
    material: Material = "PC"
    thickness: Thickness = None
    distance: Distance = 150.0
    image_size: ImageSize = (240.0, 150.0)

    def scene(self) -> Scene:
        """The LED's face on the axis, which shines into the whole half-space."""
        light = emitter(self.lamp_distance, self.lamp_size, self.lamp_flux)
        return self.through_lens(light, screen(self.distance, self.image_size))
