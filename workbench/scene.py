"""The scene: what a person edits. Frozen, validated values; every length in one unit.

Field by field this is the scene file (``*.json``), so a scene that exists is a scene that is
possible: whatever cannot be built, traced or made is refused here, with the path of the field.
"""

import json
import math
from collections.abc import Callable
from typing import Annotated, Any, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    Tag,
    ValidationError,
    field_validator,
    model_validator,
)

from workbench import materials
from workbench.errors import Refused
from workbench.refusals import refusal, told_by

Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]
Degree = Annotated[int, Field(ge=1, le=7)]
NetSize = Annotated[int, Field(ge=2, le=1024)]
RayCount = Annotated[int, Field(ge=1, le=4096)]
PixelCount = Annotated[int, Field(ge=1, le=4096)]


class Part(BaseModel):
    """A frozen part of the scene that refuses unknown fields and loose types."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)


class FlatBase(Part):
    """Plane f(x, y) = height."""

    shape: Literal["flat"] = "flat"
    height: float

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        x, y = np.broadcast_arrays(x, y)
        return np.full(x.shape, self.height)

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        return self.height, self.height


class SphereBase(Part):
    """Spherical cap; "concave" rises towards the rim, "convex" falls."""

    shape: Literal["sphere"] = "sphere"
    height: float
    radius: Positive
    form: Literal["concave", "convex"] = "concave"

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        r2 = np.square(x) + np.square(y)
        # R − √(R² − r²) without the cancellation of two large numbers.
        sag = r2 / (self.radius + np.sqrt(self.radius**2 - r2))
        return np.asarray(self.height + (sag if self.form == "concave" else -sag))

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        rim = float(self.height_at(*half_width))
        return min(rim, self.height), max(rim, self.height)


Base = FlatBase | SphereBase
_BaseField = Annotated[
    Annotated[FlatBase, Tag("flat")] | Annotated[SphereBase, Tag("sphere")],
    told_by("shape", "flat", "sphere", otherwise="flat"),
]


def _relative(factor: float) -> Callable[[dict[str, Any]], float]:
    """Default length: a multiple of the larger lens half-width (0 where that was refused)."""
    return lambda data: factor * max(data.get("half_width", (0.0,)))


class Lens(Part):
    """Flat entrance face and B-spline exit face over a rectangle.

    ``control_points`` and ``degree`` are (along x, along y). ``height_range`` is the offset from
    the base that a control height may take. Defaults scale with the lens.
    """

    half_width: tuple[Positive, Positive]
    entrance_z: float = 0.0
    refractive_index: float | str
    wavelength_um: Positive | None = None
    degree: tuple[Degree, Degree] = (3, 3)
    control_points: tuple[NetSize, NetSize]
    base: _BaseField = Field(
        default_factory=lambda data: FlatBase(
            height=data.get("entrance_z", 0.0) + _relative(0.5)(data)
        )
    )
    height_range: tuple[float, float] = Field(
        default_factory=lambda data: (_relative(-0.3)(data), _relative(0.3)(data))
    )
    min_thickness: NonNegative = Field(default_factory=_relative(0.05))

    @field_validator("refractive_index", mode="before")
    @classmethod
    def _number_or_name(cls, value: object) -> object:
        # Said here, not by pydantic, which would report each member of the union.
        if isinstance(value, bool) or not isinstance(value, (int, float, str)):
            raise Refused(
                "lens.refractive_index",
                f"{value!r} is neither a number nor a name; a number above 1 or a material name",
            )
        if isinstance(value, (int, float)) and not 1 < value < math.inf:
            raise Refused("lens.refractive_index", f"{value!r}; a number greater than 1 is needed")
        return value

    @model_validator(mode="after")
    def _possible(self) -> Self:
        for axis in (0, 1):
            count, degree = self.control_points[axis], self.degree[axis]
            if count < degree + 1:
                raise Refused(
                    f"lens.control_points[{axis}]",
                    f"{count} is too few for degree {degree}; at least {degree + 1}",
                )
        if isinstance(self.refractive_index, str) and self.wavelength_um is None:
            raise Refused("lens.wavelength_um", f"missing; it goes with {self.refractive_index!r}")
        if not self.index > 1:
            raise Refused("lens.refractive_index", f"{self.index:g}; greater than 1 is needed")
        if isinstance(self.base, SphereBase) and self.base.radius <= math.hypot(*self.half_width):
            raise Refused(
                "lens.base.radius",
                f"{self.base.radius:g} does not span the lens; "
                f"more than its half-diagonal {math.hypot(*self.half_width):g}",
            )
        low, high = self.height_range
        if not low < high:
            raise Refused("lens.height_range", f"[{low:g}, {high:g}] is empty; low before high")
        floor = self.entrance_z + self.min_thickness
        lowest = self.base.extent(self.half_width)[0]
        if lowest + high <= floor:
            raise Refused(
                "lens.height_range[1]",
                f"{high:g} leaves no room above the minimal thickness; "
                f"more than {floor - lowest:g}",
            )
        return self

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if isinstance(self.refractive_index, str):
            assert self.wavelength_um is not None  # validated
            return materials.refractive_index(self.refractive_index, self.wavelength_um)
        return float(self.refractive_index)


class CollimatedSource(Part):
    """Parallel light along +z that fills the entrance face; ``rays`` per axis."""

    kind: Literal["collimated"]
    rays: tuple[RayCount, RayCount] = (512, 512)


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


_IntersectionField = Annotated[
    Annotated[ExactMethod, Tag("exact")] | Annotated[MeshMethod, Tag("mesh")],
    told_by("method", "exact", "mesh", otherwise="exact"),
]

Emission = Literal["uniform", "lambertian"]
Sampling = Literal["sobol", "random"]
Position = tuple[float, float, float]


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
    intersection: _IntersectionField = ExactMethod()

    @property
    def nearest_z(self) -> float:
        """Where the source comes closest to the lens."""
        return self.position[2]


class GridSource(Part):
    """Point sources on an equispaced grid, standing for an extended source; ``rays`` of each."""

    kind: Literal["grid"]
    center: Position
    half_width: tuple[NonNegative, NonNegative]
    points: tuple[Annotated[int, Field(ge=1, le=512)], Annotated[int, Field(ge=1, le=512)]]
    rays: Annotated[int, Field(ge=1, le=1 << 24)] = 1000
    emission: Emission = "uniform"
    sampling: Sampling = "sobol"
    fresh: bool = False
    intersection: _IntersectionField = ExactMethod()

    @property
    def nearest_z(self) -> float:
        """Where the source comes closest to the lens."""
        return self.center[2]

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
_SourceField = Annotated[
    Annotated[CollimatedSource, Tag("collimated")]
    | Annotated[PointSource, Tag("point")]
    | Annotated[GridSource, Tag("grid")],
    told_by("kind", "collimated", "point", "grid"),
]


class Screen(Part):
    """Plane at ``z`` centred on the axis; ``pixels`` are (along x, along y)."""

    z: float
    half_width: tuple[Positive, Positive]
    pixels: tuple[PixelCount, PixelCount]

    def to_pixels(self, x: Any, y: Any) -> tuple[Any, Any]:
        """Continuous image coordinates (column, row) of points on the screen.

        Pixel (row i, column j) covers [j, j+1) × [i, i+1). Row 0 is at +y and column 0 at −x.
        This is the one place where y turns into rows.

        Parameters
        ----------
        x, y : float, numpy array or torch tensor
            Position on the screen, scene units.
        """
        (r_x, r_y), (n_x, n_y) = self.half_width, self.pixels
        return (x + r_x) * (n_x / (2 * r_x)), (r_y - y) * (n_y / (2 * r_y))

    @property
    def pixel_area(self) -> float:
        """Area of one pixel, scene units squared."""
        return 4 * math.prod(self.half_width) / math.prod(self.pixels)


class BoxFilter(Part):
    """Every ray counts fully in the pixel that it hits."""

    kind: Literal["box"] = "box"


class GaussianFilter(Part):
    """Truncated Gaussian over ``size`` = (ν_x, ν_y) pixels; ``alpha`` per pixel²."""

    kind: Literal["gaussian"] = "gaussian"
    size: tuple[Annotated[int, Field(ge=1, le=99)], Annotated[int, Field(ge=1, le=99)]] = (3, 3)
    alpha: Annotated[float, Field(ge=1e-6, le=1e6)] = 1.0

    @model_validator(mode="after")
    def _odd(self) -> Self:
        for axis, size in enumerate(self.size):
            if size % 2 == 0:
                raise Refused(f"filter.size[{axis}]", f"{size} is even; an odd number is needed")
        return self


Filter = GaussianFilter | BoxFilter
_FilterField = Annotated[
    Annotated[GaussianFilter, Tag("gaussian")] | Annotated[BoxFilter, Tag("box")],
    told_by("kind", "gaussian", "box", otherwise="gaussian"),
]


class Finish(Part):
    """What is done to every target: black border, blur, inversion.

    ``padding`` is the black border on each side as a fraction of the screen, ``blur`` the
    standard deviation of a Gaussian in screen pixels.
    """

    padding: Annotated[float, Field(ge=0, lt=0.5)] = 0.0
    blur: Annotated[float, Field(ge=0, le=1000)] = 0.0
    invert: bool = False


class ImageTarget(Finish):
    """An image file; a relative path starts at the scene file's folder."""

    image: Annotated[str, Field(min_length=1)]


