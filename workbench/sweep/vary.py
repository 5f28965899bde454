"""Fields of a scene and the values that they take: ``lens.thickness=5,8``."""

import re
from dataclasses import dataclass

from workbench.errors import Refused
from workbench.scene.paths import is_path

Value = bool | int | float | str | tuple[int | float, ...]

MOST_POINTS = 10_000
"""Most values of a field, and most points of a sweep."""

_WHOLE = r"[-+]?\d+"
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)
_RANGE = re.compile(rf"({_WHOLE})\.\.({_WHOLE})")


@dataclass(frozen=True)
class Variation:
    """A field and its values.

    Attributes
    ----------
    path : str
        Its path in the scene: ``run.seed``, ``lens.back.control_points``; see
        `workbench.scene.paths`.
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
        if not is_path(path):
            raise Refused("usage", f"--vary {path!r}; a field is needed, as in lens.thickness")
        found = dict.fromkeys(v for part in values.split(",") for v in _values(path, part))
        return cls(path, tuple(found))


def shown(value: Value) -> str:
    """A value as it is typed."""
    if isinstance(value, tuple):
        return "x".join(map(shown, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


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
