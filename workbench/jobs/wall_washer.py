"""An evenly lit wall beside a lamp."""

import math
from typing import Annotated, Any, ClassVar

from pydantic import ConfigDict

from workbench.jobs.fields import LampDistance, LampFlux, Material, Pair, Picture, Size, Thickness
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import emitter, halves
from workbench.scene import Positive, RectangleTarget, Scene
from workbench.scene.fields import LENGTH, about


class WallWasher(LensJob):
    """A lamp at the ceiling, or on the floor, lights a wall evenly from the side."""

    model_config = ConfigDict(title="Wall washer")
    asked_by: ClassVar[dict[str, str]] = {
        "images[0].receiver.half_width": "wall_size",
        "images[0].receiver": "wall_distance",
    }

    target: Picture = RectangleTarget(width=0.9, height=0.9, viewed_from="front")
    wall_size: Annotated[
        Pair,
        LENGTH,
        about("Lit wall", "Full width and height of what shall be lit of the wall."),
    ] = (1500.0, 1500.0)
    wall_distance: Annotated[
        Positive,
        LENGTH,
        about("Lamp to wall", "From the lamp straight to the wall."),
    ] = 1500.0
    above: Annotated[
        float,
        LENGTH,
        about(
            "Lamp above the middle",
            "How much higher than the middle of the lit wall the lamp is; below it, less than 0.",
            ge=-1e6,
            le=1e6,
        ),
    ] = 900.0
    lamp_size: Annotated[
        Pair,
        LENGTH,
        about("LED size", "Full width and height of the LED's bright face."),
    ] = (1.0, 1.0)
    lamp_flux: LampFlux = None
    lamp_distance: LampDistance = 25.0
    size: Size = (40.0, 40.0)
    material: Material = "PMMA"
    thickness: Thickness = None

    def scene(self) -> Scene:
        """The wall as a screen that is turned about x, since the lamp looks at it aslant."""
        light = emitter(self.lamp_distance, self.lamp_size, self.lamp_flux)
        return self.through_lens(light, self._wall())

    def _wall(self) -> dict[str, Any]:
        """The wall as the lamp sees it, which looks half-way between its lower and upper edge."""
        half = self.wall_size[1] / 2
        down, up = (math.atan2(edge - self.above, self.wall_distance) for edge in (-half, half))
        aim = (down + up) / 2
        middle = math.hypot(self.wall_distance, self.above)
        off = math.atan2(-self.above, self.wall_distance) - aim
        return {
            "kind": "plane",
            "position": [0.0, middle * math.sin(off), middle * math.cos(off)],
            "tilt": [math.degrees(aim), 0.0, 0.0],
            "half_width": halves(self.wall_size),
        }
