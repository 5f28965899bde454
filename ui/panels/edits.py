"""One edit of a scene: where, what, and how it is called."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from workbench.errors import Refused
from workbench.quantity import read_number
from workbench.scene import Scene, Unit

_STEP = re.compile(r"[^.\[\]]+")


LENGTH = "length"  # a unit that stands for the scene's own


@dataclass(frozen=True)
class Typed:
    """What was typed for a number, which the unit of the scene gives its meaning.

    Attributes
    ----------
    text : str
        As it was typed.
    unit : str
        Unit of the field; `LENGTH` for the scene's.
    whole : bool
        Whether only whole numbers make sense.
    """

    text: str
    unit: str = ""
    whole: bool = False

    def number(self, unit: str) -> float | int:
        """The number, in a scene with a unit.

        Raises
        ------
        ValueError
            With what is wrong in one sentence.
        """
        found = read_number(self.text, unit if self.unit == LENGTH else self.unit)
        try:
            return int(found) if self.whole and found.denominator == 1 else float(found)
        except OverflowError as error:
            raise ValueError(f"{self.text} is too large") from error


@dataclass(frozen=True)
class Edit:
    """What a field asks for; the scene decides whether it is possible.

    Attributes
    ----------
    path : str
        Field that was touched, as refusals name it (``lens.control_points[0]``).
    text : str
        What the undo menu calls it.
    changes : dict
        New values by path, or what was `Typed` for them; a kind that changes brings its
        neighbours along.
    alone : bool
        Whether it is a step of its own, also after another at the same path.
    unit : str, optional
        Unit that all lengths are converted to, before the changes.
    waits : bool
        Whether it stays in its field when it is refused, to be corrected or to become possible by
        another edit. A file that was chosen or dropped is in no field.
    """

    path: str
    text: str
    changes: dict[str, object]
    alone: bool = False
    unit: Unit | None = None
    waits: bool = True


def value_at(data: dict[str, Any], path: str) -> Any:
    """Value at a path of a scene's plain data; None where the scene has no such field."""
    value: Any = data
    for step in _STEP.findall(path):
        if isinstance(value, list) and int(step) < len(value):
            value = value[int(step)]
        elif isinstance(value, dict) and step in value:
            value = value[step]
        else:
            return None
    return value


def has_place(data: dict[str, Any], edit: Edit) -> bool:
    """Whether a scene, as plain data, has what the edit would change a part of."""
    for path in edit.changes:
        place, last = _place(data, path)
        if not (last < len(place) if isinstance(last, int) else isinstance(place, dict)):
            return False
    return True


def edited_scene(scene: Scene, edits: Iterable[Edit]) -> Scene:
    """The scene after some edits.

    Raises
    ------
    Refused
        If that scene is impossible.
    """
    data = scene.to_data()
    for edit in edits:
        if edit.unit is not None:
            data = Scene.from_data(data).in_unit(edit.unit).to_data()
        for path, value in edit.changes.items():
            place, last = _place(data, path)
            place[last] = _read(value, path, data["unit"])
    return Scene.from_data(data)


def _read(value: object, path: str, unit: str) -> object:
    """The value, with numbers in place of what was typed for them."""
    if isinstance(value, list):
        return [_read(each, path, unit) for each in value]
    if not isinstance(value, Typed):
        return value
    try:
        return value.number(unit)
    except ValueError as error:
        raise Refused(path, f"{error}") from error


def _place(data: dict[str, Any], path: str) -> tuple[Any, int | str]:
    """What holds the value at a path, and the value's index or name there."""
    *parents, last = _STEP.findall(path)
    place: Any = value_at(data, ".".join(parents)) if parents else data
    return place, int(last) if isinstance(place, list) else last
