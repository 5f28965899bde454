"""Results of a sweep in a folder: a session and its figures for each point.

Each file is written whole or not at all, the figures last. What has figures is finished, whatever
happened afterwards.
"""

import csv
import io
import json
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import Session, write_session
from workbench.sweep.points import Point
from workbench.sweep.vary import shown
from workbench.sweep.work import Done

FIGURES = (
    "loss",
    "relative_l2",
    "relative_l2_corrected",
    "efficiency",
    "iterations",
    "seconds",
)
"""Numbers in a row; but for the last two those of the independent check."""

_LARGEST = 1 << 20  # bytes of the figures of a point

TABLES = ("table.csv", "table.json")
"""Files of all rows; those of the points have names of their own."""


@dataclass(frozen=True)
class Row:
    """What became of a point.

    Attributes
    ----------
    scene : str
        File of the scene.
    changes : dict
        Values by field, as they are typed.
    figures : dict
        `FIGURES`; empty without a lens.
    session : str, optional
        Name of its file in the folder.
    reason : str, optional
        Why there is no lens.
    """

    scene: str
    changes: dict[str, str]
    figures: dict[str, float]
    session: str | None = None
    reason: str | None = None

    @classmethod
    def of(cls, point: Point, reason: str | None = None) -> "Row":
        """A row without a lens."""
        changes = {path: shown(value) for path, value in point.changes.items()}
        return cls(str(point.path), changes, {}, reason=reason)


class Store:
    """The folder.

    Parameters
    ----------
    folder : Path
        Is made where it is missing.

    Raises
    ------
    Refused
        If it cannot be written.
    """

    def __init__(self, folder: Path) -> None:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise Refused(str(folder), f"cannot be made: {error.strerror or error}") from error
        check_writable(folder / TABLES[0])
        self.folder = folder

    def find(self, point: Point, key: str) -> Row | None:
        """The row of a point that is finished."""
        name = point.file_name(key)
        with suppress(OSError, ValueError, KeyError, TypeError):
            with (self.folder / f"{name}.json").open("rb") as file:
                data = json.loads(file.read(_LARGEST))
            session = f"{name}.freeform"
            if data["key"] == key and (self.folder / session).is_file():
                figures = {figure: float(data[figure]) for figure in FIGURES}
                return replace(Row.of(point), figures=figures, session=session)
        return None

    def put(self, point: Point, key: str, task: Session, done: Done) -> Row:
        """Keep what was found for a point."""
        name = point.file_name(key)
        result = done.result
        write_session(replace(task, result=result), self.folder / f"{name}.freeform")
        run = {"iterations": result.iterations, "seconds": result.seconds}
        data = {"key": key, **done.check, **run}
        with replacing(self.folder / f"{name}.json") as file:
            file.write(json.dumps(data, indent=1).encode())
        found = self.find(point, key)
        assert found is not None
        return found

    def write_table(self, rows: Sequence[Row]) -> None:
        """Write all rows as table.csv and table.json."""
        text = io.StringIO(newline="")
        paths = list(dict.fromkeys(path for row in rows for path in row.changes))
        writer = csv.writer(text)
        writer.writerow(["scene", *paths, *FIGURES, "session", "reason"])
        for row in rows:
            changes = [row.changes.get(path, "") for path in paths]
            figures = [row.figures.get(name, "") for name in FIGURES]
            writer.writerow([row.scene, *changes, *figures, row.session, row.reason])
        with replacing(self.folder / TABLES[0]) as file:
            file.write(text.getvalue().encode())
        with replacing(self.folder / TABLES[1]) as file:
            file.write(json.dumps(to_data(rows), indent=1).encode())


def to_data(rows: Sequence[Row]) -> dict[str, Any]:
    """Rows as plain dictionaries, for JSON."""
    return {"points": [asdict(row) for row in rows]}
