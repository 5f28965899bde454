"""Results of a sweep in a folder: a session and its figures for each point.

Each file is written whole or not at all, the figures last. What has figures is finished, whatever
happened afterwards.
"""

import csv
import io
import json
from collections.abc import Sequence
from contextlib import AbstractContextManager, suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from workbench.design.session import VerifiedError
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.files.lock import locked
from workbench.files.session import Session, read_session, write_session
from workbench.sweep.points import Point
from workbench.sweep.vary import shown
from workbench.sweep.work import Done

FIGURES = (
    "loss",
    "relative_l2",
    "relative_l2_corrected",
    "relative_l2_corrected_low",
    "relative_l2_corrected_high",
    "efficiency",
    "iterations",
    "seconds",
)
"""Numbers in a row; but for the last two those of the independent check.

Between low and high the error without ray noise lies with 95 % confidence.
"""

_LOCK = ".sweep.lock"
_LARGEST = 1 << 20  # bytes of the figures of a point

TABLES = ("table.csv", "table.json")
"""Files of all rows; those of the points have names of their own."""


@dataclass(frozen=True)
class PointRow:
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

    @property
    def verified(self) -> VerifiedError:
        """Error of the lens by its independent check."""
        name = "relative_l2_corrected"
        figures = self.figures
        return VerifiedError(figures[name], (figures[f"{name}_low"], figures[f"{name}_high"]))

    @classmethod
    def of(cls, point: Point, reason: str | None = None) -> "PointRow":
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

    def locked(self) -> AbstractContextManager[None]:
        """The folder without any other sweep at work in it.

        Raises
        ------
        Refused
            When entered, if there is one.
        """
        busy = "another sweep is at work in this folder; wait for it, or give another one by -o"
        return locked(self.folder / _LOCK, busy)

    def find(self, point: Point, key: str) -> PointRow | None:
        """The row of a point that is finished: both of its files are there and whole."""
        name = point.file_name(key)
        with suppress(OSError, ValueError, KeyError, TypeError, Refused):
            with (self.folder / f"{name}.json").open("rb") as file:
                data = json.loads(file.read(_LARGEST))
            session = f"{name}.freeform"
            if data["key"] == key and read_session(self.folder / session).result is not None:
                figures = {figure: float(data[figure]) for figure in FIGURES}
                return replace(PointRow.of(point), figures=figures, session=session)
        return None

    def put(self, point: Point, key: str, task: Session, done: Done) -> PointRow:
        """Keep what was found for a point."""
        name = point.file_name(key)
        result = done.result
        write_session(replace(task, result=result), self.folder / f"{name}.freeform")
        run = {"iterations": result.iterations, "seconds": result.seconds}
        low, high = done.check["relative_l2_corrected_interval"]
        ends = {"relative_l2_corrected_low": low, "relative_l2_corrected_high": high}
        data = {"key": key, **done.check, **ends, **run}
        with replacing(self.folder / f"{name}.json") as file:
            file.write(json.dumps(data, indent=1).encode())
        found = self.find(point, key)
        assert found is not None
        return found

    def write_table(self, rows: Sequence[PointRow]) -> None:
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


def to_data(rows: Sequence[PointRow]) -> dict[str, Any]:
    """Rows as plain dictionaries, for JSON."""
    return {"points": [asdict(row) for row in rows]}
