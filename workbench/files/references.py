"""What a file refers to, and whether two names mean one file."""

import os
import unicodedata
import uuid
from collections.abc import Iterable
from pathlib import Path

from workbench.files.entries import Entries
from workbench.files.header import read_header, read_part
from workbench.files.scene import LARGEST_TEXT, read_scene, with_absolute_files
from workbench.files.session import HEADER, is_session
from workbench.reading import opened
from workbench.scene import Scene


def files_of(path: Path) -> tuple[tuple[str, Path], ...]:
    """Files that a scene file, or a session with the runs kept in it, refers to.

    Each with its field: ``target.image``. Raises `Refused` if the file cannot be read or its scene
    is not possible.
    """
    return tuple((field, Path(name)) for scene in _scenes(path) for field, name in scene.files())


def _scenes(path: Path) -> list[Scene]:
    if not is_session(path):
        return [read_scene(path)]
    with opened(path) as file:
        entries = Entries(path, file)
        where = entries.where(HEADER)
        header = read_header(entries.content(HEADER, LARGEST_TEXT), where)
    texts = [header.scene, *(run.scene for run in header.runs or ())]
    return [with_absolute_files(read_part(text, None, where), path) for text in texts]


def is_one_file(path: Path, other: Path) -> bool:
    """Whether two names mean the same existing file, be it by a link or by another case."""
    try:
        return path.samefile(other)
    except OSError:  # one of them is not there, or hidden: it cannot be the other
        return False


def named_twice(paths: Iterable[Path]) -> Path | None:
    """The first of some files that an earlier name means as well.

    Of names that differ in case alone, the file system says whether they are one.
    """
    earlier: list[Path] = []
    for path in paths:
        if any(_is_one_name(path, other) or is_one_file(path, other) for other in earlier):
            return path
        earlier.append(path)
    return None


def _is_one_name(path: Path, other: Path) -> bool:
    path, other = Path(os.path.realpath(path)), Path(os.path.realpath(other))
    if path == other:
        return True
    if path.parent != other.parent or _plain(path.name) != _plain(other.name):
        return False
    return not (path.exists() or other.exists()) and _would_be_one(path, other)


def _plain(name: str) -> str:
    return unicodedata.normalize("NFC", name).casefold()


def _would_be_one(path: Path, other: Path) -> bool:
    """Try with names like these; where that is not possible they count as one."""
    mark = f".{uuid.uuid4().hex}"
    tried = path.with_name(path.name + mark)
    try:
        tried.touch(exist_ok=False)
        try:
            return other.with_name(other.name + mark).exists()
        finally:
            tried.unlink()
    except OSError:
        return True
