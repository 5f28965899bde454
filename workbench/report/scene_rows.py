"""All fields of a scene with their units."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from workbench.report.content import Fact
from workbench.scene import FieldDescription, Part, Scene

_FILE = {"format", "version"}


class FieldRow(NamedTuple):
    """A field of a scene that has a value.

    Attributes
    ----------
    path : str
        As files and refusals name it.
    title : str
        As forms name it, with the titles of the parts that it is in.
    value : str
        With its unit.
    """

    path: str
    title: str
    value: str


def scene_rows(scene: Scene) -> tuple[Fact, ...]:
    """A row for each field that has a value, those of a kind before those of all kinds."""
    return tuple(Fact(row.path, row.value) for row in field_rows(scene))


def field_rows(scene: Scene) -> Iterator[FieldRow]:
    """A row for each field of a scene that has a value."""
    return _rows(scene, "", "", scene)


def _rows(part: Part, path: str, title: str, scene: Scene) -> Iterator[FieldRow]:
    """Rows of a part, as deep as there are names."""
    remarks = part.remarks()
    for field in part.fields():
        value, place = getattr(part, field.name), f"{path}{field.name}"
        called = f"{title}{field.title}"
        if isinstance(value, Part):
            yield from _rows(value, f"{place}.", f"{called} · ", scene)
        elif field.listed:
            for number, each in enumerate(value):
                where = f"{place}[{number}].", f"{called} {number + 1} · "
                yield from _rows(each, *where, scene)
        elif value is not None and place not in _FILE:
            text = f"{_text(value, field)} {field.measure.words_in(scene.unit)}".rstrip()
            remark = remarks.get(field.name)
            yield FieldRow(place, called, f"{text} ({remark})" if remark else text)


def _text(value: Any, field: FieldDescription) -> str:
    if isinstance(value, tuple):
        if value and isinstance(value[0], tuple):  # places
            return "; ".join(", ".join(_text(each, field) for each in place) for place in value)
        between = " × " if field.between == "×" else ", "
        return between.join(_text(each, field) for each in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
