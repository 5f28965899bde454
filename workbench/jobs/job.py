"""What all jobs have in common."""

import json
from abc import abstractmethod
from typing import Any, ClassVar, Literal, Self

from pydantic import ValidationError

from workbench.errors import Refused
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
