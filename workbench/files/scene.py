"""Scene files: JSON text in UTF-8."""

import os
from pathlib import Path

from workbench.errors import Refused
from workbench.files.atomic import replacing
from workbench.files.json_text import check_fields_once
from workbench.reading import opened
from workbench.scene import Scene

LARGEST_TEXT = 1 << 20
"""Most bytes of JSON that are read."""


def read_scene(path: Path) -> Scene:
    """Read a scene file.

    Parameters
    ----------
    path : Path
        Scene file.

    Returns
    -------
    Scene
        With an absolute ``target.image``.

    Raises
    ------
    Refused
        If the file cannot be read or its scene is not possible.
    """
    with opened(path) as file:
        content = file.read(LARGEST_TEXT + 1)
    if len(content) > LARGEST_TEXT:
        raise Refused(str(path), f"is no scene: it has more than {LARGEST_TEXT} bytes")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise Refused(str(path), "is neither a session nor a scene in UTF-8 text") from error
    try:
        scene = Scene.from_json(text)
        check_fields_once(text)
    except Refused as refused:
        if refused.path == "scene":  # no field of it, but all
            raise Refused(str(path), refused.reason) from None
        raise
    return with_absolute_image(scene, path)


def write_scene(scene: Scene, path: Path) -> None:
    """Write a scene file; ``target.image`` becomes relative where it lies below its folder.

    Raises
    ------
    Refused
        If it cannot be written; what was at ``path`` before is still there.
    """
    text = with_portable_image(scene, path).to_json()
    with replacing(path) as file:
        file.write(text.encode())


def with_absolute_image(scene: Scene, path: Path) -> Scene:
    """The scene of a file, with an image that is found from every folder."""
    if scene.image is None:
        return scene
    # Not resolve(): a link stays a link, so that scene and image still lie side by side.
    return _with_image(scene, os.path.abspath(path.parent / scene.image))


def with_portable_image(scene: Scene, path: Path) -> Scene:
    """The scene for a file, with an image that is found beside it wherever both are moved to."""
    if scene.image is None:
        return scene
    image, folder = Path(scene.image), Path(os.path.abspath(path.parent))
    name = image.relative_to(folder).as_posix() if image.is_relative_to(folder) else str(image)
    try:
        name.encode()
    except UnicodeEncodeError as error:
        raise Refused("target.image", f"{name!r} is no text and cannot be kept in one") from error
    return _with_image(scene, name)


def _with_image(scene: Scene, image: str) -> Scene:
    target = scene.target.model_copy(update={"image": image})
    return scene.model_copy(update={"target": target})
