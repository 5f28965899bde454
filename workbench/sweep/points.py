"""Points of a sweep: one design each."""

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
from workbench.said import Said
from workbench.scene import Scene
from workbench.scene.paths import with_values
from workbench.sweep.vary import MOST_POINTS, Value, Variation, shown

_LONGEST_NAME = 100


@dataclass(frozen=True, eq=False)
class Point:
    """A scene with some fields changed.

    Attributes
    ----------
    path : Path
        File of the scene.
    base : Session
        That scene and its target.
    changes : dict
        Values by field.
    scene : Scene or Refused
        What comes of it, or why nothing does.
    """

    path: Path
    base: Session
    changes: dict[str, Value]
    scene: Scene | Refused

    @property
    def name(self) -> str:
        """What people call it."""
        return " ".join([self.path.stem, *(f"{k}={shown(v)}" for k, v in self.changes.items())])

    def session(self) -> Session:
        """The design task with its target.

        Raises
        ------
        Refused
            If there is none, or the target cannot be read.
        """
        if isinstance(self.scene, Refused):
            raise self.scene
        base = Session(self.base.scene, self.base.target, picture=self.base.picture)
        return with_task(base, self.scene, self.path.parent)

    def file_name(self, key: str) -> str:
        """A file name without ending that no other point has."""
        return f"{re.sub(r'[^A-Za-z0-9._=+-]+', '-', self.name)[:_LONGEST_NAME]}-{key[:10]}"


def key_of(session: Session, rays: int) -> str:
    """What a result depends on, as 64 hexadecimal digits: task, target, rays of the check, program.

    Where the target comes from plays no part.
    """
    data = session.scene.to_data() | {"target": None}
    described = json.dumps([data, session.target.shape, rays, __version__], sort_keys=True)
    digest = hashlib.sha256(described.encode())
    digest.update(np.ascontiguousarray(session.target, dtype="<f8").tobytes())
    for light in session.scene.light_files.values():
        digest.update(light or b"")
    return digest.hexdigest()


def points(paths: Sequence[Path], variations: Sequence[Variation]) -> list[Point]:
    """All scenes with all combinations of values, the last field changing first.

    Raises
    ------
    Refused
        If a scene cannot be read, there are too many points or none of them is possible.
    """
    return points_of([(path, open_design(path)) for path in dict.fromkeys(paths)], variations)


def points_of(
    designs: Sequence[tuple[Path, Session]], variations: Sequence[Variation]
) -> list[Point]:
    """As `points`, of designs that are open, each with what its file is or would be called."""
    for number, variation in enumerate(variations):
        if variation.path in [other.path for other in variations[:number]]:
            raise Refused(variation.path, Said("is varied twice; all its values belong together"))
    count = len(designs) * math.prod(len(v.values) for v in variations)
    if count > MOST_POINTS:
        raise Refused(
            "usage",
            Said("{count} points; at most {most} are possible", count=count, most=MOST_POINTS),
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
