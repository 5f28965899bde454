"""The lens: a flat entrance face, a B-spline exit face over a base."""

import math
from collections.abc import Callable
from typing import Annotated, Any, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import Field, Tag, field_validator, model_validator

from workbench import materials
from workbench.errors import Refused, shown
from workbench.refusals import told_by
from workbench.scene.part import LENGTH, NonNegative, Part, Positive

Degree = Annotated[int, Field(ge=1, le=7)]
LARGEST_NET = 1024
"""Control points along an axis, at most."""
NetSize = Annotated[int, Field(ge=2, le=LARGEST_NET)]


class FlatBase(Part):
    """Plane f(x, y) = height."""

    shape: Literal["flat"] = "flat"
    height: Annotated[float, LENGTH]

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
    height: Annotated[float, LENGTH]
    radius: Annotated[Positive, LENGTH]
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
BaseField = Annotated[
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

    half_width: Annotated[tuple[Positive, Positive], LENGTH]
    entrance_z: Annotated[float, LENGTH] = 0.0
    refractive_index: float | str
    wavelength_um: Positive | None = None
    degree: tuple[Degree, Degree] = (3, 3)
    control_points: tuple[NetSize, NetSize]
    base: BaseField = Field(
        default_factory=lambda data: FlatBase(
            height=data.get("entrance_z", 0.0) + _relative(0.5)(data)
        )
    )
    height_range: Annotated[tuple[float, float], LENGTH] = Field(
        default_factory=lambda data: (_relative(-0.3)(data), _relative(0.3)(data))
    )
    min_thickness: Annotated[NonNegative, LENGTH] = Field(default_factory=_relative(0.05))

    @field_validator("refractive_index", mode="before")
    @classmethod
    def _number_or_name(cls, value: object) -> object:
        # Said here, not by pydantic, which would report each member of the union.
        if isinstance(value, bool) or not isinstance(value, (int, float, str)):
            raise Refused(
                "lens.refractive_index",
                f"{shown(value)} is neither a number nor a name; "
                "a number above 1 or a material name",
            )
        if isinstance(value, (int, float)) and not 1 < value < math.inf:
            raise Refused(
                "lens.refractive_index", f"{shown(value)}; a number greater than 1 is needed"
            )
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
            raise Refused(
                "lens.wavelength_um", f"missing; it goes with {shown(self.refractive_index)}"
            )
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
    def highest(self) -> float:
        """The z that no control point, and so no point of the exit face, can be above."""
        return self.base.extent(self.half_width)[1] + self.height_range[1]

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if isinstance(self.refractive_index, str):
            assert self.wavelength_um is not None  # validated
            return materials.refractive_index(self.refractive_index, self.wavelength_um)
        return float(self.refractive_index)
