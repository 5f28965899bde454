"""All fields of a scene with their units."""

import re
from collections.abc import Iterator
from typing import Any

from workbench.report.content import Row
from workbench.scene import Scene

_LENGTHS = {
    "lens.half_width",
    "lens.entrance_z",
    "lens.base.height",
    "lens.base.radius",
    "lens.height_range",
    "lens.min_thickness",
    "source.position",
    "source.center",
    "source.half_width",
    "screen.z",
    "screen.half_width",
    "run.min_radius",
}
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
_FILE = {"format", "version"}
_STAGE = re.compile(r"run\.stages\[\d+\]\.")


def scene_rows(scene: Scene) -> tuple[Row, ...]:
    """A row for each field that has a value, in the order of the scene file."""
    rows = []
    for path, value in _fields(scene.to_data(), ""):
        if path in _FILE:
            continue
        field = _STAGE.sub("", path)
        unit = scene.unit if field in _LENGTHS else _UNITS.get(field, "")
        text = f"{_text(value, field)} {unit}".rstrip()
        if path == "lens.refractive_index" and isinstance(value, str):
            text = f"{value} (n = {scene.lens.index:.5f})"
        rows.append(Row(path, text))
    return tuple(rows)


def _fields(part: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Paths and values, as deep as there are names."""
    if isinstance(part, dict):
        for name, value in part.items():
            yield from _fields(value, f"{path}.{name}" if path else name)
    elif isinstance(part, list) and part and isinstance(part[0], dict):
        for number, value in enumerate(part):
            yield from _fields(value, f"{path}[{number}]")
    elif part != []:
        yield path, part


def _text(value: Any, field: str) -> str:
    if isinstance(value, list):
        between = ", " if field in _PLACES else " × "
        return between.join(_text(each, field) for each in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
