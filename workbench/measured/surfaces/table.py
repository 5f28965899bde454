"""Points as text: a line for each, which begins with x, y and z.

Columns are separated by commas, semicolons, tabs or spaces, and numbers may have decimal commas.
Lines above the first point are titles; they may name the unit in brackets: "x [mm]". Lines that
begin with a mark of comments are left out, and points whose height is a word such as NaN count as
missing.
"""

import re

import numpy as np

from workbench.measured.surfaces.points import MOST_POINTS, MeasuredSurface, surface_of
from workbench.measured.text import lines_of
from workbench.messages import Message
from workbench.units import WRITTEN

_COMMENTS = ("#", "%", "//", "!", "*")
_MISSING = frozenset({"nan", "bad", "-", "--", "---", "inf", "-inf", "n/a", "null", "none"})
_UNIT = re.compile(r"[\[(]\s*([^\W\d]+)\s*[\])]")
_GAPS = re.compile(r"[\s;]+")
_DECIMAL = re.compile(r"[-+]?\d*,\d+(?:[eE][-+]?\d+)?")
_NUMERIC = re.compile(r"[-+.,\d]")
_SAMPLE = 50  # lines that decide what commas mean


def read_table(content: bytes) -> MeasuredSurface:
    """Read points of a text; raise ValueError if it is invalid."""
    lines = lines_of(content)
    comma = "." if _has_decimal_commas(lines) else " "

    def words_of(line: str) -> list[str]:
        return line.replace(",", comma).replace(";", " ").split()

    first = next((k for k, line in enumerate(lines) if _is_point(words_of(line))), None)
    if first is None:
        raise ValueError(Message("no line of it begins with three numbers x, y and z"))
    numbered = [
        (number, line)
        for number, line in enumerate(lines[first:], start=first + 1)
        if line and not line.startswith(_COMMENTS)
    ]
    if len(numbered) > MOST_POINTS:
        raise ValueError(
            Message("it has more than {most} million points", most=MOST_POINTS // 10**6)
        )
    points = np.array([_point(words_of(line), number) for number, line in numbered])
    found = [match[1] for line in lines[:first] for match in _UNIT.finditer(line)]
    units = [unit for unit in found if unit in WRITTEN]
    if len(units) >= 3:  # a unit for each column
        points *= [float(WRITTEN[unit] / WRITTEN[units[0]]) for unit in units[:3]]
    return surface_of(points, units[0] if units else None)


def _has_decimal_commas(lines: list[str]) -> bool:
    sample = [line for line in lines if _NUMERIC.match(line)][:_SAMPLE]
    words = [word for line in sample for word in _GAPS.split(line) if "," in word]
    return bool(words) and all(_DECIMAL.fullmatch(word) for word in words)


def _is_point(words: list[str]) -> bool:
    try:
        return len([float(word) for word in words[:2]]) == 2 and len(words) > 2
    except ValueError:
        return False


def _point(words: list[str], number: int) -> tuple[float, ...]:
    if len(words) >= 3:
        try:
            return float(words[0]), float(words[1]), float(words[2])
        except ValueError:
            if any(word.lower() in _MISSING for word in words[:3]):
                return np.nan, np.nan, np.nan
    raise ValueError(
        Message(
            "its line {number} has no x, y and z: {line!r}",
            number=number,
            line=" ".join(words)[:30],
        )
    )
