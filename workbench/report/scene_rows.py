"""All fields of a scene with their units, and the fields in which two scenes differ."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from workbench.messages import capitalised
from workbench.report.content import Fact
from workbench.scene import Element, FieldDescription, Part, Scene
from workbench.scene.part import title_of

_FILE = {"format", "version"}
_NONE = "–"


class FieldRow(NamedTuple):
    """A field with a value: its path as in files, its title with those of its parts."""

    path: str
    title: str
    value: str


def scene_rows(scene: Scene) -> dict[str, tuple[Fact, ...]]:
    """Return a row for each field that has a value, by the titles of its parts.

    Elements go by their names; a single image is not counted; files have no folder.
    """
    named = {
        f"Elements {number} · ": f"{element.name} · "
        for number, element in enumerate(scene.elements, 1)
    }
    if len(scene.images) == 1:
        named["Images 1 · "] = ""
    files = dict(scene.files())
    groups: dict[str, list[Fact]] = {}
    for row in field_rows(scene):
        title = _renamed(row.title, named)
        group, _, name = title.partition(" · ") if " · " in title else ("Scene", "", title)
        value = Path(files[row.path]).name if row.path in files else row.value
        if value:
            groups.setdefault(capitalised(group), []).append(Fact(name, value))
    return {group: tuple(rows) for group, rows in groups.items()}


def _renamed(title: str, named: Mapping[str, str]) -> str:
    for begin, name in named.items():
        if title.startswith(begin):
            return name + title.removeprefix(begin)
    return title


def field_rows(scene: Scene) -> Iterator[FieldRow]:
    """Yield a row for each field that has a value."""
    return _rows(scene, "", "", scene)


def _rows(part: Part, path: str, title: str, scene: Scene) -> Iterator[FieldRow]:
    if isinstance(part, Element):
        part = part.lit(scene.source.wavelength)
    for field in part.fields():
        value, place = getattr(part, field.name), f"{path}{field.name}"
        called = f"{title}{field.in_window.title}"
        if isinstance(value, Part):
            yield from _rows(value, f"{place}.", f"{called} · ", scene)
        elif field.listed:
            for number, each in enumerate(value):
                where = f"{place}[{number}].", f"{called} {number + 1} · "
                yield from _rows(each, *where, scene)
        elif field.members:
            for member, each in zip(field.members, value, strict=True):
                where = f"{path}{member.name}.", f"{title}{member.title} · "
                yield from _rows(each, *where, scene)
        elif value is not None and place not in _FILE:
            yield FieldRow(place, called, field_words(part, field, scene))


def field_words(part: Part, field: FieldDescription, scene: Scene) -> str:
    """Value of a field as forms show it, with its unit and remark; empty for no values."""
    if len(field.choices) == 1:  # which states the kind of the part
        return title_of(type(part))
    text = _text(getattr(part, field.name), field)
    if not text:
        return ""
    remark = part.remarks().get(field.name)
    text = f"{text} {field.measure.words_in(scene.unit)}".rstrip()
    return f"{text} ({remark})" if remark else text


def _text(value: Any, field: FieldDescription) -> str:
    if isinstance(value, tuple):
        if value and isinstance(value[0], tuple):  # places
            return "; ".join(", ".join(_text(each, field) for each in place) for place in value)
        between = ", " if field.several or field.between == "," else f" {field.between} "
        return between.join(_text(each, field) for each in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{field.times * value:.10g}"
    return dict(field.choices).get(str(value), str(value))


class Difference(NamedTuple):
    """A field whose values in two scenes differ; a dash stands for a missing value."""

    title: str
    values: tuple[str, str]


def differences(one: Scene, other: Scene) -> tuple[Difference, ...]:
    """Return the fields in which two scenes differ, lengths in the unit of the first.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.scene import read_scene
    >>> scene = read_scene(path("examples", "tophat.json"))
    >>> other = scene.with_receiver(scene.receiver.moved_to(6.0))
    >>> differences(scene, other)
    (Difference(title='Images 1 · Receiver · Position', values=('0, 0, 5 cm', '0, 0, 6 cm')),)
    """
    found = [
        {row.path: row for row in field_rows(scene)} for scene in (one, other.in_unit(one.unit))
    ]
    if other.unit != one.unit:
        found[1]["unit"] = found[1]["unit"]._replace(value=other.unit)
    differ = []
    for path in found[0] | found[1]:
        first, second = (rows.get(path) for rows in found)
        before, after = (row.value if row else _NONE for row in (first, second))
        if before != after:
            title = (first or found[1][path]).title
            differ.append(Difference(title, (before, after)))
    return tuple(differ)
