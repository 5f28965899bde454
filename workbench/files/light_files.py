"""Files of a scene's sources as entries of a session: any program can open them there."""

import re
from collections.abc import Mapping
from pathlib import PurePath

from workbench.design.picture import LARGEST_PICTURE
from workbench.files.entries import Entries
from workbench.scene import Scene

_ENDING = re.compile(r"\.[a-z0-9]{1,8}")


def light_entries(folder: str, scene: Scene, kept: Mapping[str, bytes | None]) -> dict[str, bytes]:
    """What to write for a design, by names of entries; what is ``kept`` already is left out."""
    files = scene.light_files
    names = _entry_names(folder, scene)
    return {
        names[file]: data
        for file, data in files.items()
        if data is not None and kept.get(file) != data
    }


def names_of_light(entries: Entries, folder: str, scene: Scene) -> set[str]:
    """Those of a design's entries of light that are there."""
    return {name for name in _entry_names(folder, scene).values() if name in entries}


def with_kept_light(
    entries: Entries, folder: str, scene: Scene, kept: Mapping[str, bytes | None]
) -> Scene:
    """The scene of a design with what its sources' files held when it was written.

    `folder`: what the names of the design's entries begin with; `scene`: its scene; `kept`: what is
    kept in other entries, by names of files.
    """
    found = dict(kept)
    for file, name in _entry_names(folder, scene).items():
        if name in entries:
            found[file] = entries.content(name, LARGEST_PICTURE)
    return scene.carrying(found)


def _entry_names(folder: str, scene: Scene) -> dict[str, str]:
    return {
        file: f"{folder}light_{number}{_ending(file)}"
        for number, file in enumerate(scene.light_files)
    }


def _ending(file: str) -> str:
    ending = PurePath(file).suffix.lower()
    return ending if _ENDING.fullmatch(ending) else ""
