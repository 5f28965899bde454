"""Base of the jobs, and the proposal of what their questions leave open."""

import json
import math
from abc import abstractmethod
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

from pydantic import ValidationError

from workbench.errors import Refused
from workbench.extended.blur import Blur, diffraction
from workbench.jobs.fields import GREEN_UM, Material, Picture, Size, Thickness, lens, written
from workbench.jobs.slopes import needed_slopes
from workbench.messages import Message
from workbench.powers import rounded
from workbench.refusals import refusal
from workbench.scene import Part, Scene


class Job(Part):
    """A few questions, in millimetres, whose answers make a valid scene."""

    asked_by: ClassVar[dict[str, str]] = {}
    """Field of the job by the beginning of a path in the scene."""

    unit: Literal["mm"] = "mm"

    @abstractmethod
    def scene(self) -> Scene:
        """Return the proposed scene; raise Refused with a path of the scene if it is invalid."""

    def check(self) -> None:
        """Refuse answers without a valid scene, with the path of the job's field."""
        try:
            self.scene()
        except Refused as refused:
            reason = refused.reason
            if isinstance(reason, Message) and ".half_" in refused.path:  # jobs ask for full sizes
                reason = reason.times(2)
            raise Refused(self._asking(refused.path), reason) from None

    def with_answers(self, answers: dict[str, Any]) -> Self:
        """Return the job with other answers, plain data by field; raise Refused if invalid."""
        data = self.model_dump(mode="json", exclude_none=True) | answers
        try:
            return self.model_validate_json(json.dumps(data))
        except ValidationError as error:
            raise refusal(error, type(self)) from None

    def _asking(self, path: str) -> str:
        """Field of the job for a path of the scene, or else the path."""
        if path.startswith("images[0].target"):
            return path.removeprefix("images[0].")
        for beginning, field in (*self.asked_by.items(), *_USUAL):
            if path.startswith(beginning) and field in type(self).model_fields:
                return field
        return path


# The first match counts.
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
    """A lens of some size and material forms a picture or a beam."""

    if TYPE_CHECKING:  # fields of each job that asks for them, in its own order
        target: Picture
        size: Size
        material: Material
        thickness: Thickness

    def through_lens(
        self,
        source: dict[str, Any],
        receiver: dict[str, Any],
        wavelength_um: float = GREEN_UM,
        target: Part | None = None,
    ) -> Scene:
        """Return the proposed scene with a source and a receiver, both as plain data.

        ``target`` is for jobs that do not ask for one.
        """
        return proposed(
            {
                "source": source | {"wavelength_um": wavelength_um},
                "elements": [lens(self.size, self.material)],
                "images": [{"receiver": receiver, "target": written(target or self.target)}],
            },
            self.thickness,
        )


_THINNEST, _LEAST_MM = 0.05, 1.0  # least thickness, in half-widths and in millimetres
# Thickness in the middle above the least, in parts of the rise of the face and of the half-width.
_RISE, _BODY = 0.75, 0.04
_MOST, _FEWEST, _MULTIPLE, _IN_BLUR = 256, 96, 8, 8  # pixels along the longer side and in a blur


def proposed(task: dict[str, Any], thickness: float | None = None) -> Scene:
    """Return the scene of a task in millimetres with thickness and pixels, where it lacks them.

    `task`: plain data of a scene with one element and one image; `thickness`: of the stock.
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
        element = element | {"thickness": rounded(middle, 2)}
    return scene_with(pixels)


def resolution(scene: Scene) -> float:
    """Width of the finest detail, by blur of the source or diffraction, in receiver units."""
    blur = min(blur_widths(scene))
    return max(blur, diffraction(scene))


def blur_widths(scene: Scene) -> tuple[float, float]:
    """Full widths of the source's blur along x and y, in receiver units."""
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
    thin = rounded(max(_THINNEST * half, _LEAST_MM), 2)
    if thickness is None:
        return {"min_thickness": thin, "thickness": half / 2} | given
    thin = min(thin, thickness / 2)
    middle = rounded((thin + thickness) / 2, 3)
    return {"min_thickness": thin, "max_thickness": thickness, "thickness": middle} | given


def _pixels(extent: tuple[float, float], longer: int) -> list[int]:
    side = max(extent)
    return [max(round(longer * each / side / _MULTIPLE), 1) * _MULTIPLE for each in extent]
