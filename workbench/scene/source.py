"""Light sources before the lens: a class for each kind, and `Source`, the list of them."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict, Field

from workbench.errors import Refused
from workbench.scene import limits
from workbench.scene.fields import LENGTH, PLACE, Choices, ForMethod, about
from workbench.scene.kinds import Kinds
from workbench.scene.lens import Lens
from workbench.scene.part import NonNegative, Part

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Array = npt.NDArray[np.float64]

RayCount = Annotated[int, Field(ge=1, le=4096)]
PointCount = Annotated[int, Field(ge=1, le=512)]
Subdivisions = Annotated[int, Field(ge=1, le=64)]
_MOST = 1 << 24  # rays, and rectangles of a mesh
# A new source stands this many lens half-widths before the entrance face.
_DISTANCE = 5.0


class ExactMethod(Part):
    """On the B-spline itself, fast and without an error of its own."""

    model_config = ConfigDict(title="Exact")

    method: Literal["exact"] = "exact"
    subdivisions: ClassVar[None] = None

    def check_for(self, lens: Lens) -> None:
        """Refuse nothing: it suits any lens."""


class MeshMethod(Part):
    """As in the paper, for comparison."""

    model_config = ConfigDict(title="Triangle mesh")

    method: Literal["mesh"] = "mesh"
    subdivisions: Annotated[
        tuple[Subdivisions, Subdivisions],
        about(
            "Subdivisions",
            "Parts along x and y that each knot span is cut into, two triangles each. Twice as "
            "many make a quarter of the error, and four times the triangles.",
        ),
    ] = (4, 4)

    def check_for(self, lens: Lens) -> None:
        """Refuse more triangles than there is memory for."""
        across, up = (
            (count - degree) * n
            for count, degree, n in zip(
                lens.control_points, lens.degree, self.subdivisions, strict=True
            )
        )
        if across * up > _MOST:
            raise Refused(
                "source.intersection.subdivisions",
                f"{list(self.subdivisions)} make {across} × {up} rectangles; "
                f"at most {_MOST} in all",
            )


Intersection = Annotated[
    ExactMethod | MeshMethod,
    Kinds("method", default="exact"),
    about("Intersection", "How it is found where a ray meets the exit face."),
]
Emission = Annotated[
    Literal["uniform", "lambertian"],
    about(
        "Emission",
        "Uniform: equally bright in all directions, as a small bulb. Lambertian: dimmer away from "
        "the optical axis, as the surface of an LED.",
    ),
]
Sampling = Annotated[
    Literal["sobol", "random"],
    Choices((("sobol", "Low discrepancy"),)),
    about(
        "Sampling",
        "How directions are drawn. Low discrepancy (Sobol) spreads them evenly and needs far fewer "
        "rays; random is noisier, as in the paper.",
    ),
]
Fresh = Annotated[
    bool,
    ForMethod("paper"),
    about(
        "Fresh rays",
        "Draw new rays for each iteration of the paper's method, so that the lens cannot fit "
        "itself to one set of them. Automatic compares lenses by the same rays and does not have "
        "this.",
    ),
]
Place = tuple[float, float, float]


class AnySource(Part):
    """What each kind of source says of itself, so that nobody has to ask for its kind.

    Here it is said of light that comes from infinitely far: it has no place that could be seen.
    """

    @property
    def place(self) -> Place | None:
        """Its middle, scene units."""
        return None

    along_axis: ClassVar[bool] = False
    """Whether all its rays go along +z."""

    @property
    def samples(self) -> tuple[int, int]:
        """Rays along x and y that it asks for, at least."""
        return 1, 1

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether its light is surely its own mirror image in x, in y."""
        return False, False

    @property
    def point(self) -> "PointSource | None":
        """The point that stands for it in rough plans; None if it has no place."""
        return None if self.place is None else PointSource(kind="point", position=self.place)

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
            "Rays traced along x and y in each iteration. More rays give a smoother image and take "
            "longer; at least two per pixel and axis are good.",
        ),
    ] = (512, 512)
    along_axis: ClassVar[bool] = True

    @property
    def samples(self) -> tuple[int, int]:
        """Its rays."""
        return self.rays

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """It is the same everywhere."""
        return True, True


