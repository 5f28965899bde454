"""What all receivers have in common, and regions whose light is stated by itself."""

import math
from abc import abstractmethod
from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.messages import Message
from workbench.scene.fields import PLACE, Measure, about
from workbench.scene.part import Kinds, Part

if TYPE_CHECKING:
    from workbench.scene.element import Element

PixelCount = Annotated[int, Field(ge=1, le=4096)]

Pixels = Annotated[
    tuple[PixelCount, PixelCount],
    about(
        "Pixels",
        "Pixels along x and y in which the light is counted and compared with the target.",
    ),
]


class AnyReceiver(Part):
    """What each kind of receiver says of itself, so that nobody has to ask for its kind.

    Its coordinates (u, v) go to the right and up as one looks from it back at the lens.
    """

    measure: ClassVar[Measure]
    """Of its coordinates."""
    axes: ClassVar[tuple[str, str]]
    """Names of its coordinates."""
    called: ClassVar[str]
    """What it is called within a sentence."""
    place: ClassVar[str]
    """Where light is that it gets, within a sentence."""
    density: ClassVar[str]
    """What the flux per measure of a pixel is called."""
    at_distance: ClassVar[bool]
    """Whether it stands somewhere along the axis, and could stand elsewhere."""
    facets: ClassVar[int]
    """Flat pieces along each side that it is drawn with."""

    extent: ClassVar[str]
    """Name of the field that holds its half-extent."""

    if TYPE_CHECKING:  # each kind has this field, at its place in the file
        pixels: Pixels

    @property
    def turn(self) -> Array | None:
        """Unit vectors (3, 3) of the coordinates in which it is described, as columns.

        None for those of the scene, as in every file; see `FarField.seen`.
        """
        return None

    @property
    @abstractmethod
    def stands_at(self) -> Array | None:
        """Where its middle stands in the scene, shape (3,); None of one at no distance."""

    @property
    def sides(self) -> Array:
        """Unit vectors along its x and y, and its own +z, in the scene, as rows (3, 3)."""
        return np.eye(3)

    @property
    def across(self) -> Array:
        """The unit vector (3,) of its own +z in the scene."""
        return np.asarray(self.sides[2])

    @property
    def upright(self) -> bool:
        """Whether its rows and columns are those of the scene."""
        return True

    @abstractmethod
    def seen(self, place: Array | None, turn: Array, magnification: float) -> Self:
        """Return the same receiver in other coordinates, or an image of it.

        `place` (3,): where its middle is there; None as in `stands_at`; `turn` (3, 3): its unit
        vectors there as columns, of one at no distance the last of them goes with the light;
        `magnification`: how many times as large it is.
        """

    @property
    @abstractmethod
    def half_extent(self) -> tuple[float, float]:
        """Half of what it covers along u and v."""

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle (u, v)."""
        return 0.0, 0.0

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of what it covers, in its coordinates."""
        (u, v), (r_u, r_v) = self.middle, self.half_extent
        return u - r_u, u + r_u, v - r_v, v + r_v

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether it is its own mirror image in x, in y."""
        return self.middle[0] == 0, self.middle[1] == 0

    @property
    @abstractmethod
    def pixel_measure(self) -> float | Array:
        """What a pixel covers, by which its flux becomes a density: one number, or (n_y, 1)."""

    def relative_measure(self, margin: int = 0) -> float | Array:
        """What a pixel covers over the mean of all, also in so many rows beyond on each side."""
        return 1.0

    @property
    def farthest(self) -> tuple[float, float]:
        """How far from its middle along u and v there may be light."""
        return math.inf, math.inf

    @property
    @abstractmethod
    def plane_z(self) -> float:
        """Where its middle stands along the axis, scene units.

        Raises `Refused` if it is at no distance.
        """

    @abstractmethod
    def moved_to(self, z: float) -> Self:
        """The same with its middle elsewhere along the axis; refused as for `plane_z`."""

    @abstractmethod
    def towards(
        self, optic: "Element", place: tuple[Array, Array, Array], u: Array, v: Array
    ) -> tuple[Array, ...]:
        """Unit vectors from places (x, y, z) of an optic to places on it; three arrays."""

    def perspective(self, optic: "Element") -> Array:
        """What takes (u, v, 1) to a multiple of (x, y, 1) as an optic sees it, shape (3, 3).

        On a plane across the axis, in any scale; for one that does not lean its own coordinates.
        """
        return np.eye(3)

    def slant(self, optic: "Element") -> float:
        """The largest angle between light of an optic and what is across the receiver, degrees."""
        return 0.0

    @abstractmethod
    def drawn(self, optic: "Element", u: Array, v: Array) -> Array:
        """Where places on it are drawn in the scene, shape (..., 3); u and v broadcast."""

    def outline(self, optic: "Element", fraction: float = 1.0) -> Array:
        """Corners of its facets as it is drawn, shape (m, m, 3), u along the first axis.

        `optic`: what lights it; `fraction`: of its extents, about its middle.
        """
        steps = fraction * np.linspace(-1, 1, self.facets + 1)
        (u, v), (r_u, r_v) = self.middle, self.half_extent
        return self.drawn(optic, u + r_u * steps[:, None], v + r_v * steps)

    @abstractmethod
    def nearest_to(self, optic: "Element") -> float:
        """The z at which it comes closest to an optic that lights it, scene units."""

    @abstractmethod
    def per_radian(self, z: float) -> tuple[float, float]:
        """How far in u and v light moves that is turned by a radian at a place z on the axis.

        For small angles about the direction of its middle.
        """

    def lean(self, z: float) -> tuple[float, float]:
        """How much of the way from a place z on the axis to its middle is along u and v."""
        return 0.0, 0.0

    def check_receiver(self) -> None:
        """Refuse values that do not go together.

        Raises `Refused` with the path of the field from the receiver, the value and what is
        allowed.
        """

    def check_lengths(self, half_width: tuple[float, float]) -> None:
        """Refuse lengths that are too long beside a lens with these half-widths."""

    @abstractmethod
    def check_lit_by(self, optic: "Element") -> None:
        """Refuse an optic that cannot light it.

        Raises `Refused` with the path of the field, the value and what is allowed.
        """

    def grown(self, margin: tuple[int, int]) -> Self:
        """The same with so many more of its pixels on each side along x and y."""
        half, pixels = zip(
            *(
                (r * (n + 2 * m) / n, n + 2 * m)
                for r, n, m in zip(self.half_extent, self.pixels, margin, strict=True)
            ),
            strict=True,
        )
        return self.model_copy(update={self.extent: half, "pixels": pixels})

    def to_pixels(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Continuous image coordinates (column, row) of places on the receiver.

        Pixel (row i, column j) covers [j, j+1) × [i, i+1). Row 0 is at +v and column 0 at −u.
        This is the one place where v turns into rows.

        `u`, `v`: place on the receiver, in its own coordinates.
        """
        (r_u, r_v), (n_x, n_y), (mid_u, mid_v) = self.half_extent, self.pixels, self.middle
        u, v = u - mid_u, v - mid_v
        return (u + r_u) * (n_x / (2 * r_u)), (r_v - v) * (n_y / (2 * r_v))

    def from_pixels(self, column: Any, row: Any) -> tuple[Any, Any]:
        """Places on the receiver of continuous image coordinates; the inverse of `to_pixels`."""
        (r_u, r_v), (n_x, n_y), (mid_u, mid_v) = self.half_extent, self.pixels, self.middle
        return mid_u - r_u + column * (2 * r_u / n_x), mid_v + r_v - row * (2 * r_v / n_y)

    def contains(self, u: Any, v: Any) -> Any:
        """Whether places in its coordinates are on it; numpy arrays or torch tensors."""
        return self.covers(*self.to_pixels(u, v))

    def covers(self, column: Any, row: Any) -> Any:
        """Whether image coordinates are on it; numpy arrays or torch tensors."""
        n_x, n_y = self.pixels
        return (column >= 0) & (column < n_x) & (row >= 0) & (row < n_y)

    def density_unit(self, unit: str) -> str:
        """Unit of a density where the source's flux is 1, in a scene with a unit of length."""
        return f"1/{unit}^2" if self.measure.power else "1/sr"

    def density_words(self, unit: str) -> str:
        """The same for people, whatever the flux of the source is."""
        return f"flux / {Measure(power=2).sign_in(unit) if self.measure.power else 'sr'}"

    def density_in_unit(self, factor: float) -> float:
        """By what a density is divided where lengths are multiplied by a factor."""
        return factor ** (2 * self.measure.power)

    def total(self, density: Array) -> float:
        """Flux of an image (n_y, n_x) of densities, one after the other where there are more."""
        return float((density * self.pixel_measure).sum())


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
