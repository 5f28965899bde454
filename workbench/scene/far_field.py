"""The far field: where light is wanted by its direction alone."""

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.fields import ANGLE, PLACE, about
from workbench.scene.receiver import AnyReceiver, Pixels

if TYPE_CHECKING:
    from workbench.scene.element import Element
    from workbench.scene.task import Scene

# Of the sphere on which it is drawn, in half-widths of the lens.
_RADIUS = 6.0
_MOST = 90.0  # degrees; light beyond goes back
_HalfAngle = Annotated[float, Field(ge=1e-6, le=_MOST)]
_Angle = Annotated[float, Field(gt=-_MOST, lt=_MOST)]


class FarField(AnyReceiver):
    """Directions of the light that leaves the lens, as if a screen were infinitely far.

    H is the angle to the right, atan2(d_x, |d_z|), and V the one upwards, asin(d_y).
    """

    model_config = ConfigDict(title="Far field")

    measure = ANGLE
    extent = "half_angle"
    axes = "H", "V"
    called = "far field"
    place = "in the far field"
    density = "intensity"
    at_distance = False
    facets = 24

    kind: Literal["far_field"] = "far_field"
    half_angle: Annotated[
        tuple[_HalfAngle, _HalfAngle],
        ANGLE,
        about(
            "Half angle",
            "Half of the angles that it covers to the right and upwards. The target fills it.",
        ),
    ]
    center: Annotated[
        tuple[_Angle, _Angle],
        ANGLE,
        PLACE,
        about("Centre", "Its middle: angle to the right and angle upwards from the optical axis."),
    ] = (0.0, 0.0)
    pixels: Pixels
    _turn: tuple[tuple[float, ...], ...] | None = PrivateAttr(default=None)

    @property
    def turn(self) -> Array | None:
        """See `AnyReceiver.turn`."""
        return None if self._turn is None else np.array(self._turn)

    def standing(self, turn: Array) -> Self:
        """Return the same directions in other coordinates.

        `turn` (3, 3): its unit vectors there as columns, the last of which goes with the light.
        """
        copy = self.model_copy()
        copy._turn = tuple(map(tuple, turn.tolist()))
        return copy

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """As wide as the receiver that is there looks from the lens."""
        receiver = scene.receiver
        wide = zip(receiver.half_extent, receiver.per_radian(scene.optic.leaving_z), strict=True)
        half = tuple(float(f"{math.degrees(math.atan(r / far)):.3g}") for r, far in wide)
        return {"half_angle": half, "pixels": receiver.pixels}

    def check_receiver(self) -> None:
        """Refuse angles beyond 90 degrees, where light goes back."""
        for axis, (half, middle) in enumerate(zip(self.half_angle, self.center, strict=True)):
            if half + abs(middle) > _MOST:
                raise Refused(
                    f"half_angle[{axis}]",
                    Message(
                        "{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}",
                        half=half,
                        middle=middle,
                        most=_MOST,
                        left=_MOST - abs(middle),
                    ),
                )

    @property
    def half_extent(self) -> tuple[float, float]:
        """Its half angles."""
        return self.half_angle

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle."""
        return self.center

    @property
    def pixel_measure(self) -> Array:
        """Solid angle of a pixel in each row, steradians, shape (n_y, 1)."""
        across, height = (
            2 * math.radians(r) / n for r, n in zip(self.half_angle, self.pixels, strict=True)
        )
        # As a product: differences of nearly equal sines lose their digits.
        return across * 2 * math.sin(height / 2) * self._cosines()

    def relative_measure(self, margin: int = 0) -> Array:
        """As the cosines of V."""
        return np.asarray(self._cosines(margin) / self._cosines().mean())

    @property
    def farthest(self) -> tuple[float, float]:
        """As far as light goes onwards."""
        h, v = self.center
        return _MOST - abs(h), _MOST - abs(v)

    def _cosines(self, margin: int = 0) -> Array:
        """Of V in the middle of each row."""
        n_y, v = self.pixels[1], math.radians(self.center[1])
        rows = n_y - 1 - 2 * np.arange(-margin, n_y + margin)
        cosines: Array = np.cos(v + rows * (math.radians(self.half_angle[1]) / n_y))
        return cosines[:, None]

    @property
    def plane_z(self) -> float:
        """None: refused."""
        raise Refused("receiver", Message("is at no distance; a screen is needed"))

    def moved_to(self, z: float) -> "FarField":
        """Refused."""
        raise Refused("receiver", Message("is at no distance; a screen is needed"))

    def towards(
        self, optic: "Element", place: tuple[Array, Array, Array], u: Array, v: Array
    ) -> tuple[Array, ...]:
        """The same from everywhere."""
        return tuple(np.moveaxis(self._direction(optic, u, v), -1, 0))

    def drawn(self, optic: "Element", u: Array, v: Array) -> Array:
        """On a sphere around the place that light leaves."""
        around = np.array([0.0, 0.0, optic.leaving_z])
        return np.asarray(around + self.radius(optic) * self._direction(optic, u, v))

    @staticmethod
    def radius(optic: "Element") -> float:
        """Of the sphere on which it is drawn, scene units."""
        return _RADIUS * max(optic.half_width)

    def nearest_to(self, optic: "Element") -> float:
        """It is infinitely far."""
        return optic.onwards * math.inf

    def per_radian(self, z: float) -> tuple[float, float]:
        """The same from everywhere."""
        degrees = math.degrees(1)
        return degrees / math.cos(math.radians(self.center[1])), degrees

    def check_lit_by(self, optic: "Element") -> None:
        """Refuse nothing: light of any optic has a direction."""

    def _direction(self, optic: "Element", h: Array, v: Array) -> Array:
        """Unit vectors of angles of light that leaves an optic, in degrees, shape (..., 3)."""
        h, v = np.radians(h), np.radians(v)
        onwards = optic.onwards if self.turn is None else 1
        parts = np.broadcast_arrays(
            np.cos(v) * np.sin(h), np.sin(v), onwards * np.cos(v) * np.cos(h)
        )
        way = np.stack(parts, axis=-1)
        return way if self.turn is None else way @ self.turn.T
