"""Curves of a finished benchmark, from the file that it wrote."""

from dataclasses import replace
from pathlib import Path

from pydantic import BaseModel, Field, FiniteFloat, ValidationError

from workbench.analysis.benchmark.frontier import TITLE, Course
from workbench.errors import Refused

METHOD = "auto"
"""The method whose curves are compared."""


class _Row(BaseModel):
    scene: str
    method: str
    curve: list[tuple[FiniteFloat, FiniteFloat]]
    own_curve: list[tuple[FiniteFloat, FiniteFloat]] = []


class _File(BaseModel):
    rows: list[_Row] = Field(alias=TITLE)


def kept_courses(path: Path) -> list[Course]:
    """Read the curves of a result of ``freeform benchmark``.

    `path`: the JSON file that a benchmark with curves has written. Raises `Refused` if it cannot be
    read or is no such file.
    """
    try:
        file = _File.model_validate_json(path.read_bytes())
    except OSError as error:
        raise Refused(str(path), f"cannot be read: {error.strerror or error}") from error
    except ValidationError as error:
        raise Refused(str(path), "has no curves; frontier.json of a benchmark is needed") from error
    return [
        Course(
            row.scene,
            row.method,
            times=tuple(seconds for seconds, _ in row.curve),
            errors=tuple(found for _, found in row.curve),
            own_curve=tuple(row.own_curve),
        )
        for row in file.rows
    ]


def earlier_courses(path: Path) -> list[Course]:
    """What ``auto`` was in a result, to be drawn beside a newer one; see `kept_courses`."""
    return [
        replace(course, method=f"{METHOD}, before", own_curve=())
        for course in kept_courses(path)
        if course.method == METHOD
    ]
