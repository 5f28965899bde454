"""One edit of a scene: where, what, and how it is called."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from workbench.scene import Scene, Unit

_STEP = re.compile(r"[^.\[\]]+")


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
        New values by path; a kind that changes brings its neighbours along.
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
            place[last] = value
    return Scene.from_data(data)


def _place(data: dict[str, Any], path: str) -> tuple[Any, int | str]:
    """What holds the value at a path, and the value's index or name there."""
    *parents, last = _STEP.findall(path)
    place: Any = value_at(data, ".".join(parents)) if parents else data
    return place, int(last) if isinstance(place, list) else last