class TopHatTarget(Finish):
    """Uniform disc; ``radius`` as a fraction of the smaller screen half-width."""

    builtin: Literal["tophat"] = "tophat"
    radius: Annotated[float, Field(gt=0, le=1)] = 0.6


class FlameTarget(Finish):
    """Flame-like logo on black; ``height`` as a fraction of the smaller screen width."""

    builtin: Literal["flame"] = "flame"
    height: Annotated[float, Field(gt=0, le=1)] = 0.85


class BallTarget(Finish):
    """Faceted ball in several greys; ``radius`` as a fraction of the smaller half-width."""

    builtin: Literal["ball"] = "ball"
    radius: Annotated[float, Field(gt=0, le=1)] = 0.8


Target = ImageTarget | TopHatTarget | FlameTarget | BallTarget
_TargetField = Annotated[
    Annotated[ImageTarget, Tag("image")]
    | Annotated[TopHatTarget, Tag("tophat")]
    | Annotated[FlameTarget, Tag("flame")]
    | Annotated[BallTarget, Tag("ball")],
    told_by("builtin", "tophat", "flame", "ball", otherwise="image"),
]


class RunSettings(Part):
    """What every design run has: an upper limit of iterations, a seed, where it computes."""

    iterations: Annotated[int, Field(ge=0, le=1_000_000)] = 300
    seed: Annotated[int, Field(ge=0, lt=2**63)] = 0
    device: Literal["cpu", "cuda"] = "cpu"


