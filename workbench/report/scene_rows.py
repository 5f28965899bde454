"""All fields of a scene with their units."""

import re
from collections.abc import Iterator
from typing import Any

from workbench.report.content import Row
from workbench.scene import Part, Scene, dimension_of

_UNITS = {
    "lens.wavelength_um": "µm",
    "filter.size": "pixels",
    "filter.alpha": "per pixel²",
    "target.padding": "of the screen",
    "target.blur": "pixels",
    "target.height": "of the screen's smaller width",
    "target.radius": "of the screen's smaller half-width",
}
_PLACES = {"lens.height_range", "source.position", "source.center"}  # others are sizes
_POWERS = {1: ""}  # what stands behind the unit of length
_FILE = {"format", "version"}
_STAGE = re.compile(r"run\.stages\[\d+\]\.")


def scene_rows(scene: Scene) -> tuple[Row, ...]:
    """A row for each field that has a value, in the order of the scene file."""
    rows = []
    for path, value, power in _fields(scene, ""):
        if path in _FILE:
            continue
        field = _STAGE.sub("", path)
        unit = f"{scene.unit}{_POWERS[power]}" if power else _UNITS.get(field, "")
        text = f"{_text(value, field)} {unit}".rstrip()
        if path == "lens.refractive_index" and isinstance(value, str):
            text = f"{value} (n = {scene.lens.index:.5f})"
        rows.append(Row(path, text))
    return tuple(rows)


def _fields(part: Part, path: str) -> Iterator[tuple[str, Any, int]]:
    """Paths, values and powers of the unit of length, as deep as there are names."""
    for name, field in type(part).model_fields.items():
        value, place = getattr(part, name), f"{path}.{name}" if path else name
        if isinstance(value, Part):
            yield from _fields(value, place)
        elif isinstance(value, tuple) and value and isinstance(value[0], Part):
            for number, each in enumerate(value):
                yield from _fields(each, f"{place}[{number}]")
        elif value not in (None, ()):
            yield place, value, dimension_of(field)


def _text(value: Any, field: str) -> str:
    if isinstance(value, tuple):
        between = ", " if field in _PLACES else " × "
        return between.join(_text(each, field) for each in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
