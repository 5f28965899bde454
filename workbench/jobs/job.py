"""What jobs have in common: their questions, and what they propose."""

import json
import math
from abc import abstractmethod
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

from pydantic import ValidationError

from workbench.errors import Refused
from workbench.extended.blur import Blur, diffraction
from workbench.jobs.fields import GREEN_UM, Material, Picture, Size, Thickness, lens, written
from workbench.jobs.slopes import needed_slopes
from workbench.refusals import refusal
from workbench.scene import Part, Scene


class Job(Part):
    """A few questions, in millimetres, whose answers make a scene.

    A job that exists has a scene that is possible.
    """

    asked_by: ClassVar[dict[str, str]] = {}
    """Beginnings of paths of the scene, and the fields whose answers stand there."""

    unit: Literal["mm"] = "mm"

    @abstractmethod
    def scene(self) -> Scene:
        """The design task, with all that is proposed.

        Raises `Refused` if the answers make no scene; the path is one of the scene.
        """

    def check(self) -> None:
        """Refuse answers that make no scene, at the field that asked for them."""
        try:
            self.scene()
        except Refused as refused:
            raise Refused(self._asking(refused.path), refused.reason) from None

    def with_answers(self, answers: dict[str, Any]) -> Self:
        """The job with other answers, plain data by the names of fields.

        Raises `Refused` with the path of the field, the value and what is allowed.
        """
        data = self.model_dump(mode="json", exclude_none=True) | answers
        try:
            return self.model_validate_json(json.dumps(data))
        except ValidationError as error:
            raise refusal(error, type(self)) from None

    def _asking(self, path: str) -> str:
        """The field of the job for a path of the scene; the path itself, if none asks for it."""
        if path.startswith("images[0].target"):
            return path.removeprefix("images[0].")
        for beginning, field in (*self.asked_by.items(), *_USUAL):
            if path.startswith(beginning) and field in type(self).model_fields:
                return field
        return path


# Later ones count only where no earlier one does.
_USUAL = (
    ("images[0].receiver.position[2]", "distance"),
    ("images[0].receiver", "image_size"),
    ("images[0].receiver", "image_angles"),
    ("elements[0].max_thickness", "thickness"),
    ("elements[0].min_thickness", "thickness"),
    ("elements[0].thickness", "thickness"),
    ("elements[0].half_width", "size"),
    ("elements[0].material", "material"),
    ("source.flux", "lamp_flux"),
    ("source", "lamp_distance"),
)


class LensJob(Job):
    """A lens of some size and material brings light into a picture."""

    if TYPE_CHECKING:  # each job asks for these, at their places in the form
        target: Picture
        size: Size
        material: Material
        thickness: Thickness

    def through_lens(
        self, source: dict[str, Any], receiver: dict[str, Any], wavelength_um: float = GREEN_UM
    ) -> Scene:
        """Return the proposed scene with a source and a receiver, both as plain data.

        Raises `Refused` if this is no possible scene.
        """
        return proposed(
            {
                "source": source | {"wavelength_um": wavelength_um},
                "elements": [lens(self.size, self.material)],
                "images": [{"receiver": receiver, "target": written(self.target)}],
            },
            self.thickness,
        )


# A lens is at least this thick, in half-widths and in millimetres, so that it can be made.
_THINNEST, _LEAST_MM = 0.05, 1.0
# The middle of the exit face is above that by this part of what the face rises, and of the lens.
_RISE, _BODY = 0.75, 0.04
# Pixels along the longer side of an image; so many pixels describe what is blurred.
_MOST, _FEWEST, _MULTIPLE, _IN_BLUR = 256, 96, 8, 8


def proposed(task: dict[str, Any], thickness: float | None = None) -> Scene:
    """The scene of a task in millimetres, with what it leaves open.

    `task`: plain data of a scene with one element and one image. A lens may lack its thickness, and
    the receiver its pixels; `thickness`: of the stock that a lens is cut from. Raises `Refused` if
    this is no possible scene.
    """
    (element,), (image,) = task["elements"], task["images"]
    receiver = image["receiver"]
    extent = receiver.get("half_width") or receiver["half_angle"]
    lens = element["kind"] == "lens"
    if lens:
        element = _lens(element, thickness)

    def scene_with(pixels: list[int]) -> Scene:
        seen = image | {"receiver": {"pixels": pixels} | receiver}
        common = {"version": 3, "unit": "mm"}
        return Scene.from_data(task | common | {"elements": [element], "images": [seen]})

    pixels = _pixels(extent, _MOST)
    scene = scene_with(pixels)
    finest = resolution(scene)
    if finest > 0:
        per_side = math.ceil(2 * max(extent) / finest * _IN_BLUR / _MULTIPLE) * _MULTIPLE
        pixels = _pixels(extent, min(max(per_side, _FEWEST), _MOST))
    if lens and thickness is None:
        rise = needed_slopes(scene).rise
        middle = element["min_thickness"] + _RISE * rise + _BODY * max(scene.optic.half_width)
        element = element | {"thickness": float(f"{middle:.2g}")}
    return scene_with(pixels)


def resolution(scene: Scene) -> float:
    """Width of the finest detail that light of the source can draw, in the receiver's measure.

    The larger of the source's blur and of the scale of diffraction.
    """
    blur = min(blur_widths(scene))
    return max(blur, diffraction(scene))


def blur_widths(scene: Scene) -> tuple[float, float]:
    """Full widths of the source's blur along x and y, in the receiver's measure."""
    receiver = scene.receiver
    x, y = (
        2 * half * width / pixels
        for half, width, pixels in zip(
            receiver.half_extent, Blur.of(scene).widths, receiver.pixels, strict=True
        )
    )
    return x, y


def _lens(given: dict[str, Any], thickness: float | None) -> dict[str, Any]:
    half = max(given["half_width"])
    thin = float(f"{max(_THINNEST * half, _LEAST_MM):.2g}")
    if thickness is None:
        return {"min_thickness": thin, "thickness": half / 2} | given
    thin = min(thin, thickness / 2)
    middle = float(f"{(thin + thickness) / 2:.3g}")
    return {"min_thickness": thin, "max_thickness": thickness, "thickness": middle} | given


def _pixels(extent: tuple[float, float], longer: int) -> list[int]:
    """As many along the longer side, and square ones along both."""
    side = max(extent)
    return [max(round(longer * each / side / _MULTIPLE), 1) * _MULTIPLE for each in extent]