class AutoRun(RunSettings):
    """The best this program knows; may stop before ``iterations`` when nothing improves."""

    method: Literal["auto"] = "auto"


class PaperRun(RunSettings):
    """Adam on the control heights through tanh, or through a network, as in the paper.

    Attributes
    ----------
    parametrisation : str
        What is optimised: "none", one number per control height; "sparse" or "dense", the
        weights and biases of a network that puts the heights out.
    start : str
        Those numbers before the first step: "zeros", "uniform" on ±1e-4, or "random".
    learning_rate : float, optional
        Step of Adam; left out, the one that suits the parametrisation.
    """

    method: Literal["paper"] = "paper"
    parametrisation: Literal["none", "sparse", "dense"] = "none"
    start: Literal["zeros", "uniform", "random"] = "zeros"
    learning_rate: Positive | None = None


Run = AutoRun | PaperRun
_RunField = Annotated[
    Annotated[AutoRun, Tag("auto")] | Annotated[PaperRun, Tag("paper")],
    told_by("method", "auto", "paper", otherwise="auto"),
]


class Scene(Part):
    """A whole design task. Only lens, source, screen and target are required."""

    format: Literal["freeform-scene"] = "freeform-scene"
    version: Literal[1] = 1
    unit: Literal["mm", "cm", "m", "inch"] = "mm"
    lens: Lens
    source: _SourceField
    screen: Screen
    filter: _FilterField = GaussianFilter()
    target: _TargetField
    run: _RunField = AutoRun()

    @model_validator(mode="after")
    def _source_stands_before_the_lens(self) -> Self:
        source = self.source
        if not isinstance(source, CollimatedSource) and source.nearest_z >= self.lens.entrance_z:
            field = "position" if isinstance(source, PointSource) else "center"
            raise Refused(
                f"source.{field}[2]",
                f"{source.nearest_z:g} is not before the entrance face; "
                f"less than {self.lens.entrance_z:g}",
            )
        return self

    @model_validator(mode="after")
    def _mesh_within_memory(self) -> Self:
        if isinstance(self.source, CollimatedSource):
            return self
        if isinstance(how := self.source.intersection, MeshMethod):
            lens = self.lens
            across, up = (
                (count - degree) * n
                for count, degree, n in zip(
                    lens.control_points, lens.degree, how.subdivisions, strict=True
                )
            )
            if across * up > 1 << 24:
                raise Refused(
                    "source.intersection.subdivisions",
                    f"{list(how.subdivisions)} make {across} × {up} rectangles; "
                    f"at most {1 << 24} in all",
                )
        return self

    @model_validator(mode="after")
    def _screen_clears_the_lens(self) -> Self:
        lens = self.lens
        highest = lens.base.extent(lens.half_width)[1] + lens.height_range[1]
        if self.screen.z <= highest:
            raise Refused(
                "screen.z",
                f"{self.screen.z:g} may touch the lens; "
                f"more than {highest:g}, the highest that the exit face can become",
            )
        return self

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """Read a scene from the text of a scene file.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """
        try:
            return cls.model_validate_json(text)
        except ValidationError as error:
            raise refusal(error, cls) from None

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """Read a scene from plain dictionaries and lists, as `json.loads` gives them."""
        return cls.from_json(json.dumps(data))

    def to_json(self) -> str:
        """The text of a scene file, indented."""
        return self.model_dump_json(indent=2, exclude_none=True) + "\n"

    def to_data(self) -> dict[str, Any]:
        """The scene as plain dictionaries and lists."""
        data: dict[str, Any] = self.model_dump(mode="json", exclude_none=True)
        return data
