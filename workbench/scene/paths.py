"""Values of a scene by their paths: ``run.seed``, ``images[0].target.image``.

A path may name an element in place of its index, and a face of a lens by its side:
``lens.thickness`` is ``elements[0].thickness`` if the first element is named "lens", and
``lens.back.degree`` is ``elements[0].faces[1].degree``. A field of the scene comes before an
element of the same name.
"""

import copy
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.fields import AUTO
from workbench.scene.part import Part
from workbench.scene.task import Scene

Step = str | int
_STEP = re.compile(r"([A-Za-z0-9_-]+)|\[(\d+)\]")
_PATH = re.compile(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+|\[\d+\])*")
_SIDES = {"front": 0, "back": 1}


def is_path(text: str) -> bool:
    """Return whether a text is a path, whatever fields there are."""
    return _PATH.fullmatch(text) is not None


def steps_of(whole: object, path: str) -> tuple[Step, ...]:
    """Return the names and indices along a path.

    `whole`: where the path begins. In a scene, elements and faces may be named. Raises `Refused` if
    the text is no path.
    """
    steps = _steps(path)
    return tuple(_indexed(whole, steps)) if isinstance(whole, Scene) else steps


@lru_cache(maxsize=4096)  # a form asks for the same few hundred at every edit
def _steps(path: str) -> tuple[Step, ...]:
    if not is_path(path):
        raise Refused(path, Message("no path of a field; a path as in lens.thickness is needed"))
    return tuple(int(found[2]) if found[2] else found[1] for found in _STEP.finditer(path))


def value_at(whole: object, path: str) -> Any:
    """Return the value at a path of a scene, of another part or of plain data.

    None if there is no such field.

    Examples
    --------
    >>> scene = Scene.from_data({
    ...     "version": 3,
    ...     "source": {"kind": "collimated"},
    ...     "elements": [{
    ...         "kind": "lens", "name": "plate", "half_width": [1, 1], "material": "PMMA",
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 5], "half_width": [1, 1],
    ...             "pixels": [128, 128],
    ...         },
    ...         "target": {"builtin": "tophat"},
    ...     }],
    ... })
    >>> value_at(scene, "plate.thickness"), value_at(scene, "plate.back.degree[0]")
    (0.5, 3)
    """
    value = whole
    for step in steps_of(whole, path):
        value = _child(value, step)
    return value


def with_values(scene: Scene, changes: Mapping[str, Any]) -> Scene:
    """Return a scene with other values, read and checked as a whole.

    Defaults of fields that the scene does not set follow the new values.

    `changes`: values by path, as a scene file has them. A single number for a field that is a list
    of numbers stands for each of them. Raises `Refused` if there is no such field, two paths are of
    one field, or the scene is not possible.
    """
    data = scene.model_dump(mode="json", exclude_unset=True, exclude_none=True)
    full = scene.settled().to_data()
    changed: set[tuple[Step, ...]] = set()
    for path, value in changes.items():
        steps = steps_of(scene, path)
        if steps in changed:
            raise Refused(path, Message("given twice; one value for each field"))
        changed.add(steps)
        _put(data, full, path, steps, value)
    return Scene.from_data(data).with_contents_of(scene)


def _indexed(scene: Scene, steps: tuple[Step, ...]) -> Iterator[Step]:
    """Steps with indices in place of the names of elements and sides."""
    first, *others = steps
    if first not in Scene.model_fields:
        names = [element.name for element in scene.elements]
        if first not in names:
            raise Refused(
                str(first),
                Message(
                    "no field and no element of this scene; fields: {fields}; elements: {names}",
                    fields=", ".join(sorted(Scene.model_fields)),
                    names=", ".join(names),
                ),
            )
        first, others = "elements", [names.index(str(first)), *others]
    yield first
    if first == "elements" and len(others) > 1:
        number, side, *others = others
        faced = isinstance(number, int) and number < len(scene.elements)
        if side in _SIDES and faced and "faces" in type(scene.elements[int(number)]).model_fields:
            others = ["faces", _SIDES[str(side)], *others]
        else:
            others = [side, *others]
        yield number
    yield from others


def _put(data: Any, full: Any, path: str, steps: tuple[Step, ...], value: Any) -> None:
    """Change a field in ``data``, taking over from ``full`` what it leaves to defaults."""
    *parents, last = steps
    for step in parents:
        full = _child(full, step)
        if isinstance(data, dict) and step not in data:
            # Objects fill up with their defaults; of a list all is needed.
            data[str(step)] = copy.deepcopy(full) if isinstance(full, list) else {}
        data = _child(data, step)
    if isinstance(last, int) != isinstance(data, list) or not isinstance(data, list | dict):
        raise Refused(path, Message("unknown field; there is no such part of the scene"))
    if isinstance(last, int) and last >= len(data):
        raise Refused(
            path,
            Message(
                "there are only {count} of them; 0 to {last}", count=len(data), last=len(data) - 1
            )
            if data
            else Message("there is none of them"),
        )
    before = _child(full, last)
    listed = list(value) if isinstance(value, tuple) else value
    if isinstance(value, int | float) and not isinstance(value, bool):
        if isinstance(before, list):
            listed = [value] * len(before)
        elif before == AUTO:  # a net that is not chosen yet: numbers along x and y
            listed = [value] * 2
    data[last] = listed  # type: ignore[index]  # a list has an index here


def _child(whole: Any, step: Step) -> Any:
    """Return what is at a step; None where there is nothing."""
    if isinstance(whole, Part):
        return vars(whole).get(str(step))  # its fields, and nothing else
    try:
        return whole[step]
    except (KeyError, IndexError, TypeError):
        return None
