"""What the face of an optic begins with, and its heights are counted from."""

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
import numpy.typing as npt
from pydantic import ConfigDict

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.said import Said
from workbench.scene import limits
from workbench.scene.fields import LENGTH, about
from workbench.scene.kinds import Kinds
from workbench.scene.part import Part, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_BaseHeight = Annotated[
    float, LENGTH, about("Base at z", "Where the base crosses the optical axis.")
]


class FlatBase(Part):
    """A plane across the axis."""

    model_config = ConfigDict(title="Flat")

    shape: Literal["flat"] = "flat"
    height: _BaseHeight

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        x, y = np.broadcast_arrays(x, y)
        return np.full(x.shape, self.height)

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        return self.height, self.height

    def check_within(self, called: str, half_width: tuple[float, float]) -> None:
        """Refuse nothing: it suits any lens or mirror."""


class SphereBase(Part):
    """A spherical cap that rises or falls towards the rim."""

    model_config = ConfigDict(title="Sphere")

    shape: Literal["sphere"] = "sphere"
    height: _BaseHeight
    radius: Annotated[
        Positive,
        LENGTH,
        about(
            "Base radius",
            "Radius of curvature of the base; more than the half-diagonal of the lens or mirror.",
        ),
    ]
    form: Annotated[
        Literal["concave", "convex"],
        about("Base form", "Concave rises towards the rim, convex falls."),
    ] = "concave"

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Shallow enough for any lens or mirror that a flat base was good for."""
        return {"radius": float(f"{10 * math.hypot(*scene.optic.half_width):.2g}")}

    def height_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Height f(x, y) of the base, scene units; x and y broadcast."""
        r2 = np.square(x) + np.square(y)
        # R − √(R² − r²) without the cancellation of two large numbers.
        sag = r2 / (self.radius + np.sqrt(self.radius**2 - r2))
        return np.asarray(self.height + (sag if self.form == "concave" else -sag))

    def extent(self, half_width: tuple[float, float]) -> tuple[float, float]:
        """Lowest and highest value over the aperture."""
        rim = float(self.height_at(*half_width))
        return min(rim, self.height), max(rim, self.height)

    def check_within(self, called: str, half_width: tuple[float, float]) -> None:
        """Refuse a radius that is no number beside the lens or mirror, or does not span it."""
        path = f"{called}.base.radius"
        limits.check_lengths([(path, self.radius)], half_width, limits.FAR)
        if self.radius <= math.hypot(*half_width):
            raise Refused(
                path,
                Said(
                    "{radius:g} does not span the {optic}; more than its half-diagonal {least:g}",
                    radius=self.radius,
                    optic=called,
                    least=math.hypot(*half_width),
                ),
            )


Base = Annotated[FlatBase | SphereBase, Kinds("shape", default="flat")]
