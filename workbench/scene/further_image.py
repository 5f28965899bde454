"""Another image that the same light shall make elsewhere."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, NamedTuple, Self

import numpy as np
from pydantic import ConfigDict, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.said import Said
from workbench.scene.far_field import FarField
from workbench.scene.fields import about
from workbench.scene.kinds import only
from workbench.scene.part import Part, Positive
from workbench.scene.receiver import AnyReceiver
from workbench.scene.screen import Screen
from workbench.scene.target import Target
from workbench.scene.viewing import drawing

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_MOST = 8  # each is traced by itself


@dataclass(frozen=True, eq=False)
class DrawnTarget:
    """A target as it was drawn; one that has yet to be drawn is like any.

    Attributes
    ----------
    light : ndarray, shape (n_y, n_x), optional
        The wanted image in any scale, row 0 at +y.
    picture : bytes, optional
        Content of its image file.
    remarks : tuple of str
        What a person should know of that file.
    """

    light: Array | None = None
    picture: bytes | None = None
    remarks: tuple[str, ...] = ()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, DrawnTarget):
            return NotImplemented
        if self.light is None or other.light is None or self.light is other.light:
            return True
        return np.array_equal(self.light, other.light)


class WantedImage(NamedTuple):
    """One of the images that a task asks for.

    Attributes
    ----------
    scene : Scene
        The task as if there were no other image.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.
    weight : float
        What the square of its error counts for.
    """

    scene: "Scene"
    target: Array
    weight: float


class FurtherImage(Part):
    """A receiver of its own with a target of its own. It takes no light from the other images."""

    model_config = ConfigDict(
        title="Further image",
        json_schema_extra={"oneOf": [{"required": ["screen"]}, {"required": ["far_field"]}]},
    )

    screen: Annotated[
        Screen | None, about("Screen", "Where light is wanted as well, at another place.")
    ] = None
    far_field: Annotated[
        FarField | None,
        about("Far field", "Directions in which light is wanted as well, in place of a screen."),
    ] = None
    target: Annotated[Target, about("Target", "The image that the light shall draw there.")]
    weight: Annotated[
        Positive,
        about(
            "Weight",
            "What the square of this image's relative error counts for in a design, beside 1 for "
            "the first image.",
            le=1e6,
        ),
    ] = 1.0
    _drawn: DrawnTarget = PrivateAttr(default_factory=DrawnTarget)

    @property
    def receiver(self) -> AnyReceiver:
        """Where the light is wanted: the screen or the far field."""
        return only({"screen": self.screen, "far_field": self.far_field})

    @property
    def wanted(self) -> Array:
        """The target as it was drawn, shape (n_y, n_x).

        Raises
        ------
        Refused
            If that has yet to be done; see `workbench.design.task.begin`.
        """
        if self._drawn.light is None:
            raise Refused("target", "has yet to be drawn; workbench.begin draws it")
        return self._drawn.light

    @property
    def drawn(self) -> DrawnTarget:
        """Its target as it was drawn, if it was."""
        return self._drawn

    def drawn_as(self, drawn: DrawnTarget) -> Self:
        """The same with its target drawn."""
        copy = self.model_copy()
        copy._drawn = drawn
        return copy


def images_like(scene: "Scene", other: "Scene") -> tuple[FurtherImage, ...]:
    """Further images of a scene with their targets as another scene has them.

    Drawn, or at least with the content of their files.
    """
    known = {drawing(alone): image for alone, image in _drawn(other)}
    found = []
    for alone, image in zip(scene.single[1:], scene.further_images, strict=True):
        if image.drawn.light is None:
            same = known.get(drawing(alone))
            file = image.target.file
            pictures = (
                each.drawn.picture
                for each in other.further_images
                if file and each.target.file == file
            )
            drawn = same.drawn if same else DrawnTarget(picture=next(pictures, None))
            image = image.drawn_as(drawn)
        found.append(image)
    return tuple(found)


def _drawn(scene: "Scene") -> Iterator[tuple["Scene", FurtherImage]]:
    """Further images whose target is drawn, with the scene of each."""
    for alone, image in zip(scene.single[1:], scene.further_images, strict=True):
        if image.drawn.light is not None:
            yield alone, image


def check_images(scene: "Scene") -> None:
    """Refuse further images that the optic cannot light, or too many.

    Raises
    ------
    Refused
        With the path of the field in the scene.
    """
    images, optic = scene.further_images, scene.optic
    if len(images) > _MOST:
        many = Said("{count} are given; at most {most}", count=len(images), most=_MOST)
        raise Refused("further_images", many)
    for number, image in enumerate(images):
        with refused_within(f"further_images[{number}]"):
            image.receiver.check_lengths(optic.half_width)
            image.receiver.check_lit_by(optic)


def wanted_images(scene: "Scene", target: Array) -> tuple[WantedImage, ...]:
    """All images that a scene asks for, the first one first; see `Scene.images`."""
    first, *others = scene.single
    found = [WantedImage(first, target, 1.0)]
    for number, (alone, image) in enumerate(zip(others, scene.further_images, strict=True)):
        with refused_within(f"further_images[{number}]"):
            found.append(WantedImage(alone, image.wanted, image.weight))
    return tuple(found)