class PointSource(AnySource):
    """Light from one point into the cone that just covers the entrance face."""

    model_config = ConfigDict(title="Point source")

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
            "Rays traced in each iteration, those that miss the lens included. More give a "
            "smoother image and take longer; at least four per pixel are good.",
            ge=1,
            le=_MOST,
        ),
    ] = 500_000
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: Fresh = False
    intersection: Intersection = ExactMethod()

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is."""
        return {"position": scene.source.place or _in_front(scene.lens)}

    @property
    def samples(self) -> tuple[int, int]:
        """As many as a grid of its rays has along x and y."""
        return math.isqrt(self.rays), math.isqrt(self.rays)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where it is on the axis."""
        return self.position[0] == 0, self.position[1] == 0

    @property
    def point(self) -> Self:
        """It is one."""
        return self

    @property
    def redrawn(self) -> bool:
        """As its field says."""
        return self.fresh

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Those of its triangle mesh."""
        return self.intersection.subdivisions

    @property
    def place(self) -> Place:
        """Where it is, scene units."""
        return self.position

    @property
    def axes(self) -> tuple[Array, Array]:
        """The x and the y of its points, shape (1,) each."""
        x, y, _ = self.position
        return np.array([x]), np.array([y])

    @property
    def positions(self) -> Array:
        """Where its points are, shape (1, 3)."""
        return np.array([self.position])

    def check_before(self, lens: Lens) -> None:
        """Refuse a lens that is not behind it, or too near, too far or too fine."""
        _check_place("source.position", self.position, lens)
        self.intersection.check_for(lens)

    def placed(self, place: Place) -> Self:
        """The same source elsewhere."""
        return self.model_copy(update={"position": place})


class GridSource(AnySource):
    """Many points of equal intensity, standing for a source of some size.

    Each emits into a cone of its own that just covers the entrance face, so its part of the flux
    goes with what that cone takes of its light.
    """

    model_config = ConfigDict(title="Grid of points")

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
            "Rays from each point of the grid. What they add up to makes the image smooth; few "
            "from each of many points are enough.",
            ge=1,
            le=_MOST,
        ),
    ] = 1000
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: Fresh = False
    intersection: Intersection = ExactMethod()

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is, half as wide as the lens."""
        x, y = scene.lens.half_width
        place = scene.source.place or _in_front(scene.lens)
        return {"center": place, "half_width": (x / 2, y / 2), "points": (25, 25)}

    @property
    def samples(self) -> tuple[int, int]:
        """As many as a grid of all its rays has along x and y."""
        count = self.rays * math.prod(self.points)
        return math.isqrt(count), math.isqrt(count)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where its middle is on the axis."""
        return self.center[0] == 0, self.center[1] == 0

    @property
    def point(self) -> PointSource:
        """Its middle."""
        return PointSource(kind="point", position=self.center, emission=self.emission)

    @property
    def redrawn(self) -> bool:
        """As its field says."""
        return self.fresh

    @property
    def subdivisions(self) -> tuple[int, int] | None:
        """Those of its triangle mesh."""
        return self.intersection.subdivisions

    @property
    def place(self) -> Place:
        """Its middle, scene units."""
        return self.center

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

    def remarks(self) -> Mapping[str, str]:
        """All its rays."""
        return {"rays": f"= {math.prod(self.points) * self.rays:,} in all"}

    def check_before(self, lens: Lens) -> None:
        """Refuse a lens as a single point does; refuse more rays than there is memory for."""
        if math.prod(self.points) * self.rays > _MOST:
            raise Refused(
                "source.rays",
                f"{self.rays} from each of {math.prod(self.points)} points are too many; "
                f"at most {_MOST} rays in all",
            )
        _check_place("source.center", self.center, lens)
        extent = [(f"source.half_width[{axis}]", r) for axis, r in enumerate(self.half_width)]
        limits.check_lengths(extent, lens.half_width, limits.FARTHEST)
        self.intersection.check_for(lens)

    def seen(self, most: tuple[int, int]) -> Array:
        """Points spread over the same extent; see `AnySource.seen`."""
        x, y = (min(pair) for pair in zip(self.points, most, strict=True))
        return self.model_copy(update={"points": (x, y)}).positions

    @property
    def corners(self) -> Array:
        """Its outermost points, shape (n, 3); none where there is nothing to widen."""
        return self.seen((2, 2)) if max(self.points) > 1 else np.zeros((0, 3))

    def placed(self, place: Place) -> Self:
        """The same grid about another middle."""
        return self.model_copy(update={"center": place})

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


def _check_place(path: str, place: Place, lens: Lens) -> None:
    """Refuse a middle that is not before the lens, or where no float32 can tell."""
    x, y, z = place
    if z >= lens.entrance_z:
        raise Refused(
            f"{path}[2]", f"{z:g} is not before the entrance face; less than {lens.entrance_z:g}"
        )
    aside = [(f"{path}[0]", x), (f"{path}[1]", y)]
    limits.check_lengths(aside, lens.half_width, limits.FARTHEST)
    limits.check_way(f"{path}[2]", lens.entrance_z - z, lens.half_width)
