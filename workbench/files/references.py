"""Files that a file refers to, and names of the same file."""

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
    """Fields and files of a scene file, or of a session with its kept runs; may raise Refused."""
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
    """Whether two names are the same existing file, also by a link or in another case."""
    try:
        return path.samefile(other)
    except OSError:  # one of them does not exist
        return False


def named_twice(paths: Iterable[Path]) -> Path | None:
    """Return the first path that is the same file as an earlier one; else None."""
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
    """Test the file system's case sensitivity with similar names; True if impossible."""
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
