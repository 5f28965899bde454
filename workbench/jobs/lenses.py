"""Jobs, each with its questions and its scene."""

import math
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ConfigDict, Field

import resources
from workbench.errors import Refused
from workbench.files.scene import read_scene
from workbench.jobs.fields import (
    GREEN_UM,
    SUN,
    WAVELENGTH_NM,
    Distance,
    ImageSize,
    LampDistance,
    LampFlux,
    LampSize,
    Material,
    Pair,
    Picture,
    Size,
    Thickness,
    emitter,
    halves,
    legible,
    lens,
    screen,
    shipped,
)
from workbench.jobs.job import Job, LensJob, proposed
from workbench.messages import Message
from workbench.powers import rounded
from workbench.scene import (
    AutoNet,
    AutoRun,
    BeamTarget,
    Measure,
    PaperRun,
    Positive,
    RectangleTarget,
    RunSettings,
    Scene,
    TopHatTarget,
)
from workbench.scene.fields import ANGLE, FILE, LENGTH, Choices, about


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


_Angle = Annotated[float, Field(gt=0, le=170)]
_BEYOND = 1.1  # times the angle of the light that the far field covers


class TorchBeam(LensJob):
    """An LED and its lens make a round beam of given angles, as of a torch or a downlight."""

    model_config = ConfigDict(title="Beam of a torch or downlight")
    asked_by: ClassVar[dict[str, str]] = {
        "images[0].target.profile": "field_angle",
        "images[0].receiver": "spill_angle",
    }

    beam_angle: Annotated[
        _Angle,
        ANGLE,
        about("Beam angle", "Full angle within which the intensity is at least half of the peak."),
    ] = 20.0
    field_angle: Annotated[
        _Angle,
        ANGLE,
        about("Field angle", "Full angle within which the intensity is at least 10 % of the peak."),
    ] = 40.0
    spill_angle: Annotated[
        float,
        ANGLE,
        about("Spill angle", "Full angle of all light of the beam.", gt=0, le=160),
    ] = 70.0
    spill: Annotated[
        float,
        Measure("%", "of the peak"),
        about("Spill", "Intensity at the edge of the spill, in percent of the peak.", ge=0, le=10),
    ] = 1.0
    lamp_size: LampSize = (1.0, 1.0)
    lamp_flux: LampFlux = None
    lamp_distance: LampDistance = 12.0
    size: Size = (30.0, 30.0)
    material: Material = "PMMA"
    thickness: Thickness = None

    def check(self) -> None:
        """Refuse angles that do not grow from beam to spill."""
        names = "beam_angle", "field_angle", "spill_angle"
        for inner, outer in pairwise(names):
            if getattr(self, outer) <= getattr(self, inner):
                least = getattr(self, inner)
                raise Refused(outer, Message("more than {least:g}, as light fades", least=least))
        super().check()

    def scene(self) -> Scene:
        """The LED's face on the axis, and the beam in the far field."""
        light = emitter(self.lamp_distance, self.lamp_size, self.lamp_flux)
        whole = _BEYOND * self.spill_angle
        levels = {self.beam_angle: 0.5, self.field_angle: 0.1, self.spill_angle: self.spill / 100}
        points = ((rounded(angle / whole, 4), level) for angle, level in levels.items())
        target = BeamTarget(profile=((0.0, 1.0), *points), viewed_from="front")
        field = {"kind": "far_field", "half_angle": halves((whole, whole))}
        return self.through_lens(light, field, target=target)


class LedRectangle(LensJob):
    """An LED close to its lens lights a rectangle or another shape evenly."""

    model_config = ConfigDict(title="LED close by")

    target: Picture = RectangleTarget(width=0.85, height=0.85, viewed_from="front")
    lamp_size: LampSize = (1.0, 1.0)
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


