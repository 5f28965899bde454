"""Points of a sweep: one design for each combination of field values."""

import hashlib
import itertools
import json
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from workbench import __version__
from workbench.design.task import with_task
from workbench.errors import Refused
from workbench.files.scene import with_absolute_files
from workbench.files.session import Session, open_design
from workbench.messages import Message
from workbench.scene import Scene
from workbench.scene.paths import is_path, with_values

Value = bool | int | float | str | tuple[int | float, ...]
MOST_POINTS = 10_000
"""Most values of a field and most points of a sweep."""
_WHOLE = r"[-+]?\d+"
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)
_RANGE = re.compile(rf"({_WHOLE})\.\.({_WHOLE})")
_LONGEST_NAME = 100


@dataclass(frozen=True)
class Variation:
    """A field, by its path as in ``source.position[2]``, and its values."""

    path: str
    values: tuple[Value, ...]

    @classmethod
    def parse(cls, text: str) -> "Variation":
        """Parse ``field=values``; raise Refused if that fails.

        Values are separated by commas: numbers, integers from ``a..b``, ``AxB`` for a list of
        numbers, true, false; anything else is text.
        """
        path, values = _field_and_text(f"--vary {text!r}", text, "values", "run.seed=0..4")
        found = dict.fromkeys(v for part in values.split(",") for v in _values(path, part))
        return cls(path, tuple(found))


def parse_setting(text: str) -> tuple[str, Value]:
    """Return path and value of ``field=value``; raise Refused if that fails.

    A value is a number, ``AxB`` for a list of numbers, true or false; anything else is text.
    """
    path, value = _field_and_text(f"--set {text!r}", text, "value", "run.seed=1")
    if len(found := _values(path, value)) > 1:
        raise Refused(path, f"{value}; one value is needed")
    return path, found[0]


def _field_and_text(given: str, text: str, needed: str, example: str) -> tuple[str, str]:
    path, sign, values = text.partition("=")
    if not (sign and is_path(path)):
        raise Refused("usage", f"{given}; field={needed} is needed, as in {example}")
    return path, values


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


@dataclass(frozen=True, eq=False)
class Point:
    """A scene file with some fields changed; ``scene`` is the result, or why there is none."""

    path: Path
    base: Session
    changes: dict[str, Value]
    scene: Scene | Refused

    @property
    def name(self) -> str:
        """Name of the point, with its values."""
        return " ".join([self.path.stem, *(f"{k}={shown(v)}" for k, v in self.changes.items())])

    def session(self) -> Session:
        """Return the design task with its target; raise Refused if there is none."""
        if isinstance(self.scene, Refused):
            raise self.scene
        base = Session(self.base.scene, self.base.target, picture=self.base.picture)
        return with_task(base, self.scene, self.path.parent)

    def file_name(self, key: str) -> str:
        """File name without ending that no other point has."""
        return f"{re.sub(r'[^A-Za-z0-9._=+-]+', '-', self.name)[:_LONGEST_NAME]}-{key[:10]}"


def key_of(session: Session, rays: int) -> str:
    """Return a digest of all that a result depends on: task, target, rays, program version.

    The path of the target is not part of it.
    """
    data = session.scene.to_data()
    data["images"][0]["target"] = None
    described = json.dumps([data, session.target.shape, rays, __version__], sort_keys=True)
    digest = hashlib.sha256(described.encode())
    digest.update(np.ascontiguousarray(session.target, dtype="<f8").tobytes())
    for light in session.scene.light_files.values():
        digest.update(light or b"")
    return digest.hexdigest()


def points(paths: Sequence[Path], variations: Sequence[Variation]) -> list[Point]:
    """Return all combinations of scenes and values, the last field varying fastest.

    Raise Refused if a scene cannot be read, there are too many points, or none of them is possible.
    """
    return points_of([(path, open_design(path)) for path in dict.fromkeys(paths)], variations)


def points_of(
    designs: Sequence[tuple[Path, Session]], variations: Sequence[Variation]
) -> list[Point]:
    """Return all combinations for open designs, each with the path of its file; see `points`."""
    for number, variation in enumerate(variations):
        if variation.path in [other.path for other in variations[:number]]:
            raise Refused(
                variation.path, Message("is varied twice; all its values belong together")
            )
    count = len(designs) * math.prod(len(v.values) for v in variations)
    if count > MOST_POINTS:
        raise Refused(
            "usage",
            Message("{count} points; at most {most} are possible", count=count, most=MOST_POINTS),
        )
    found = []
    for path, base in designs:
        for values in itertools.product(*(v.values for v in variations)):
            changes = dict(zip((v.path for v in variations), values, strict=True))
            found.append(Point(path, base, changes, _scene(base.scene, changes, path)))
    refusals = [point.scene for point in found if isinstance(point.scene, Refused)]
    if len(refusals) == len(found):
        raise refusals[0]
    return found


def _scene(base: Scene, changes: dict[str, Value], path: Path) -> Scene | Refused:
    try:
        scene = with_absolute_files(with_values(base, changes), path)
        scene.check_one_image("a sweep")
        return scene
    except Refused as refused:
        return refused
