"""The fields in which two scenes differ."""

from typing import NamedTuple

from workbench.report.scene_rows import field_rows
from workbench.scene import Scene

_NONE = "–"


class Difference(NamedTuple):
    """A field that has another value, or is there in one scene alone.

    Attributes
    ----------
    title : str
        Of the field, with the parts that it is in.
    values : tuple[str, str]
        What each scene says of it; a dash for nothing.
    """

    title: str
    values: tuple[str, str]


def differences(one: Scene, other: Scene) -> tuple[Difference, ...]:
    """Fields in which scenes differ, in the order of the first one; lengths in its unit.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.scene import read_scene
    >>> scene = read_scene(path("examples", "tophat.json"))
    >>> other = scene.with_receiver(scene.receiver.moved_to(6.0))
    >>> differences(scene, other)
    (Difference(title='Screen · At z', values=('5 cm', '6 cm')),)
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
