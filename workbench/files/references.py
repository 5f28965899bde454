"""What a file refers to, and whether two names mean one file."""

import os
import unicodedata
from collections.abc import Iterable
from pathlib import Path

from workbench.files.entries import Entries
from workbench.files.header import read_header, read_part
from workbench.files.scene import LARGEST_TEXT, read_scene, with_absolute_image
from workbench.files.session import HEADER, is_session
from workbench.reading import opened
from workbench.scene import Scene


def images_of(path: Path) -> tuple[Path, ...]:
    """Image files that a scene file, or a session with the runs kept in it, refers to.

    Raises
    ------
    Refused
        If the file cannot be read or its scene is not possible.
    """
    images = (scene.image for scene in _scenes(path))
    return tuple(Path(image) for image in images if image is not None)


def _scenes(path: Path) -> list[Scene]:
    if not is_session(path):
        return [read_scene(path)]
    with opened(path) as file:
        entries = Entries(path, file)
        where = entries.where(HEADER)
        header = read_header(entries.content(HEADER, LARGEST_TEXT), where)
    texts = [header.scene, *(run.scene for run in header.runs or ())]
    return [with_absolute_image(read_part(text, where), path) for text in texts]


def is_one_file(path: Path, other: Path) -> bool:
    """Whether two names mean the same existing file, be it by a link or by another case."""
    try:
        return path.samefile(other)
    except OSError:  # one of them is not there, or hidden: it cannot be the other
        return False


def named_twice(paths: Iterable[Path]) -> Path | None:
    """The first of some files that an earlier name means as well.

    Names that differ in case alone count as one: on many file systems they are.
    """
    earlier: list[Path] = []
    for path in paths:
        if any(_is_one_name(path, other) or is_one_file(path, other) for other in earlier):
            return path
        earlier.append(path)
    return None


def _is_one_name(path: Path, other: Path) -> bool:
    return _plain(path) == _plain(other)


def _plain(path: Path) -> tuple[str, str]:
    """Folder without links, and a name without case."""
    folder, name = os.path.split(os.path.realpath(path))
    return folder, unicodedata.normalize("NFC", name).casefold()
