"""Light sources before the lens: a class for each kind, and `Source`, the list of them."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict, Field

from workbench.errors import Refused
from workbench.scene import limits
from workbench.scene.emission import Emission, ExactMethod, Fresh, Intersection, Sampling
from workbench.scene.fields import LENGTH, PLACE, about
from workbench.scene.kinds import Kinds
from workbench.scene.lens import Lens
from workbench.scene.part import NonNegative, Part
from workbench.scene.screen import Screen

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Array = npt.NDArray[np.float64]

RayCount = Annotated[int, Field(ge=1, le=4096)]
PointCount = Annotated[int, Field(ge=1, le=512)]
_MOST = 1 << 24  # rays
# A new source stands this many lens half-widths before the entrance face.
_DISTANCE = 5.0
Place = tuple[float, float, float]


class AnySource(Part):
    """What each kind of source says of itself, so that nobody has to ask for its kind.

    Here it is said of light that comes from infinitely far: it has no place that could be seen.
    """

    along_axis: ClassVar[bool] = False
    """Whether all its rays go along +z."""

    @property
    def place(self) -> Place | None:
        """Its middle, scene units."""
        return None

    @property
    def ray_count(self) -> int:
        """Rays that it asks for in all, at least."""
        return 1

    @property
    def samples(self) -> tuple[int, int]:
        """As many as a grid of its rays has along x and y."""
        return math.isqrt(self.ray_count), math.isqrt(self.ray_count)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether its light is surely its own mirror image in x, in y."""
        return False, False

    @property
    def point(self) -> "PointSource | None":
        """The point that stands for it in rough plans; None if it has no place."""
        return None if self.place is None else PointSource(kind="point", position=self.place)

    @property
    def point_count(self) -> int:
        """How many points emit its light; infinitely far light counts as that of one."""
        return 1

    @property
    def redrawn(self) -> bool:
        """Whether each iteration of the paper's method has rays of its own."""
        return False

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Of each knot span, where its rays meet triangles in place of the B-spline itself."""
        return None

    @property
    def nearest_z(self) -> float:
        """Where it comes closest to the lens, scene units."""
        return -math.inf if self.place is None else self.place[2]

    def blur(self, lens: Lens, screen: Screen) -> tuple[float, float]:
        """Widths along x and y of what one place of the lens makes of it on the screen.

        Scene units, about: as behind a pinhole.
        """
        return 0.0, 0.0

    def check_before(self, lens: Lens) -> None:
        """Refuse a lens that it cannot light.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """

    def seen(self, most: tuple[int, int]) -> Array:
        """Points to draw it with, shape (n, 3): no more than ``most`` along x and y."""
        return np.zeros((0, 3)) if self.place is None else np.array([self.place])

    @property
    def corners(self) -> Array:
        """Points by which it is widened, shape (n, 3)."""
        return np.zeros((0, 3))

    def placed(self, place: Place) -> Self:
        """The same source with its middle elsewhere."""
        return self

    def shrunk(self, factor: float) -> Self:
        """The same source of another size about its middle."""
        return self

    def widened(self, corner: Array, digits: int) -> Self:
        """The same source with a corner at a place, shape (3,); lengths have so many decimals."""
        return self


class CollimatedSource(AnySource):
    """Parallel light along the optical axis that fills the entrance face."""

    model_config = ConfigDict(title="Collimated light")

    kind: Literal["collimated"]
    rays: Annotated[
        tuple[RayCount, RayCount],
        about(
            "Rays",
            "Rays along x and y in each iteration of the paper's method, and for derivative maps. "
            "More give a smoother image and take longer; at least two per pixel and axis are "
            "good. Automatic chooses its own.",
        ),
    ] = (512, 512)
    along_axis: ClassVar[bool] = True

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return math.prod(self.rays)

    @property
    def samples(self) -> tuple[int, int]:
        """Its rays."""
        return self.rays

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """It is the same everywhere."""
        return True, True


class LightOfPoints(AnySource):
    """What points have in common: each emits into a cone that just covers the entrance face."""

    middle: ClassVar[str]
    """Name of the field that holds its middle."""

    kind: str
    rays: int
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: Fresh = False
    intersection: Intersection = ExactMethod()

    @property
    def place(self) -> Place:
        """Its middle, scene units."""
        place: Place = getattr(self, self.middle)
        return place

    @property
    def positions(self) -> Array:
        """Where its points are, scene units, shape (n, 3); all have the same z."""
        return np.array([self.place])

    @property
    def point_count(self) -> int:
        """How many there are."""
        return len(self.positions)

    @property
    def axes(self) -> tuple[Array, Array] | None:
        """The x of its columns and the y of its rows of points; None where they are no grid."""
        return None

    @property
    def redrawn(self) -> bool:
        """As its field says."""
        return self.fresh

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Those of its triangle mesh."""
        return self.intersection.subdivisions

    def check_before(self, lens: Lens) -> None:
        """Refuse a lens that is not behind it, or too near, too far or too fine."""
        x, y, z = self.place
        path = f"source.{self.middle}"
        if z >= lens.entrance_z:
            raise Refused(
                f"{path}[2]",
                f"{z:g} is not before the entrance face; less than {lens.entrance_z:g}",
            )
        aside = [(f"{path}[0]", x), (f"{path}[1]", y)]
        limits.check_lengths(aside, lens.half_width, limits.FARTHEST)
        limits.check_way(f"{path}[2]", lens.entrance_z - z, lens.half_width)
        self.intersection.check_for(lens)

    def placed(self, place: Place) -> Self:
        """The same source with its middle elsewhere."""
        return self.model_copy(update={self.middle: place})


