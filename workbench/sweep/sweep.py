"""Sweep: points in, rows out, with results kept in a folder.

The folder has a session and its figures for each point. Each file is written atomically, the
figures last: a point with figures is finished, and a later sweep skips it.
"""

import csv
import io
import json
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Protocol, TypeVar

from workbench.design.session import VerifiedError
from workbench.errors import Refused
from workbench.files.atomic import check_writable, locked, make_folder, replacing
from workbench.files.session import Session, read_session, write_session
from workbench.sweep.points import Point, key_of, shown
from workbench.sweep.processes import DesignTask, Done, Failed

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
"""Files of all rows."""
Key = TypeVar("Key")


@dataclass(frozen=True)
class PointRow:
    """Result of a point: figures and session of a lens, or the reason why there is none.

    ``changes`` are values by field as typed, ``figures`` the numbers `FIGURES`.
    """

    scene: str
    changes: dict[str, str]
    figures: dict[str, float]
    session: str | None = None
    reason: str | None = None

    @property
    def verified(self) -> VerifiedError:
        """Verified error of the lens."""
        name = "relative_l2_corrected"
        figures = self.figures
        return VerifiedError(figures[name], (figures[f"{name}_low"], figures[f"{name}_high"]))

    @classmethod
    def of(cls, point: Point, reason: str | None = None) -> "PointRow":
        """Row of a point without a lens."""
        changes = {path: shown(value) for path, value in point.changes.items()}
        return cls(str(point.path), changes, {}, reason=reason)


class Store:
    """Folder of a sweep, made if missing; raise Refused if it is not writable."""

    def __init__(self, folder: Path) -> None:
        make_folder(folder)
        check_writable(folder / TABLES[0])
        self.folder = folder

    def locked(self) -> AbstractContextManager[None]:
        """Lock the folder against other sweeps; raise Refused on entering if it is locked."""
        busy = "another sweep is at work in this folder; wait for it, or give another one by -o"
        return locked(self.folder / _LOCK, busy)

    def find(self, point: Point, key: str) -> PointRow | None:
        """Return the row of a finished point, whose files are there and valid; else None."""
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
        """Write the result of a point and return its row."""
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
    """Rows as plain data for JSON."""
    return {"points": [asdict(row) for row in rows]}


class Workers(Protocol):
    """Something that runs tasks: processes of this machine or a cluster."""

    def work(self, tasks: Iterator[tuple[Key, DesignTask]]) -> Iterator[tuple[Key, Done | Failed]]:
        """Yield each task's key and result."""


def sweep(
    points: Sequence[Point], store: Store, workers: Workers, rays: int
) -> Iterator[tuple[int, PointRow]]:
    """Design a lens at each point and yield the number of the point with its row.

    Refused and finished points come first, then others as they complete. ``rays`` is the least
    number of rays of the independent check. Raise Refused if a result cannot be written.
    """
    pending: list[tuple[int, str]] = []
    for number, point in enumerate(points):
        try:
            key = key_of(point.session(), rays)
        except Refused as refused:
            yield number, PointRow.of(point, str(refused))
            continue
        found = store.find(point, key)
        if found is None:
            pending.append((number, key))
        else:
            yield number, found

    working: dict[tuple[int, str], Session] = {}

    def tasks() -> Iterator[tuple[tuple[int, str], DesignTask]]:
        for each in pending:
            session = working[each] = points[each[0]].session()
            yield each, DesignTask(session.scene, session.target, rays)

    for each, outcome in workers.work(tasks()):
        (number, key), task = each, working.pop(each)
        if isinstance(outcome, Failed):
            yield number, PointRow.of(points[number], outcome.reason)
        else:
            yield number, store.put(points[number], key, task, outcome)
