"""How soon a person needs a field, and fields of which the window shows a multiple."""

from dataclasses import dataclass
from enum import IntEnum


class Level(IntEnum):
    """Mark of a field: how soon a person needs it; without the mark at once."""

    JOB = 0  # whatever a job needs
    LIMITS = 1  # what bounds the part
    EXPERT = 2  # how it is computed, and what is seldom changed


LIMITS, EXPERT = Level.LIMITS, Level.EXPERT


@dataclass(frozen=True)
class Shown:
    """Mark of a field of which the window shows and reads a multiple, under another title."""

    title: str
    tip: str
    times: float


def full_size(tip: str) -> Shown:
    """Return the mark of half widths, which the window shows as full ones."""
    return Shown("Size", tip, 2.0)