class PointSource(LightOfPoints):
    """Light from one point into the cone that just covers the entrance face."""

    model_config = ConfigDict(title="Point source")

    middle = "position"

    kind: Literal["point"]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about(
            "Position",
            "Where the point is: x, y and z. It has to stand before the entrance face; off the "
            "axis it lights the lens askew.",
        ),
    ]
    rays: Annotated[
        int,
        about(
            "Rays",
            "Rays in each iteration of the paper's method, and for derivative maps, those that "
            "miss the lens included. More give a smoother image and take longer; at least four "
            "per pixel are good. Automatic chooses its own.",
            ge=1,
            le=_MOST,
        ),
    ] = 500_000

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or _in_front(scene.lens)}

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return self.rays

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where it is on the axis."""
        return self.position[0] == 0, self.position[1] == 0

    @property
    def point(self) -> Self:
        """It is one."""
        return self

    @property
    def axes(self) -> tuple[Array, Array]:
        """The x and the y of its points, shape (1,) each."""
        x, y, _ = self.position
        return np.array([x]), np.array([y])


class GridSource(LightOfPoints):
    """Many points of equal intensity, standing for a source of some size.

    Each emits into a cone of its own that just covers the entrance face, so its part of the flux
    goes with what that cone takes of its light.
    """

    model_config = ConfigDict(title="Grid of points")

    middle = "center"

    kind: Literal["grid"]
    center: Annotated[
        Place,
        LENGTH,
        PLACE,
        about(
            "Centre",
            "The middle of the grid: x, y and z. All points have the same z, before the entrance "
            "face.",
        ),
    ]
    half_width: Annotated[
        tuple[NonNegative, NonNegative],
        LENGTH,
        about(
            "Half width",
            "Half of the grid's extent along x and y. No detail of the image can be sharper than "
            "the image that the lens makes of this.",
        ),
    ]
    points: Annotated[
        tuple[PointCount, PointCount],
        about(
            "Points",
            "Points along x and y, the outer ones on the rim. More of them come closer to an "
            "evenly bright source.",
        ),
    ]
    rays: Annotated[
        int,
        about(
            "Rays per point",
            "Rays from each point of the grid, for the paper's method and derivative maps. What "
            "they add up to makes the image smooth; few from each of many points are enough. "
            "Automatic chooses its own.",
            ge=1,
            le=_MOST,
        ),
    ] = 1000

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is, half as wide as the lens."""
        x, y = scene.lens.half_width
        place = scene.source.place or _in_front(scene.lens)
        return {"center": place, "half_width": (x / 2, y / 2), "points": (25, 25)}

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return self.rays * math.prod(self.points)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where its middle is on the axis."""
        return self.center[0] == 0, self.center[1] == 0

    @property
    def point(self) -> PointSource:
        """Its middle."""
        return PointSource(kind="point", position=self.center, emission=self.emission)

    @property
    def axes(self) -> tuple[Array, Array]:
        """The x of its columns, shape (m_x,), and the y of its rows of points, shape (m_y,)."""
        x, y = (
            middle + (np.linspace(-r, r, count) if count > 1 else np.zeros(1))
            for middle, r, count in zip(self.center, self.half_width, self.points, strict=False)
        )
        return x, y

    @property
    def positions(self) -> Array:
        """Where its points are, shape (m_x m_y, 3): y runs first."""
        x, y = self.axes
        places = np.broadcast_arrays(x[:, None], y, self.center[2])
        return np.stack(places, axis=-1).reshape(-1, 3)

    def blur(self, lens: Lens, screen: Screen) -> tuple[float, float]:
        """Its extent, times how much farther the screen is from the lens than it is."""
        farther = (screen.z - lens.highest) / (lens.entrance_z - self.center[2])
        r_x, r_y = self.half_width
        return 2 * r_x * farther, 2 * r_y * farther

    def remarks(self) -> Mapping[str, str]:
        """All its rays."""
        return {"rays": f"= {self.ray_count:,} in all"}

    def check_before(self, lens: Lens) -> None:
        """Refuse a lens as a single point does; refuse more rays than there is memory for."""
        if self.ray_count > _MOST:
            raise Refused(
                "source.rays",
                f"{self.rays} from each of {math.prod(self.points)} points are too many; "
                f"at most {_MOST} rays in all",
            )
        extent = [(f"source.half_width[{axis}]", r) for axis, r in enumerate(self.half_width)]
        limits.check_lengths(extent, lens.half_width, limits.FARTHEST)
        super().check_before(lens)

    def seen(self, most: tuple[int, int]) -> Array:
        """Points spread over the same extent; see `AnySource.seen`."""
        x, y = (min(pair) for pair in zip(self.points, most, strict=True))
        return self.model_copy(update={"points": (x, y)}).positions

    @property
    def corners(self) -> Array:
        """Its outermost points, shape (n, 3); none where there is nothing to widen."""
        return self.seen((2, 2)) if max(self.points) > 1 else np.zeros((0, 3))

    def shrunk(self, factor: float) -> Self:
        """A grid of another size about the same middle."""
        x, y = self.half_width
        return self.model_copy(update={"half_width": (factor * x, factor * y)})

    def widened(self, corner: Array, digits: int) -> Self:
        """A grid about the same middle with a corner at a place; see `AnySource.widened`."""
        wide = (np.round(np.abs(corner - self.center), digits) + 0.0).tolist()  # without -0
        # Along an axis with a single point there is nothing to widen.
        axes = zip(wide, self.half_width, self.points, strict=False)
        return self.model_copy(
            update={"half_width": tuple(new if count > 1 else old for new, old, count in axes)}
        )


Source = Annotated[CollimatedSource | PointSource | GridSource, Kinds("kind")]


def _in_front(lens: Lens) -> Place:
    """On the axis, far enough away for the lens to bend all its light."""
    return (0.0, 0.0, lens.entrance_z - _DISTANCE * max(lens.half_width))
