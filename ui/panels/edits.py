"""One edit of a scene: where, what, and how it is called."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ui.words import tr
from workbench.errors import Refused
from workbench.messages import Message
from workbench.quantity import read_number
from workbench.scene import FieldDescription, Measure, Part, Scene, Unit
from workbench.scene.paths import value_at
from workbench.units import sized

_INDEX = re.compile(r"\[\d+\]$")
_NONE = Measure()


@dataclass(frozen=True)
class Typed:
    """Typed text of a number, read in the unit of the scene."""

    text: str
    measure: Measure = _NONE
    whole: bool = False
    times: float = 1.0  # as large as the number in the scene

    def number(self, unit: str) -> float | int:
        found = read_number(self.text, self.measure.sign_in(unit)) / Fraction(self.times)
        try:
            return int(found) if self.whole and found.denominator == 1 else float(found)
        except OverflowError as error:
            raise ValueError(f"{self.text} is too large") from error


@dataclass(frozen=True)
class Edit:
    """Requested changes of a scene, which may be refused."""

    path: str
    text: str
    changes: dict[str, object]
    alone: bool = False
    unit: Unit | None = None
    waits: bool = True
    name: str = ""
    drag: str = ""  # which drag it belongs to; one that is refused is dropped

    @property
    def field(self) -> str:
        """Path of the field, without the index of a number."""
        return _INDEX.sub("", self.path)

    def step(self, before: Scene, after: Scene) -> str:
        """Return the text of the undo step, with old and new numbers: half width 1 → 50 mm."""
        field = field_at(after, self.field)
        if field is None:
            return self.text
        values = (value_at(scene, self.field) for scene in (before, after))
        old, new = (_numbers(value, field.times) for value in values)
        if old == new or not (old and new):
            return self.text
        if field.between == "×" and len({*old}) == len({*new}) == 1:  # alike along x and y
            old, new = old[:1], new[:1]
        change = sized(f"{_joined(field, old)} → {_joined(field, new)}", _unit(field, after))
        return f"{self.name or self.text} {change}".rstrip()


def _numbers(value: object, times: float) -> list[str]:
    values = value if isinstance(value, tuple) else (value,)
    if not all(isinstance(each, int | float) and not isinstance(each, bool) for each in values):
        return []
    return [format(times * each, ".6g") for each in values]


def holder_of(whole: Any, path: str) -> tuple[Any, int | str]:
    """Return what holds the value at a path, and the value's index or name there."""
    separator, inner = ("[", path[:-1]) if path.endswith("]") else (".", path)
    head, _, last = inner.rpartition(separator)
    holder = value_at(whole, head) if head else whole
    return holder, int(last) if isinstance(holder, list | tuple) else last


def field_at(whole: Any, path: str) -> FieldDescription | None:
    """Return the description of the field at a path, if a part of the scene has it."""
    part, name = holder_of(whole, path)
    fields = part.fields() if isinstance(part, Part) else ()
    return next((field for field in fields if field.name == name), None)


def field_in_words(scene: Scene, path: str) -> str:
    """Return title and numbers of the field at a path: Position 0, 0, 5 cm."""
    field = field_at(scene, path)
    if field is None:
        return ""
    numbers = _joined(field, _numbers(value_at(scene, path), field.times))
    return f"{tr(field.in_window.title)} {sized(numbers, _unit(field, scene))}"


def _joined(field: FieldDescription, numbers: list[str]) -> str:
    return f" {field.between} ".replace(" ,", ",").join(numbers)


def _unit(field: FieldDescription, scene: Scene) -> str:
    return field.measure.sign_in(scene.unit)


def has_place(scene: Scene, edit: Edit) -> bool:
    """Whether the scene has the fields of an edit."""
    for path in edit.changes:
        holder, last = holder_of(scene, path)
        if not (last < len(holder) if isinstance(last, int) else isinstance(holder, Part)):
            return False
    return True


def edited_scene(scene: Scene, edits: Iterable[Edit]) -> Scene:
    """Return the scene after some edits, validated once."""
    data: dict[str, Any] = {}  # once there is a change
    for edit in edits:
        if edit.unit is not None:
            scene = (Scene.from_data(data) if data else scene).in_unit(edit.unit)
            data = {}
        if edit.changes and not data:
            data = scene.to_data()
        put(edit, data)
    if not data:
        return scene
    found = Scene.from_data(data)
    # Where nothing is changed, a net that was chosen stays chosen.
    return scene if found == scene.with_net(None) else found


def put(edit: Edit, data: dict[str, Any]) -> None:
    """Put the changes of an edit into plain data."""
    for path, value in edit.changes.items():
        holder, last = holder_of(data, path)
        if not isinstance(holder, list | dict):  # another edit has taken it away
            raise Refused(path, Message("the task no longer has this field"))
        found = _read(value, path, data["unit"])
        holder[last] = found  # type: ignore[index]  # a list has an index here


def _read(value: object, path: str, unit: str) -> object:
    if isinstance(value, list):
        return [_read(each, path, unit) for each in value]
    if not isinstance(value, Typed):
        return value
    try:
        return value.number(unit)
    except ValueError as error:
        raise Refused(path, f"{error}") from error
