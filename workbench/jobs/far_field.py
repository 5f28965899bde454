"""Light of a lamp that was measured, sent where it is wanted by direction."""

from typing import Annotated, ClassVar

from pydantic import ConfigDict, Field

import resources
from workbench.jobs.fields import LampDistance, Material, Picture, Size, Thickness
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import halves
from workbench.scene import RectangleTarget, Scene
from workbench.scene.fields import ANGLE, FILE, about

_Angle = Annotated[float, Field(gt=0, le=170)]


class StreetLight(LensJob):
    """A lamp of a photometric file sends its light into wanted directions, far away."""

    model_config = ConfigDict(title="Far field of a lamp")
    asked_by: ClassVar[dict[str, str]] = {"source.file": "file"}

    target: Picture = RectangleTarget(width=0.85, height=0.85, viewed_from="front")
    file: Annotated[
        str,
        FILE,
        about(
            "Lamp file",
            "Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt).",
            min_length=1,
        ),
    ] = str(resources.path("lights", "led.ies"))
    lamp_distance: LampDistance = 20.0
    size: Size = (30.0, 30.0)
    material: Material = "PMMA"
    thickness: Thickness = None
    image_angles: Annotated[
        tuple[_Angle, _Angle],
        ANGLE,
        about("Image angles", "Full angles of the image across and upwards."),
    ] = (70.0, 50.0)

    def scene(self) -> Scene:
        """The lamp on the axis, whose nadir looks along it."""
        lamp = {"file": self.file, "position": [0.0, 0.0, -self.lamp_distance]}
        field = {"kind": "far_field", "half_angle": halves(self.image_angles)}
        return self.through_lens({"kind": "photometric", **lamp}, field)
