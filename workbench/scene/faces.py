"""Fixed faces of elements: planes and conics.

A face is described in its element's own coordinates: z is counted from the face's vertex. Where the
vertex stands is a matter of the element.
"""

import math
from abc import abstractmethod
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict, Field

from workbench import units
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.powers import rounded
from workbench.scene import limits
from workbench.scene.fields import LENGTH, about
from workbench.scene.part import Part

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Degree = Annotated[int, Field(ge=1, le=7)]
LARGEST_NET = 2048
"""Control points along an axis, at most."""

NetSize = Annotated[int, Field(ge=2, le=LARGEST_NET)]
NetShape = tuple[NetSize, NetSize]
_MOST_COEFFICIENTS = 8
_STEPS = 65  # at which the sag of an asphere is evaluated along each axis


class AnyFixedFace(Part):
    """What each shape of a fixed face says of itself, so that nobody has to ask for its shape.

    A new shape is a class here with the fields of the file, and a member of `FixedFace`; the
    formula by which rays meet it stands in `workbench.optics.surfaces.sag`, and for the check in
    `workbench.analysis.tracing.surfaces.fixed`.
    """

    designed: ClassVar[bool] = False
    height_range: ClassVar[None] = None
    flat: ClassVar[bool] = False
    """Whether it is a plane across the axis."""
    rotational: ClassVar[bool] = False
    """Whether it is a surface of revolution about its axis."""
    if TYPE_CHECKING:  # each kind has this field
        shape: str

    @abstractmethod
    def sag(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Height above the vertex, scene units; x and y broadcast."""

    @abstractmethod
    def normal(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Unit normals to +z at (x, y), with a last axis of 3; x and y broadcast."""

    @property
    @abstractmethod
    def vertex_curvature(self) -> float:
        """Mean curvature at the vertex, positive where the centre lies on the +z side."""

    @abstractmethod
    def turned(self) -> Self:
        """The same face seen from behind: turned by 180° about its x."""

    @property
    def sphere_radius(self) -> float | None:
        """Radius of the sphere that it is part of, signed as its curvature; None of others."""
        return None

    @property
    def base(self) -> Self:
        """The shape itself; a B-spline has a base of its own."""
        return self

    @property
    def undesigned(self) -> Self:
        """The same face: a design leaves it as it is."""
        return self

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest sag over the aperture."""
        x, y = (np.linspace(-r, r, 2 * _STEPS - 1) for r in half_width)
        sag = self.sag(x[:, None], y)
        return float(sag.min()), float(sag.max())

    def net(self, other: NetShape) -> None:
        """No control points."""

    def offsets(self, most: float, half_width: tuple[float, float]) -> tuple[float, float]:
        """Return its extent; see `SplineFace.offsets`."""
        return self.extent(half_width)

    def within(self, offsets: tuple[float, float]) -> Self:
        """Return the same face: it has no bounds."""
        return self

    @abstractmethod
    def check_face(self, called: str, half_width: tuple[float, float], rim: float) -> None:
        """Refuse a shape that ends within the rim of the element, so far from its axis."""


class PlaneFace(AnyFixedFace):
    """A plane across the axis."""

    model_config = ConfigDict(title="Plane")
    flat = True
    rotational = True

    shape: Literal["plane"] = "plane"

    @property
    def vertex_curvature(self) -> float:
        """None: 0."""
        return 0.0

    def sag(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """See `AnyFixedFace.sag`."""
        return np.zeros(np.broadcast(x, y).shape)

    def normal(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """See `AnyFixedFace.normal`."""
        return np.broadcast_to([0.0, 0.0, 1.0], (*np.broadcast(x, y).shape, 3))

    def turned(self) -> Self:
        """See `AnyFixedFace.turned`."""
        return self

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """See `AnyFixedFace.extent`."""
        return 0.0, 0.0

    def check_face(self, called: str, half_width: tuple[float, float], rim: float) -> None:
        """Refuse nothing: a plane suits any element."""


class ConicFace(AnyFixedFace):
    """A surface of revolution: a conic with aspheric coefficients (ISO 10110-12)."""

    model_config = ConfigDict(title="Conic")
    rotational = True

    shape: Literal["conic"] = "conic"
    radius: Annotated[
        float,
        LENGTH,
        about(
            "Radius",
            "Radius of curvature at the vertex: positive where the centre of curvature lies on the "
            "+z side of the vertex.",
        ),
    ]
    conic: Annotated[
        float,
        EXPERT,
        about(
            "Conic constant",
            "0 makes a sphere, −1 a paraboloid, less a hyperboloid, between −1 and 0 an ellipsoid.",
        ),
    ] = 0.0
    coefficients: Annotated[
        tuple[float, ...],
        EXPERT,
        about(
            "Coefficients",
            "Aspheric coefficients a4, a6, …: a4 r⁴ + a6 r⁶ + … is added to the sag.",
            max_length=_MOST_COEFFICIENTS,
        ),
    ] = ()

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Shallow enough for any element."""
        return {"radius": rounded(10 * math.hypot(*scene.optic.half_width), 2)}

    def scaled(self, factor: Fraction) -> Self:
        """See `Part.scaled`; a coefficient of rⁿ is a length to the power 1 − n."""
        coefficients = tuple(
            units.times(a, factor ** (-2 * k - 3)) for k, a in enumerate(self.coefficients)
        )
        return super().scaled(factor).model_copy(update={"coefficients": coefficients})

    @property
    def vertex_curvature(self) -> float:
        """See `AnyFixedFace.vertex_curvature`."""
        return 1 / self.radius

    @property
    def sphere_radius(self) -> float | None:
        """See `AnyFixedFace.sphere_radius`."""
        return None if self.conic or any(self.coefficients) else self.radius

    def turned(self) -> Self:
        """See `AnyFixedFace.turned`."""
        negative = tuple(-each for each in self.coefficients)
        return self.model_copy(update={"radius": -self.radius, "coefficients": negative})

    def sag(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Height above the vertex, scene units; x and y broadcast.

        z = c r² / (1 + √(1 − (1 + k) c² r²)) + a4 r⁴ + a6 r⁶ + … (ISO 10110-12).
        """
        r2, curvature = np.square(x) + np.square(y), 1 / self.radius
        root = np.sqrt(np.maximum(1 - (1 + self.conic) * curvature**2 * r2, 0.0))
        powers = sum(a * r2 ** (k + 2) for k, a in enumerate(self.coefficients))
        return np.asarray(curvature * r2 / (1 + root) + powers)

    def normal(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Unit normals to +z at (x, y), with a last axis of 3; x and y broadcast.

        Across the axis at the rim of a hemisphere, whose slope is infinite.
        """
        r2, curvature = np.square(x) + np.square(y), 1 / self.radius
        root = np.sqrt(np.maximum(1 - (1 + self.conic) * curvature**2 * r2, 0.0))
        powers = sum((2 * k + 4) * a * r2 ** (k + 1) for k, a in enumerate(self.coefficients))
        lean = curvature + root * powers
        parts = -lean * np.asarray(x), -lean * np.asarray(y), root
        normal = np.stack(np.broadcast_arrays(*parts), axis=-1)
        return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """See `AnyFixedFace.extent`."""
        x, y = (np.linspace(0, r, _STEPS) for r in half_width)
        r2 = np.square(x)[:, None] + np.square(y)
        there = (1 + self.conic) * r2 <= self.radius**2  # corners of an ellipse may be beyond it
        sag = self.sag(x[:, None], y)[there]
        return float(sag.min()), float(sag.max())

    def check_face(self, called: str, half_width: tuple[float, float], rim: float) -> None:
        """Refuse a surface that ends within the rim of the element, so far from its axis."""
        if self.radius == 0:
            raise Refused("radius", Message("0 is no curvature; a radius, or a plane face"))
        limits.check_lengths([("radius", self.radius)], half_width, limits.FAR)
        if (1 + self.conic) * (rim / self.radius) ** 2 > 1 + 1e-12:
            raise Refused(
                "radius",
                Message(
                    "{radius:g} ends within the {optic}; more than {least:g} in size",
                    radius=self.radius,
                    optic=called,
                    least=rim * math.sqrt(1 + self.conic),
                ),
            )


FixedFace = PlaneFace | ConicFace
