"""What all receivers have in common: pixels in flat coordinates of their own."""

import math
from abc import abstractmethod
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene.fields import Measure, about
from workbench.scene.part import Part

if TYPE_CHECKING:
    from workbench.scene.element import Element

PixelCount = Annotated[int, Field(ge=1, le=4096)]

Pixels = Annotated[
    tuple[PixelCount, PixelCount],
    EXPERT,
    about(
        "Pixels",
        "Pixels along x and y in which the light is counted and compared with the target.",
    ),
]


class AnyReceiver(Part):
    """What each kind of receiver says of itself, so that nobody has to ask for its kind.

    Its coordinates (u, v) go to the right and up as one looks from it back at the lens.
    """

    measure: ClassVar[Measure]  # of its coordinates
    axes: ClassVar[tuple[str, str]]  # names of its coordinates
    called: ClassVar[str]  # what it is called within a sentence
    place: ClassVar[str]  # where light is that it gets, within a sentence
    density: ClassVar[str]  # what the flux per measure of a pixel is called
    at_distance: ClassVar[bool]  # whether it stands along the axis, and could stand elsewhere
    facets: ClassVar[int]  # flat pieces along each side that it is drawn with
    extent: ClassVar[str]  # name of the field that holds its half-extent

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
    def half_extent(self) -> tuple[float, float]:
        """Half of what it covers along u and v."""
        r_u, r_v = getattr(self, self.extent)
        return r_u, r_v

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
    def middle_in_scene(self) -> Array:
        """Where its middle stands in the scene, shape (3,).

        Raises `Refused` if it is at no distance.
        """
        if (place := self.stands_at) is None:
            raise Refused("receiver", Message("is at no distance; a screen is needed"))
        return place

    @property
    def plane_z(self) -> float:
        """Where its middle stands along the axis, scene units; refused as for `middle_in_scene`."""
        return float(self.middle_in_scene[2])

    def moved_to(self, z: float) -> Self:
        """The same with its middle elsewhere along the axis; refused as for `middle_in_scene`."""
        x, y, _ = self.middle_in_scene.tolist()
        return self.model_copy(update={"position": (x, y, z)})

    @abstractmethod
    def towards(
        self, optic: "Element", place: tuple[Array, Array, Array], u: Array, v: Array
    ) -> tuple[Array, ...]:
        """Unit vectors from places (x, y, z) of an element to places on it; three arrays."""

    def perspective(self, optic: "Element") -> Array:
        """What takes (u, v, 1) to a multiple of (x, y, 1) as an element sees it, shape (3, 3).

        On a plane across the axis, in any scale; for one that does not lean its own coordinates.
        """
        return np.eye(3)

    def slant(self, optic: "Element") -> float:
        """The largest angle between light of an element and the receiver's normal, degrees."""
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
        """The z at which it comes closest to an element that lights it, scene units."""

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

    def check_lit_by(self, optic: "Element") -> None:
        """Refuse an element that cannot light it.

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

    def from_middle(self, u: Array, v: Array) -> Array:
        """How far places on it are from its middle, in its coordinates; u and v broadcast."""
        mid_u, mid_v = self.middle
        return np.hypot(u - mid_u, v - mid_v)

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

    def density_in_unit(self, factor: float) -> float:
        """By what a density is divided where lengths are multiplied by a factor."""
        return factor ** (2 * self.measure.power)

    def total(self, density: Array) -> float:
        """Flux of an image (n_y, n_x) of densities, one after the other where there are more."""
        return float((density * self.pixel_measure).sum())
