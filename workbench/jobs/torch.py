"""A picture from the small lamp that everybody has."""

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
    shipped,
)
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import emitter, screen
from workbench.scene import Scene
from workbench.scene.fields import LENGTH, about


class Torch(LensJob):
    """The light of a telephone or a torch throws a picture onto a wall."""

    model_config = ConfigDict(title="Torch or phone")

    target: Picture = shipped("letter")
    lamp_size: Annotated[
        Pair,
        LENGTH,
        about("Lamp size", "Full width and height of what shines: 1 to 2 mm in a telephone."),
    ] = (1.0, 1.0)
    lamp_flux: LampFlux = None
    lamp_distance: LampDistance = 80.0
    size: Size = (60.0, 60.0)
    material: Material = "PMMA"
    thickness: Thickness = None
    distance: Distance = 200.0
    image_size: ImageSize = (160.0, 160.0)

    def scene(self) -> Scene:
        """A small bright face on the axis."""
        light = emitter(self.lamp_distance, self.lamp_size, self.lamp_flux)
        return self.through_lens(light, screen(self.distance, self.image_size))