class BeamShaper(LensJob):
    """A Gaussian laser beam becomes an even disc, a rectangle or any other shape."""

    model_config = ConfigDict(title="Laser beam shaper")
    asked_by: ClassVar[dict[str, str]] = {
        "source.wavelength_um": "wavelength",
        "source": "beam_diameter",
    }

    target: Picture = TopHatTarget()
    beam_diameter: Annotated[
        Positive,
        LENGTH,
        about(
            "Beam diameter",
            "Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, across the "
            "beam.",
        ),
    ] = 6.0
    wavelength: Annotated[
        Positive,
        WAVELENGTH_NM,
        about("Wavelength", "Of the laser. It decides the index, and how far light spreads."),
    ] = 633.0
    size: Size = (16.0, 16.0)
    material: Material = "fused silica"
    thickness: Thickness = None
    distance: Distance = 200.0
    image_size: ImageSize = (20.0, 20.0)

    def scene(self) -> Scene:
        """A straight beam about the axis."""
        profile = {"kind": "gaussian", "radius": self.beam_diameter / 2}
        return self.through_lens(
            {"kind": "collimated", "profile": profile},
            screen(self.distance, self.image_size),
            wavelength_um=self.wavelength / 1000,
        )


class WallWasher(LensJob):
    """A lamp above or below a wall lights it evenly from the side."""

    model_config = ConfigDict(title="Wall washer")
    asked_by: ClassVar[dict[str, str]] = {
        "images[0].receiver.half_width": "wall_size",
        "images[0].receiver": "wall_distance",
    }

    target: Picture = RectangleTarget(width=0.9, height=0.9, viewed_from="front")
    wall_size: Annotated[
        Pair, LENGTH, about("Lit wall", "Full width and height of what shall be lit of the wall.")
    ] = (1500.0, 1500.0)
    wall_distance: Annotated[
        Positive, LENGTH, about("Lamp to wall", "From the lamp straight to the wall.")
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
    lamp_size: LampSize = (1.0, 1.0)
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
        half = self.wall_size[1] / 2
        down, up = (math.atan2(edge - self.above, self.wall_distance) for edge in (-half, half))
        aim = (down + up) / 2
        middle = math.hypot(self.wall_distance, self.above)
        off = math.atan2(-self.above, self.wall_distance) - aim
        return {
            "kind": "plane",
            "position": legible(0.0, middle * math.sin(off), middle * math.cos(off)),
            "tilt": legible(math.degrees(aim), 0.0, 0.0),
            "half_width": halves(self.wall_size),
        }


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


_Name = Literal[
    "tophat-none-zeros",
    "tophat-sparse-uniform",
    "tophat-sparse-random",
    "tophat-dense-uniform",
    "flame-x1",
    "flame-x3",
    "flame-x5",
    "ball-x1",
    "ball-x3",
    "ball-x5",
    "flame-point",
    "flame-stages",
]
_TITLES = tuple((example.name, example.title) for example in resources.EXAMPLES)


class Experiment(Job):
    """Designs of de Koning, Heemels, Adam and Möller (2023), to repeat or to improve on."""

    model_config = ConfigDict(title="Experiments of the paper")

    name: Annotated[_Name, Choices(_TITLES), about("Experiment", "A design of the paper.")] = (
        "flame-x3"
    )
    method: Annotated[
        Literal["auto", "paper"],
        Choices((("auto", "Automatic"), ("paper", "As in the paper"))),
        about(
            "Method",
            "How the lens is found: by the best that this program knows, on as many control points "
            "as the target needs, or as then. The 64 × 64 control points of the paper are too few "
            "for fine detail: a flame stays 19 % off.",
        ),
    ] = "auto"

    def scene(self) -> Scene:
        """The example of that name, with the method that was chosen and a net that suits it."""
        scene = read_scene(resources.path("examples", f"{self.name}.json"))
        if self.method == "auto":
            scene = scene.with_optic(scene.optic.shaped(control_points=AutoNet()))
        if self.method == scene.run.method:
            return scene
        kind = PaperRun if self.method == "paper" else AutoRun
        same = {name: getattr(scene.run, name) for name in RunSettings.model_fields}
        return scene.altered(run=kind.model_validate(same | kind.defaults_for(scene)))


class Empty(Job):
    """A square lens in collimated light and a screen behind it; all fields are yours to change."""

    model_config = ConfigDict(title="Empty")

    def scene(self) -> Scene:
        """A lens of 20 mm, and a disc as wide on a screen."""
        return proposed(
            {
                "source": {"kind": "collimated", "wavelength_um": GREEN_UM},
                "elements": [lens((20.0, 20.0), "PMMA")],
                "images": [
                    {"receiver": screen(100.0, (20.0, 20.0)), "target": {"builtin": "tophat"}}
                ],
            }
        )
