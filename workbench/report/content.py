"""Content of a report, independent of its format: sections with rows and pictures."""

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from workbench.errors import Refused
from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.pictures.report import Draw

HTML, PDF = (".html", ".htm"), (".pdf",)


class Fact(NamedTuple):
    """A name and its value."""

    name: str
    value: str


class PagePicture(NamedTuple):
    """A picture as wide as a page; ``height`` in inches, for a width of `pictures.report.WIDTH`."""

    name: str
    draw: "Draw"
    height: float


class Table(NamedTuple):
    """Titles of columns, and rows of as many cells."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Section:
    """A section of a report: heading, note, table, rows, then pictures."""

    title: str
    rows: tuple[Fact, ...] = ()
    pictures: tuple[PagePicture, ...] = ()
    note: str = ""
    table: Table | None = None


@dataclass(frozen=True)
class Report:
    """A report; ``dated`` is the date of the session."""

    title: str
    subtitle: str
    dated: datetime
    sections: tuple[Section, ...]


def check_ending(file: Path) -> None:
    """Raise Refused if the ending of a file is not that of a report."""
    if file.suffix.lower() not in (*HTML, *PDF):
        known = ", ".join((*HTML, *PDF))
        raise Refused(
            str(file), Message("has no known ending; use one of {endings}", endings=known)
        )
