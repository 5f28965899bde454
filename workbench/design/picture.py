"""The picture of a target, kept with a design so that it can be drawn anew without its file."""

from pathlib import Path

from workbench.errors import Refused
from workbench.reading import opened
from workbench.scene import Scene

LARGEST_PICTURE = 16 << 20
"""Most bytes of an image file that a design keeps."""


def picture_of(scene: Scene, folder: Path) -> bytes | None:
    """The content of the target's image file.

    `scene`: its target is used; `folder`: where a relative image path starts. Returns None for a
    built-in shape, and for a file that cannot be read or is larger than `LARGEST_PICTURE`.
    """
    return None if scene.image is None else content_of(folder / scene.image)


def content_of(path: Path) -> bytes | None:
    """The content of a file; None if it cannot be read or is larger than `LARGEST_PICTURE`."""
    try:
        with opened(path) as file:
            content = file.read(LARGEST_PICTURE + 1)
    except Refused:  # whoever needs it says so
        return None
    return content if len(content) <= LARGEST_PICTURE else None


def why_not_kept(scene: Scene, picture: bytes | None) -> str:
    """A sentence for people whose design cannot keep its picture; empty where it does."""
    if picture is not None or scene.image is None:
        return ""
    return (
        f"The design does not keep {scene.image}, which has more than "
        f"{LARGEST_PICTURE >> 20} MB: the file is needed to draw the target anew."
    )


def changed_on_disk(scene: Scene, picture: bytes | None) -> bool:
    """Whether the file of a kept picture holds something else now; not where it is gone."""
    if picture is None or scene.image is None:
        return False
    try:
        with opened(Path(scene.image)) as file:
            return file.read(LARGEST_PICTURE + 1) != picture
    except Refused:
        return False
