"""A plate to be held into the sun."""

from pydantic import ConfigDict

from workbench.jobs.fields import (
    SUN,
    Distance,
    ImageSize,
    Material,
    Picture,
    Size,
    Thickness,
    shipped,
)
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import screen
from workbench.scene import Scene


class SunPlate(LensJob):
    """A clear plate in the sun throws a picture onto a wall or table nearby."""

    model_config = ConfigDict(title="Sunlit plate")

    target: Picture = shipped("photo")
    size: Size = (100.0, 100.0)
    material: Material = "PMMA"
    thickness: Thickness = None
    distance: Distance = 500.0
    image_size: ImageSize = (200.0, 200.0)

    def scene(self) -> Scene:
        """Light of the sun's disc, straight onto the plate."""
        light = {"kind": "collimated", "angular_diameter": SUN}
        return self.through_lens(light, screen(self.distance, self.image_size))
