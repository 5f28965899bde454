"""Fields of a scene and the values that they take: ``lens.control_points=32,64x48``."""

import copy
import re
from dataclasses import dataclass
from typing import Any

from workbench.errors import Refused
from workbench.scene import Scene

Value = bool | int | float | str | tuple[int | float, ...]

MOST_POINTS = 10_000
"""Most values of a field, and most points of a sweep."""

_WHOLE = r"[-+]?\d+"
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)
_RANGE = re.compile(rf"({_WHOLE})\.\.({_WHOLE})")
_STEP = re.compile(r"\.?([A-Za-z_]\w*)|\[(\d+)\]")


@dataclass(frozen=True)
class Variation:
    """A field and its values.

    Attributes
    ----------
    path : str
        The field as refusals name it: ``run.seed``, ``source.position[2]``.
    values : tuple
        What it takes, one after the other.
    """

    path: str
    values: tuple[Value, ...]

    @classmethod
    def parse(cls, text: str) -> "Variation":
        """Read ``field=values``.

        Values stand between commas: numbers, whole numbers from ``a..b``, ``AxB`` for a list of
        numbers, true, false; anything else is text.

        Raises
        ------
        Refused
            If that is not what it is.
        """
        path, sign, values = text.partition("=")
        if not sign:
            raise Refused("usage", f"--vary {text!r}; field=values is needed, as in run.seed=0..4")
        _steps(path)
        found = dict.fromkeys(v for part in values.split(",") for v in _values(path, part))
        return cls(path, tuple(found))


def shown(value: Value) -> str:
    """A value as it is typed."""
    if isinstance(value, tuple):
        return "x".join(map(shown, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


def varied(scene: Scene, changes: dict[str, Value]) -> Scene:
    """A scene with some fields changed; what it left to defaults follows these anew.

    A single number for a field that is a list of numbers stands for each of them.

    Raises
    ------
    Refused
        If that scene is not possible.
    """
    data = scene.model_dump(mode="json", exclude_unset=True, exclude_none=True)
    full = scene.settled().to_data()
    for path, value in changes.items():
        _put(data, full, path, value)
    return Scene.from_data(data).with_contents_of(scene)


def _values(path: str, text: str) -> list[Value]:
    if not text:
        raise Refused(path, "a value is empty; values stand between commas, as in 0,1,2")
    if ends := _RANGE.fullmatch(text):
        first, last = int(ends[1]), int(ends[2])
        if not first <= last < first + MOST_POINTS:
            raise Refused(path, f"{text}; 1 to {MOST_POINTS} whole numbers upwards are possible")
        return list(range(first, last + 1))
    if all(_NUMBER.fullmatch(end) for end in text.split("..")) and ".." in text:
        raise Refused(path, f"{text}; from a to b goes with whole numbers only")
    parts = text.split("x")
    if all(_NUMBER.fullmatch(part) for part in parts):
        numbers = tuple(map(_number, parts))
        return [numbers if len(numbers) > 1 else numbers[0]]
    return [{"true": True, "false": False}.get(text, text)]


def _number(text: str) -> int | float:
    return int(text) if re.fullmatch(_WHOLE, text) else float(text)


def _steps(path: str) -> list[str | int]:
    """Names and indices along a path."""
    if not re.fullmatch(rf"(?:{_STEP.pattern})+", path) or path.startswith((".", "[")):
        raise Refused("usage", f"--vary {path!r}; a field is needed, as in lens.control_points")
    return [int(found[2]) if found[2] else found[1] for found in _STEP.finditer(path)]


def _put(data: Any, full: Any, path: str, value: Value) -> None:
    """Change a field in ``data``, taking over from ``full`` what it leaves to defaults."""
    steps: list[Any] = _steps(path)
    *parents, last = steps
    for step in parents:
        full = _child(full, step)
        if isinstance(data, dict) and step not in data:
            # Objects fill up with their defaults; of a list all is needed.
            data[str(step)] = copy.deepcopy(full) if isinstance(full, list) else {}
        data = _child(data, step)
    if isinstance(last, int) != isinstance(data, list) or not isinstance(data, list | dict):
        raise Refused(path, "unknown field; there is no such part of the scene")
    if isinstance(last, int) and last >= len(data):
        raise Refused(path, f"there are only {len(data)} of them; 0 to {len(data) - 1}")
    before = _child(full, last)
    listed: Any = list(value) if isinstance(value, tuple) else value
    if isinstance(before, list) and isinstance(value, int | float):
        listed = [value] * len(before)
    data[last] = listed


def _child(part: Any, step: str | int) -> Any:
    """What is at a step; None where there is nothing."""
    try:
        return part[step]
    except (KeyError, IndexError, TypeError):
        return None
