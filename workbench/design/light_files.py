"""The files of a scene's sources, kept with a design as the picture of its target is."""

from pathlib import Path

from workbench.design.picture import LARGEST_PICTURE, content_of
from workbench.measured.lamps import check_file
from workbench.scene import Scene
from workbench.scene.stages import refused_in_stage


def with_light(scene: Scene, folder: Path) -> Scene:
    """The scene with what its sources' files hold, those that are not too large to be kept.

    `scene`: its sources are used. What they carry already stays; `folder`: where relative names
    start. Raises `Refused` if a file cannot be read or used.
    """
    missing = [name for name, data in scene.light_files.items() if data is None]
    if missing:
        scene = scene.carrying({name: content_of(folder / name) for name in missing})
    stages = len(scene.run.stages)
    for number in range(stages + 1):
        with refused_in_stage(number, stages, scene):
            check_file(scene.source_of(number))
    return scene


def why_light_is_not_kept(scene: Scene) -> str:
    """A sentence for people whose design cannot keep a file of light; empty where it does."""
    for name, data in scene.light_files.items():
        if data is None:
            return (
                f"The design does not keep {name}, which has more than "
                f"{LARGEST_PICTURE >> 20} MB: the file is needed wherever the design is used."
            )
    return ""
