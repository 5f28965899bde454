"""A report before it has a form: sections of rows and pictures."""

from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from workbench.pictures.report import Draw


class Fact(NamedTuple):
    """A name and what is to be said of it."""

    name: str
    value: str


class PagePicture(NamedTuple):
    """A picture as wide as a page.

    Attributes
    ----------
    name : str
        What it shows.
    draw : Draw
        Draws it.
    height : float
        Inches, for a width of `workbench.pictures.report.WIDTH`.
    """

    name: str
    draw: "Draw"
    height: float


@dataclass(frozen=True)
class Section:
    """A part of a report.

    Attributes
    ----------
    title : str
        Its heading.
    rows : tuple of Fact
        What is known.
    pictures : tuple of PagePicture
        Stand behind the rows.
    note : str
        What has to be known to read it.
    """

    title: str
    rows: tuple[Fact, ...] = ()
    pictures: tuple[PagePicture, ...] = ()
    note: str = ""


@dataclass(frozen=True)
class Report:
    """All of it.

    Attributes
    ----------
    title, subtitle : str
        Session, of when it is and by what it was reported.
    dated : datetime
        Of when it is.
    sections : tuple of Section
        One after the other.
    """

    title: str
    subtitle: str
    dated: datetime
    sections: tuple[Section, ...]
