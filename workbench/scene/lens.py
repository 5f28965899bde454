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
from workbench.scene import limits
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


def _thinnest(data: dict[str, Any]) -> float:
    """Default minimal thickness: small beside the lens and its stock."""
    thickest = data.get("max_thickness")
    relative = _relative(0.05)(data)
    return relative if thickest is None else min(relative, thickest / 2)


class Lens(Part):
    """Flat entrance face and B-spline exit face over a rectangle.

    ``control_points`` and ``degree`` are (along x, along y). ``height_range`` is the offset from
    the base that a control height may take; left out, a run takes what its task needs.
    ``max_thickness`` and ``min_thickness`` are counted from the entrance face to the exit face, and
    hold in any case. Other defaults scale with the lens.
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
    height_range: Annotated[tuple[float, float] | None, LENGTH] = None
    max_thickness: Annotated[Positive | None, LENGTH] = None
    min_thickness: Annotated[NonNegative, LENGTH] = Field(default_factory=_thinnest)

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
    def _computable(self) -> Self:
        limits.check_width(self.half_width)
        heights = [
            ("lens.entrance_z", self.entrance_z),
            ("lens.base.height", self.base.height),
            *((f"lens.height_range[{end}]", z) for end, z in enumerate(self.height_range or ())),
            ("lens.max_thickness", self.max_thickness or 0.0),
            ("lens.min_thickness", self.min_thickness),
        ]
        limits.check_lengths(heights, self.half_width, limits.HEIGHT)
        if isinstance(self.base, SphereBase):
            radius = [("lens.base.radius", self.base.radius)]
            limits.check_lengths(radius, self.half_width, limits.FAR)
        return self

    @model_validator(mode="after")
    def _possible(self) -> Self:
        for axis in (0, 1):
            count, degree = self.control_points[axis], self.degree[axis]
            if count < degree + 1:
                raise Refused(
                    f"lens.control_points[{axis}]",
                    f"{count} is too few for degree {degree}; at least {degree + 1}",
                )
        if not self.index > 1:
            raise Refused("lens.refractive_index", f"{self.index:g}; greater than 1 is needed")
        limits.check_index(self.index)
        if isinstance(self.base, SphereBase) and self.base.radius <= math.hypot(*self.half_width):
            raise Refused(
                "lens.base.radius",
                f"{self.base.radius:g} does not span the lens; "
                f"more than its half-diagonal {math.hypot(*self.half_width):g}",
            )
        if self.floor >= self.ceiling:
            raise Refused(
                "lens.max_thickness",
                f"{self.max_thickness:g} leaves no room above the minimal thickness; "
                f"more than {self.min_thickness:g}",
            )
        if self.height_range is not None:
            self._check_range(*self.height_range)
        return self

    def _check_range(self, low: float, high: float) -> None:
        """Refuse a height range that leaves a control point nowhere to be."""
        if not low < high:
            raise Refused("lens.height_range", f"[{low:g}, {high:g}] is empty; low before high")
        lowest, highest = self.base.extent(self.half_width)
        if lowest + high <= self.floor:
            raise Refused(
                "lens.height_range[1]",
                f"{high:g} leaves no room above the minimal thickness; "
                f"more than {self.floor - lowest:g}",
            )
        if highest + low >= self.ceiling:
            raise Refused(
                "lens.height_range[0]",
                f"{low:g} leaves no room below the maximal thickness; "
                f"less than {self.ceiling - highest:g}",
            )

    @property
    def floor(self) -> float:
        """The z that the minimal thickness keeps the exit face above."""
        return self.entrance_z + self.min_thickness

    @property
    def ceiling(self) -> float:
        """The z that the maximal thickness keeps the exit face below; infinite without one."""
        return math.inf if self.max_thickness is None else self.entrance_z + self.max_thickness

    def limits_at(
        self, x: npt.ArrayLike, y: npt.ArrayLike
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Lowest and highest z that control points at (x, y) may have; x and y broadcast.

        The highest is infinite where neither a height range nor a maximal thickness is given.
        """
        low, high = self.height_range or (-math.inf, math.inf)
        base = self.base.height_at(x, y)
        return np.maximum(base + low, self.floor), np.minimum(base + high, self.ceiling)

    @property
    def highest(self) -> float:
        """The z that no point of the exit face can be above.

        Without a height range and a maximal thickness it is the top of the base: each run keeps
        the face clear of its screen.
        """
        top = self.base.extent(self.half_width)[1]
        if self.height_range is not None:
            return min(top + self.height_range[1], self.ceiling)
        return max(top, self.floor) if self.max_thickness is None else self.ceiling

    @property
    def index(self) -> float:
        """Refractive index as a number."""
        if not isinstance(self.refractive_index, str):
            return float(self.refractive_index)
        if self.wavelength_um is None:
            named = shown(self.refractive_index)
            raise Refused("lens.wavelength_um", f"missing; it goes with {named}")
        return materials.refractive_index(self.refractive_index, self.wavelength_um)
