"""Light sources before the lens."""

import math
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import Field, Tag, model_validator

from workbench.errors import Refused
from workbench.refusals import told_by
from workbench.scene.part import LENGTH, NonNegative, Part

RayCount = Annotated[int, Field(ge=1, le=4096)]


class ExactMethod(Part):
    """Rays meet the B-spline itself."""

    method: Literal["exact"] = "exact"


class MeshMethod(Part):
    """Rays meet triangles; ``subdivisions`` of each knot span, (along x, along y)."""

    method: Literal["mesh"] = "mesh"
    subdivisions: tuple[Annotated[int, Field(ge=1, le=64)], Annotated[int, Field(ge=1, le=64)]] = (
        4,
        4,
    )


IntersectionField = Annotated[
    Annotated[ExactMethod, Tag("exact")] | Annotated[MeshMethod, Tag("mesh")],
    told_by("method", "exact", "mesh", otherwise="exact"),
]


class CollimatedSource(Part):
    """Parallel light along +z that fills the entrance face; ``rays`` per axis."""

    kind: Literal["collimated"]
    rays: tuple[RayCount, RayCount] = (512, 512)
    # Along the axis a ray meets the face right before it: there is nothing to choose.
    intersection: ClassVar[ExactMethod] = ExactMethod()


Emission = Literal["uniform", "lambertian"]
Sampling = Literal["sobol", "random"]
Position = Annotated[tuple[float, float, float], LENGTH]
Array = npt.NDArray[np.float64]


class PointSource(Part):
    """Light from one point into the cone that just covers the entrance face.

    Attributes
    ----------
    position : tuple[float, float, float]
        Where it is, before the lens.
    rays : int
        Rays in all.
    emission : str
        "uniform" in solid angle, or "lambertian": with the cosine to the z axis.
    sampling : str
        "sobol" (low discrepancy, scrambled by the seed) or "random".
    fresh : bool
        New rays for each iteration of the paper's method; "auto" needs the same ones.
    intersection : ExactMethod or MeshMethod
        Where rays meet the exit face: on the B-spline, or on triangles as in the paper.
    """

    kind: Literal["point"]
    position: Position
    rays: Annotated[int, Field(ge=1, le=1 << 24)] = 500_000
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: bool = False
    intersection: IntersectionField = ExactMethod()

    @property
    def nearest_z(self) -> float:
        """Where the source comes closest to the lens."""
        return self.position[2]

    @property
    def axes(self) -> tuple[Array, Array]:
        """The x and the y of its points, shape (1,) each."""
        x, y, _ = self.position
        return np.array([x]), np.array([y])

    @property
    def positions(self) -> Array:
        """Where its points are, shape (1, 3)."""
        return np.array([self.position])


class GridSource(Part):
    """Point sources on an equispaced grid, standing for an extended source; ``rays`` of each.

    All points have the same intensity. Each emits into a cone of its own that just covers the
    entrance face, so its part of the flux goes with what that cone takes of its light.
    """

    kind: Literal["grid"]
    center: Position
    half_width: Annotated[tuple[NonNegative, NonNegative], LENGTH]
    points: tuple[Annotated[int, Field(ge=1, le=512)], Annotated[int, Field(ge=1, le=512)]]
    rays: Annotated[int, Field(ge=1, le=1 << 24)] = 1000
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: bool = False
    intersection: IntersectionField = ExactMethod()

    @property
    def nearest_z(self) -> float:
        """Where the source comes closest to the lens."""
        return self.center[2]

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

    @model_validator(mode="after")
    def _within_memory(self) -> Self:
        if math.prod(self.points) * self.rays > 1 << 24:
            raise Refused(
                "source.rays",
                f"{self.rays} from each of {math.prod(self.points)} points are too many; "
                f"at most {1 << 24} rays in all",
            )
        return self


Source = CollimatedSource | PointSource | GridSource
SourceField = Annotated[
    Annotated[CollimatedSource, Tag("collimated")]
    | Annotated[PointSource, Tag("point")]
    | Annotated[GridSource, Tag("grid")],
    told_by("kind", "collimated", "point", "grid"),
]


def of_points(source: Source) -> PointSource | GridSource:
    """A source as one of points.

    Raises
    ------
    Refused
        If it has none.
    """
    if isinstance(source, CollimatedSource):
        raise Refused("source.kind", "'collimated' is no light of points; 'point' or 'grid'")
    return source
