"""The job of a mirror: its questions and its scene."""

import math
from typing import Annotated, ClassVar

from pydantic import ConfigDict

from workbench.jobs.fields import (
    SUN,
    ImageSize,
    Pair,
    Picture,
    halves,
    legible,
    mirror,
    shipped,
    written,
)
from workbench.jobs.job import Job, proposed
from workbench.scene import Positive, Scene
from workbench.scene.fields import ANGLE, LENGTH, about


class MirrorJob(Job):
    """A mirror in collimated light, or in the sun, throws a picture to the side."""

    model_config = ConfigDict(title="Mirror")
    asked_by: ClassVar[dict[str, str]] = {"source": "angular_diameter"}

    target: Picture = shipped("letter")
    size: Annotated[
        Pair, LENGTH, about("Mirror size", "Full width and height of the mirror; all of it is lit.")
    ] = (30.0, 30.0)
    angular_diameter: Annotated[
        float,
        ANGLE,
        about(
            "Angular diameter",
            f"Full angle of the light: {SUN} for the sun, 0 for a laser.",
            ge=0,
            lt=90,
        ),
    ] = 0.0
    distance: Annotated[
        Positive,
        LENGTH,
        about("Distance to the image", "From the mirror to the middle of the image."),
    ] = 100.0
    aside: Annotated[
        float,
        ANGLE,
        about(
            "To the side",
            "Angle between the light that comes and the light that goes, which has to pass the "
            "image on its way.",
            ge=0,
            le=80,
        ),
    ] = 45.0
    image_size: ImageSize = (40.0, 40.0)

    def scene(self) -> Scene:
        """An image that faces the mirror, at the side of +x."""
        angle = math.radians(self.aside)
        receiver = {
            "kind": "plane",
            "position": legible(
                self.distance * math.sin(angle), 0.0, -self.distance * math.cos(angle)
            ),
            "tilt": [0.0, -self.aside, 0.0],
            "half_width": halves(self.image_size),
        }
        return proposed(
            {
                "source": {"kind": "collimated", "angular_diameter": self.angular_diameter},
                "elements": [mirror(self.size)],
                "images": [{"receiver": receiver, "target": written(self.target)}],
            }
        )
