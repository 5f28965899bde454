"""Images: where light is wanted, and which light."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, NamedTuple, Self

import numpy as np
from pydantic import ConfigDict, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.scene.element import Element
from workbench.scene.far_field import FarField
from workbench.scene.fields import about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part, Positive
from workbench.scene.screen import Screen
from workbench.scene.target import Target
from workbench.scene.viewing import drawing

if TYPE_CHECKING:
    from workbench.scene.task import Scene

MOST_IMAGES = 9
"""Images of a scene, at most: each is traced by itself."""
Receiver = Annotated[Screen | FarField, Kinds("kind")]


@dataclass(frozen=True, eq=False)
class DrawnTarget:
    """A target as an array; equal to any where it has yet to be drawn."""

    light: Array | None = None  # (n_y, n_x), the wanted image in any scale, row 0 at +y
    picture: bytes | None = None  # content of its image file
    remarks: tuple[str, ...] = ()  # what a person should know of that file

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, DrawnTarget):
            return NotImplemented
        if self.light is None or other.light is None or self.light is other.light:
            return True
        return np.array_equal(self.light, other.light)


class WantedImage(NamedTuple):
    """One of the images of a task."""

    scene: "Scene"  # the task as if there were no other image
    target: Array  # (n_y, n_x), the wanted image in any scale, row 0 at +y
    weight: float  # factor of the square of its error


class Image(Part):
    """A receiver with the light that is wanted on it. It takes no light from other images."""

    model_config = ConfigDict(title="Image")

    receiver: Annotated[
        Receiver, about("Receiver", "Where the light is wanted: on a plane or in directions.")
    ]
    target: Annotated[Target, about("Target", "The image that the light shall draw there.")]
    weight: Annotated[
        Positive,
        about(
            "Weight",
            "Factor of the square of this image's relative error in a design of several images.",
            le=1e6,
        ),
    ] = 1.0
    _drawn: DrawnTarget = PrivateAttr(default_factory=DrawnTarget)

    @property
    def wanted(self) -> Array:
        """The target as an array, shape (n_y, n_x).

        Raises `Refused` if it has yet to be drawn; see `workbench.design.task.begin`.
        """
        if self._drawn.light is None:
            raise Refused("target", "has yet to be drawn; workbench.begin draws it")
        return self._drawn.light

    @property
    def drawn(self) -> DrawnTarget:
        """Its target as an array, where that was drawn."""
        return self._drawn

    def drawn_as(self, drawn: DrawnTarget) -> Self:
        """Return the same with its target drawn."""
        copy = self.model_copy()
        copy._drawn = drawn
        return copy

    def check_lit_by(self, element: Element) -> None:
        """Refuse an element that cannot light the receiver.

        Raises `Refused` with the path of the field from the image.
        """
        with refused_within("receiver"):
            self.receiver.check_receiver()
            self.receiver.check_lengths(element.half_width)
            self.receiver.check_lit_by(element)


def images_like(scene: "Scene", other: "Scene") -> tuple[Image, ...]:
    """Images behind the first one with their targets as another scene has them.

    Drawn, or at least with the content of their files.
    """
    known = {drawing(alone): image for alone, image in _drawn(other)}
    found = []
    for alone, image in zip(scene.single[1:], scene.images[1:], strict=True):
        if image.drawn.light is None:
            same = known.get(drawing(alone))
            file = image.target.file
            pictures = (
                each.drawn.picture for each in other.images[1:] if file and each.target.file == file
            )
            drawn = same.drawn if same else DrawnTarget(picture=next(pictures, None))
            image = image.drawn_as(drawn)
        found.append(image)
    return tuple(found)


def _drawn(scene: "Scene") -> Iterator[tuple["Scene", Image]]:
    """Images behind the first one whose target is drawn, with the scene of each."""
    for alone, image in zip(scene.single[1:], scene.images[1:], strict=True):
        if image.drawn.light is not None:
            yield alone, image


def wanted_images(scene: "Scene", target: Array) -> tuple[WantedImage, ...]:
    """All images that a scene asks for, the first one first; see `Scene.wanted`."""
    first, *others = scene.single
    found = [WantedImage(first, target, scene.images[0].weight)]
    for number, (alone, image) in enumerate(zip(others, scene.images[1:], strict=True), start=1):
        with refused_within(f"images[{number}]"):
            found.append(WantedImage(alone, image.wanted, image.weight))
    return tuple(found)
