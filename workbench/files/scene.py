"""Scene files: JSON text in UTF-8 without duplicate fields."""

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from workbench.errors import Refused
from workbench.files.atomic import replacing
from workbench.messages import Message
from workbench.reading import opened
from workbench.refusals import field_name
from workbench.scene import Scene

LARGEST_TEXT = 1 << 20
"""Largest JSON text, bytes."""


def read_scene(path: Path) -> Scene:
    """Read a scene file with absolute file names; raise Refused if unreadable or impossible."""
    with opened(path) as file:
        content = file.read(LARGEST_TEXT + 1)
    if len(content) > LARGEST_TEXT:
        raise Refused(
            str(path), Message("is no scene: it has more than {most} bytes", most=LARGEST_TEXT)
        )
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise Refused(
            str(path), Message("is neither a session nor a scene in UTF-8 text")
        ) from error
    try:
        scene = Scene.from_json(text)
        check_fields_once(text)
    except Refused as refused:
        if refused.path == "scene":  # not a single field
            raise Refused(str(path), refused.reason) from None
        raise
    return with_absolute_files(scene, path)


def write_scene(scene: Scene, path: Path) -> None:
    """Write a scene file, with relative names of files below its folder."""
    text = with_portable_files(scene, path).to_json()
    with replacing(path) as file:
        file.write(text.encode())


def with_absolute_files(scene: Scene, path: Path) -> Scene:
    """Return the scene of a file with absolute file names.

    If the scene file is a link, the folder of the link comes first, then that of its target. A
    backslash may separate folders, as in scenes of Windows.
    """
    return scene.with_files({field: _absolute(name, path) for field, name in scene.files()})


def _absolute(name: str, path: Path) -> str:
    # The folder of the link is not resolved, so that scene and image stay in one folder.
    folders = path.parent, Path(os.path.realpath(path)).parent
    names = name, name.replace("\\", "/")
    tried = [os.path.abspath(folder / each) for each in names for folder in folders]
    return next(filter(os.path.exists, tried), tried[0])


def with_portable_files(scene: Scene, path: Path) -> Scene:
    """Return the scene for a file, with relative names of files below its folder."""
    folder = Path(os.path.abspath(path.parent))
    return scene.with_files(
        {field: _portable(field, Path(name), folder) for field, name in scene.files()}
    )


def _portable(field: str, file: Path, folder: Path) -> str:
    name = file.relative_to(folder).as_posix() if file.is_relative_to(folder) else str(file)
    try:
        name.encode()
    except UnicodeEncodeError as error:
        raise Refused(
            field, Message("{name!r} is no text and cannot be kept in one", name=name)
        ) from error
    return name


class _Fields(list[tuple[str, Any]]):
    """Fields of an object in order, with duplicates."""


def check_fields_once(text: str | bytes, before: str = "") -> None:
    """Refuse valid JSON in which an object has a field twice: readers differ in which they use."""
    # Numbers stay text: they may have thousands of digits.
    read = json.loads(
        text, object_pairs_hook=_Fields, parse_int=str, parse_float=str, parse_constant=str
    )
    for path in _twice(read, ""):
        raise Refused(before + path, Message("is given twice; each field can be there once"))


def _twice(value: object, path: str) -> Iterator[str]:
    """Paths of duplicate fields."""
    if isinstance(value, _Fields):
        seen = set()
        for name, below in value:
            at = f"{path}.{field_name(name)}" if path else field_name(name)
            if name in seen:
                yield at
            seen.add(name)
            yield from _twice(below, at)
    elif isinstance(value, list):
        for number, below in enumerate(value):
            yield from _twice(below, f"{path}[{number}]")
