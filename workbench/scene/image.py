"""Images: where light is wanted, and which light, from which side it is seen, and regions of it.

Arrays of images lie as the receiver counts: row 0 at +v and column 0 at −u. On one side of the
receiver a viewer sees u to the right, and so the columns in their order; on the other side, from
the last one to the first. A target is drawn as its viewer shall see it, and laid onto the receiver
by `as_viewed`; nothing else mirrors images.
"""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple, Self

import numpy as np
from pydantic import ConfigDict, Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.messages import Message
from workbench.scene.element import Element
from workbench.scene.fields import PLACE, Measure, about
from workbench.scene.part import Kinds, Part, Positive
from workbench.scene.receivers import Receiver
from workbench.scene.target import Side, Target

if TYPE_CHECKING:
    from workbench.scene.element import Element
    from workbench.scene.task import Scene

MOST_IMAGES = 9
"""Images of a scene, at most: each is traced by itself."""


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


def pixel_side(scene: "Scene") -> Side:
    """The side of the receiver from which column 0 of its pixels is at the left."""
    return "front" if scene.onwards(scene.receiver) < 0 else "back"


def viewed_from(scene: "Scene") -> Side:
    """The side of the receiver from which the target reads right.

    Examples
    --------
    >>> from workbench.scene import Scene
    >>> scene = Scene.from_data({
    ...     "version": 3,
    ...     "source": {"kind": "collimated"},
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": "PMMA",
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 5], "half_width": [1, 1],
    ...             "pixels": [128, 128],
    ...         },
    ...         "target": {"builtin": "text", "text": "F"},
    ...     }],
    ... })
    >>> viewed_from(scene)
    'back'
    """
    return scene.target.viewed_from or pixel_side(scene)


def inverted(scene: "Scene") -> bool:
    """Whether the target's viewer sees column 0 of the receiver's pixels at the right."""
    return viewed_from(scene) != pixel_side(scene)


def as_viewed(scene: "Scene", image: Array) -> Array:
    """An image on a receiver as its viewer sees it; and the reverse, which is the same.

    `scene`: gives receiver and viewer, of its first image; `image` (n_y, n_x, ...): on the pixels
    of the receiver, or as the viewer sees it. Returns (n_y, n_x, ...).
    """
    return np.ascontiguousarray(image[:, ::-1]) if inverted(scene) else image


def side_in_words(scene: "Scene", side: Side) -> Message:
    """From where one sees, as in "viewed from behind the screen"."""
    if side == "front":
        return Message("viewed from the side of the light")
    return Message("viewed from behind the {receiver}", receiver=scene.receiver.called)


def drawing(scene: "Scene") -> tuple[object, ...]:
    """All that the array of the target depends on."""
    receiver = scene.receiver
    return scene.target, receiver.half_extent, receiver.pixels, inverted(scene)


_OF_RECEIVER = Measure("of width", "of the receiver's width and height")
_Offset = Annotated[float, Field(ge=-0.5, le=0.5)]
_Size = Annotated[float, Field(gt=0, le=1)]
_ROUNDING = 1e-9
_MOST = 32  # regions: more would be read by nobody

# So many corners of an ellipse leave 3e-6 of its area out.
_CORNERS = 1440


class AnyRegion(Part):
    """What all regions have in common. They move and grow with the receiver."""

    name: Annotated[
        str,
        about("Name", "Name of the region in its figures.", min_length=1, max_length=40),
    ] = "Region"

    @property
    @abstractmethod
    def outline(self) -> Array:
        """Corners (x, y) of a polygon from the receiver's middle, in parts of its width, height."""

    @abstractmethod
    def check_outline(self) -> None:
        """Refuse what is no region of a receiver; with the path of the field within the region."""


class _Placed(AnyRegion):
    """A region with a middle and a size."""

    center: Annotated[
        tuple[_Offset, _Offset],
        PLACE,
        _OF_RECEIVER,
        about("Middle", "Where its middle is, from that of the receiver."),
    ] = (0.0, 0.0)
    size: Annotated[
        tuple[_Size, _Size],
        _OF_RECEIVER,
        about("Size", "Its whole width and height."),
    ] = (0.5, 0.5)

    def check_outline(self) -> None:
        """Refuse a region that ends beyond the receiver."""
        for axis, (middle, size) in enumerate(zip(self.center, self.size, strict=True)):
            if abs(middle) + size / 2 > 0.5 + _ROUNDING:
                raise Refused(
                    f"size[{axis}]",
                    Message(
                        "{size:g} about {middle:g} ends beyond the receiver; at most {most:g} "
                        "there",
                        size=size,
                        middle=middle,
                        most=1 - 2 * abs(middle),
                    ),
                )


class RectangleRegion(_Placed):
    """A rectangle."""

    model_config = ConfigDict(title="Rectangle")

    shape: Literal["rectangle"] = "rectangle"

    @property
    def outline(self) -> Array:
        """Its four corners, shape (4, 2)."""
        corners = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])
        return np.asarray(self.center + corners * self.size)


class EllipseRegion(_Placed):
    """An ellipse; a circle where the receiver's aspect and its own make one."""

    model_config = ConfigDict(title="Ellipse")

    shape: Literal["ellipse"] = "ellipse"

    @property
    def outline(self) -> Array:
        """Corners of a polygon in it, shape (n, 2)."""
        angle = 2 * np.pi * np.arange(_CORNERS) / _CORNERS
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        return np.asarray(self.center + circle * self.size / 2)


class PolygonRegion(AnyRegion):
    """A polygon, whose corners are drawn on an image."""

    model_config = ConfigDict(title="Polygon")

    shape: Literal["polygon"] = "polygon"
    corners: Annotated[
        tuple[tuple[_Offset, _Offset], ...],
        _OF_RECEIVER,
        about(
            "Corners",
            "In their order around it, from the receiver's middle.",
            min_length=3,
            max_length=100,
        ),
    ] = ((-0.25, -0.25), (0.25, -0.25), (0.0, 0.25))

    def check_outline(self) -> None:
        """Refuse a polygon without area, or whose sides cross."""
        sides = list(zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True))
        if abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in sides)) < _ROUNDING:
            raise Refused("corners", Message("have no area between them; a polygon with some"))
        if any(_cross(one, other) for one, other in combinations(sides, 2)):
            crossed = Message("make sides that cross; in their order around the polygon")
            raise Refused("corners", crossed)

    @property
    def outline(self) -> Array:
        """Its corners, shape (n, 2)."""
        return np.array(self.corners)


def check_regions(regions: Sequence[AnyRegion]) -> None:
    """Refuse regions of a scene that are none, or too many.

    Raises `Refused` with the path of the field in the scene.
    """
    if len(regions) > _MOST:
        many = Message("{count} are given; at most {most}", count=len(regions), most=_MOST)
        raise Refused("regions", many)
    for number, region in enumerate(regions):
        with refused_within(f"regions[{number}]"):
            region.check_outline()


_Place = tuple[float, float]


def _cross(one: tuple[_Place, _Place], other: tuple[_Place, _Place]) -> bool:
    """Whether two lines cross between their ends."""
    return _parted(*one, *other) and _parted(*other, *one)


def _parted(start: _Place, end: _Place, a: _Place, b: _Place) -> bool:
    """Whether a straight line has two places on different sides."""
    sides = [
        (end[0] - start[0]) * (p[1] - start[1]) - (end[1] - start[1]) * (p[0] - start[0])
        for p in (a, b)
    ]
    return sides[0] * sides[1] < 0


Region = Annotated[
    RectangleRegion | EllipseRegion | PolygonRegion, Kinds("shape", default="rectangle")
]
