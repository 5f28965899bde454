"""All fields of a scene with their units."""

from collections.abc import Iterator
from typing import Any

from workbench.report.content import Fact
from workbench.scene import FieldDescription, Part, Scene
from workbench.scene.fields import Since

_FILE = {"format", "version"}


def scene_rows(scene: Scene) -> tuple[Fact, ...]:
    """A row for each field that has a value, those of a kind before those of all kinds.

    Fields that the scene's file leaves out, as its version does not know them, have none.
    """
    return tuple(_rows(scene, "", scene))


def _rows(part: Part, path: str, scene: Scene) -> Iterator[Fact]:
    """Rows of a part, as deep as there are names."""
    remarks = part.remarks()
    for field in part.fields():
        since = field.mark(Since)
        if since is not None and since.version > scene.needed_version:
            continue
        value, place = getattr(part, field.name), f"{path}{field.name}"
        if isinstance(value, Part):
            yield from _rows(value, f"{place}.", scene)
        elif field.listed:
            for number, each in enumerate(value):
                yield from _rows(each, f"{place}[{number}].", scene)
        elif value is not None and place not in _FILE:
            text = f"{_text(value, field)} {field.measure.words_in(scene.unit)}".rstrip()
            remark = remarks.get(field.name)
            yield Fact(place, f"{text} ({remark})" if remark else text)


def _text(value: Any, field: FieldDescription) -> str:
    if isinstance(value, tuple):
        between = " × " if field.between == "×" else ", "
        return between.join(_text(each, field) for each in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
