"""Regions of a receiver whose light is told by itself: a desk, a lane, the middle of a spot."""

from abc import abstractmethod
from collections.abc import Sequence
from itertools import combinations
from typing import Annotated, Literal

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.messages import Message
from workbench.scene.fields import PLACE, Measure, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part

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
        about("Name", "What figures of the region are called.", min_length=1, max_length=40),
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
