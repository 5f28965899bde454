"""The targets of a scene's further images, drawn as the first one is."""

from pathlib import Path

from workbench.design.picture import picture_of
from workbench.errors import refused_within
from workbench.scene import DrawnTarget, Scene


def with_targets(scene: Scene, folder: Path) -> Scene:
    """The scene with the targets of its further images drawn, those that have yet to be.

    `scene`: what it carries along of an image file counts, rather than the file; `folder`: where a
    relative image path starts. Raises `Refused` if a target cannot be drawn.
    """
    if len(scene.images) == 1:
        return scene
    from workbench.targets import draw_target  # late: scipy.ndimage takes long to import

    images = [scene.images[0]]
    for number, (alone, image) in enumerate(
        zip(scene.single[1:], scene.images[1:], strict=True), start=1
    ):
        if image.drawn.light is None:
            picture = image.drawn.picture or picture_of(alone, folder)
            with refused_within(f"images[{number}]"):
                drawn = draw_target(alone, folder, picture)
            image = image.drawn_as(DrawnTarget(drawn.light, picture, drawn.remarks))
        images.append(image)
    return scene.with_images(images)


def without_targets(scene: Scene) -> Scene:
    """The scene with the targets of its further images yet to be drawn, from their files."""
    images = (image.drawn_as(DrawnTarget()) for image in scene.images[1:])
    return scene.with_images((scene.images[0], *images))
