"""The kinds of receivers: planes and far fields."""

import math
from itertools import product
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field, PrivateAttr

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT, full_size
from workbench.messages import Message, Stated
from workbench.powers import rounded
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.fields import ANGLE, LENGTH, PLACE, about
from workbench.scene.part import Kinds, Positive
from workbench.scene.receiver import AnyReceiver, Pixels
from workbench.scene.turning import Place, Tilt, tilt_of, tilted

if TYPE_CHECKING:
    from workbench.scene.task import Scene

# Light that falls along a plane is taken to meet it this steeply.
_GRAZING = 1e-3
# What comes nearer to the plane of the element than this part of the screen's half diagonal is
# beside it: perspective on a plane across the axis would be endless.
_BESIDE = 0.1
# A new screen stands this many half-widths behind the lens, and is seen within so many radians.
_DISTANCE, _WIDEST = 10.0, 1.3


class Screen(AnyReceiver):
    """Rectangle of a plane. Its coordinates go along its sides, from its middle."""

    model_config = ConfigDict(title="Plane")

    measure = LENGTH
    extent = "half_width"
    axes = "x", "y"
    called = "screen"
    place = "on the screen"
    density = "irradiance"
    at_distance = True
    facets = 1

    kind: Literal["plane"] = "plane"
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "Where the middle of the plane stands: x, y and z."),
    ]
    tilt: Annotated[
        Tilt,
        about(
            "Tilt",
            "How the plane is turned about its middle: about its x, which takes its upper edge "
            "away from or towards the lens, then about its new y, then about its new z. Rows and "
            "columns turn with it.",
        ),
    ] = (0.0, 0.0, 0.0)
    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        full_size("Full width and height of the screen. The target fills it."),
        about("Half width", "Half of the screen's extent along x and y. The target fills it."),
    ]
    pixels: Pixels
    _either_side: bool = PrivateAttr(default=False)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Some widths of the lens away from it, as wide as the receiver that is there looks."""
        receiver, optic = scene.receiver, scene.optic
        away = rounded(_DISTANCE * max(optic.half_width), 3)
        wide = zip(receiver.half_extent, receiver.per_radian(optic.leaving_z), strict=True)
        half = tuple(rounded(away * math.tan(min(r / far, _WIDEST)), 3) for r, far in wide)
        z = rounded(optic.leaving_z + optic.onwards * away, 6)
        return {"position": (0.0, 0.0, z), "half_width": half, "pixels": receiver.pixels}

    @property
    def stands_at(self) -> Array:
        """Its position."""
        return np.array(self.position)

    def seen(self, place: Array | None, turn: Array, magnification: float) -> Self:
        """See `AnyReceiver.seen`; light may come from behind, as to an image in a mirror."""
        x, y, z = self.position if place is None else place.tolist()
        tilt = self.tilt
        if not np.array_equal(turn, self.sides.T):
            turn = np.column_stack([turn[:, :2], np.cross(turn[:, 0], turn[:, 1])])
            tilt = tilt_of(turn)
        r_x, r_y = (magnification * r for r in self.half_width)
        changes = {"position": (x, y, z), "tilt": tilt, "half_width": (r_x, r_y)}
        copy = self.model_copy(update=changes)
        copy._either_side = True
        return copy

    @property
    def z(self) -> float:
        """Z of its middle, scene units."""
        return self.position[2]

    @property
    def center(self) -> tuple[float, float]:
        """Where its middle is beside the axis, scene units."""
        return self.position[:2]

    @property
    def sides(self) -> Array:
        """Unit vectors along its x and y, and across it, turned from +z, as rows (3, 3)."""
        return tilted(self.tilt).T

    @property
    def upright(self) -> bool:
        """Whether its rows and columns are those of the scene."""
        return not any(self.tilt)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where its middle is in that plane, and it is turned about an axis across it."""
        (x, y), (about_x, about_y, about_z) = self.center, self.tilt
        return x == about_y == about_z == 0, y == about_x == about_z == 0

    def towards(
        self, optic: Element, place: tuple[Array, Array, Array], u: Array, v: Array
    ) -> tuple[Array, ...]:
        """Along lines."""
        right, up, _ = self.sides
        parts = zip(self.position, right, up, place, strict=True)
        way = [to + u * a + v * b - at for to, a, b, at in parts]
        length = np.sqrt(way[0] ** 2 + way[1] ** 2 + way[2] ** 2)
        return tuple(part / length for part in way)

    def perspective(self, optic: Element) -> Array:
        """From the middle of the face that light leaves; its own coordinates if it is beside it."""
        right, up, _ = self.sides
        seen = np.stack([right, up, np.array(self.position) - [0.0, 0.0, optic.leaving_z]], axis=1)
        seen[2] *= optic.onwards
        (r_x, r_y), (lean_x, lean_y, away) = self.half_width, seen[2]
        beside = away - abs(lean_x) * r_x - abs(lean_y) * r_y < _BESIDE * np.hypot(*self.half_width)
        return np.eye(3) if self.upright or beside else seen

    def slant(self, optic: Element) -> float:
        """At its corners, from the middle of the face that light leaves."""
        (r_x, r_y), (right, up, across) = self.half_width, self.sides
        way = np.array(self.position) - [0.0, 0.0, optic.leaving_z]
        corners = [way + x * r_x * right + y * r_y * up for x, y in product((-1, 1), repeat=2)]
        cosines = [abs(across @ corner) / math.hypot(*corner) for corner in corners]
        return math.degrees(math.acos(min(1.0, *cosines)))

    def drawn(self, optic: Element, u: Array, v: Array) -> Array:
        """Where they are."""
        right, up, _ = self.sides
        return np.asarray(np.array(self.position) + u[..., None] * right + v[..., None] * up)

    @property
    def pixel_measure(self) -> float:
        """Area of one pixel, scene units squared."""
        return 4 * math.prod(self.half_width) / math.prod(self.pixels)

    def total(self, density: Array) -> float:
        """Flux of an image (n_y, n_x) of irradiance."""
        return float(density.sum()) * self.pixel_measure

    def nearest_to(self, optic: Element) -> float:
        """The lowest edge; of one below that leans none, as it may be beside the element."""
        if optic.onwards < 0:
            return self.z if self.upright else -math.inf
        (right, up, _), (r_x, r_y) = self.sides, self.half_width
        return float(self.z - r_x * abs(right[2]) - r_y * abs(up[2]))

    def per_radian(self, z: float) -> tuple[float, float]:
        """How far from there its middle is, and more along a side that leans away."""
        way = self.stands_at - [0.0, 0.0, z]
        far = math.hypot(*way)
        across = max(abs(float(self.sides[2] @ way)), _GRAZING * far)
        along_x, along_y = (far * math.hypot(1.0, lean / across) for lean in self.lean(z))
        return along_x, along_y

    def lean(self, z: float) -> tuple[float, float]:
        """Rounding of that way moves light by as great a part of this."""
        right, up, _ = self.sides
        way = self.stands_at - [0.0, 0.0, z]
        return abs(float(right @ way)), abs(float(up @ way))

    def check_lengths(self, half_width: tuple[float, float]) -> None:
        """Refuse a screen that is too far, too wide or too far aside."""
        lengths = [(f"position[{k}]", place) for k, place in enumerate(self.position)]
        lengths += [(f"half_width[{k}]", r) for k, r in enumerate(self.half_width)]
        limits.check_lengths(lengths, half_width, limits.FAR)

    def check_lit_by(self, optic: Element) -> None:
        """Refuse an element that may touch it, or that is behind it."""
        (r_x, r_y), ends = optic.half_width, (optic.lowest, optic.highest)
        corners = np.array(list(product((-r_x, r_x), (-r_y, r_y), ends)))
        before = optic.onwards * ((self.stands_at - corners) @ self.across) > 0
        behind = self._either_side and not before.any()
        if not self.upright and not before.all() and not behind:
            raise Refused(
                "tilt",
                Message(
                    "{tilt} turns the back of the screen to light of the {optic}; its "
                    "front has to face all of the {optic}",
                    tilt="[{}]".format(", ".join(f"{angle:g}" for angle in self.tilt)),
                    optic=optic.called,
                ),
            )
        if optic.onwards < 0:
            self._check_below(optic)
            return
        nearest = self.nearest_to(optic)
        if nearest <= optic.highest:
            places = {"z": self.z, "nearest": nearest, "least": optic.highest + (self.z - nearest)}
            raise Refused(
                "position[2]",
                Message(
                    "{z:g} may touch the lens; more than {least:g}, the highest that the exit "
                    "face can become",
                    **places,
                )
                if self.upright
                else Message(
                    "{z:g} puts its lowest edge at z = {nearest:g}, which may touch the lens; more "
                    "than {least:g}, the highest that the exit face can become and the tilt adds",
                    **places,
                ),
            )

    def _check_below(self, optic: Element) -> None:
        """Refuse an element whose light does not go up to it; one that leans may be beside it."""
        if self.z >= optic.lowest and self.upright:
            raise Refused(
                "position[2]",
                Message(
                    "{z:g} may touch the {optic}, or be behind it; less than {most:g}, the lowest "
                    "that it can become",
                    z=self.z,
                    optic=optic.called,
                    most=optic.lowest,
                ),
            )


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
        full_size("Full angles that it covers across and upwards. The target fills it."),
        about(
            "Half angle",
            "Half of the angles that it covers to the right and upwards. The target fills it.",
        ),
    ]
    center: Annotated[
        tuple[_Angle, _Angle],
        ANGLE,
        PLACE,
        EXPERT,
        about("Centre", "Its middle: angle to the right and angle upwards from the optical axis."),
    ] = (0.0, 0.0)
    pixels: Pixels
    _turn: tuple[tuple[float, ...], ...] | None = PrivateAttr(default=None)

    @property
    def turn(self) -> Array | None:
        """See `AnyReceiver.turn`."""
        return None if self._turn is None else np.array(self._turn)

    @property
    def stands_at(self) -> None:
        """Nowhere."""

    def seen(self, place: Array | None, turn: Array, magnification: float) -> Self:
        """See `AnyReceiver.seen`."""
        copy = self.model_copy()
        copy._turn = tuple(map(tuple, turn.tolist()))
        return copy

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """As wide as the receiver that is there looks from the lens."""
        receiver = scene.receiver
        wide = zip(receiver.half_extent, receiver.per_radian(scene.optic.leaving_z), strict=True)
        half = tuple(rounded(math.degrees(math.atan(r / far)), 3) for r, far in wide)
        return {"half_angle": half, "pixels": receiver.pixels}

    def check_receiver(self) -> None:
        """Refuse angles beyond 90 degrees, where light goes back."""
        for axis, (half, middle) in enumerate(zip(self.half_angle, self.center, strict=True)):
            if half + abs(middle) > _MOST:
                raise Refused(
                    f"half_angle[{axis}]",
                    Message(
                        "{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}",
                        half=Stated(half),
                        middle=middle,
                        most=_MOST,
                        left=Stated(_MOST - abs(middle)),
                    ),
                )

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
        return np.asarray(np.cos(v + rows * (math.radians(self.half_angle[1]) / n_y)))[:, None]

    def from_middle(self, u: Array, v: Array) -> Array:
        """The angles between their directions and that of the middle."""
        (mid_h, mid_v), h, v = np.radians(self.middle), np.radians(u), np.radians(v)
        # Of half the chord, as the cosine of small angles loses its digits.
        across = np.cos(v) * np.cos(mid_v) * np.sin((h - mid_h) / 2) ** 2
        square = across + np.sin((v - mid_v) / 2) ** 2
        return np.asarray(np.degrees(2 * np.arcsin(np.sqrt(square))))

    def towards(
        self, optic: Element, place: tuple[Array, Array, Array], u: Array, v: Array
    ) -> tuple[Array, ...]:
        """The same from everywhere."""
        return tuple(np.moveaxis(self._direction(optic, u, v), -1, 0))

    def drawn(self, optic: Element, u: Array, v: Array) -> Array:
        """On a sphere around the place that light leaves."""
        far = self.radius(optic) * self._direction(optic, u, v)
        return np.asarray(np.array([0.0, 0.0, optic.leaving_z]) + far)

    @staticmethod
    def radius(optic: Element) -> float:
        """Of the sphere on which it is drawn, scene units."""
        return _RADIUS * max(optic.half_width)

    def nearest_to(self, optic: Element) -> float:
        """It is infinitely far."""
        return optic.onwards * math.inf

    def per_radian(self, z: float) -> tuple[float, float]:
        """The same from everywhere."""
        return math.degrees(1 / math.cos(math.radians(self.center[1]))), math.degrees(1)

    def _direction(self, optic: Element, h: Array, v: Array) -> Array:
        """Unit vectors of angles of light that leaves an element, in degrees, shape (..., 3)."""
        h, v = np.radians(h), np.radians(v)
        onwards = optic.onwards if self.turn is None else 1
        parts = np.cos(v) * np.sin(h), np.sin(v), onwards * np.cos(v) * np.cos(h)
        way = np.stack(np.broadcast_arrays(*parts), axis=-1)
        return way if self.turn is None else way @ self.turn.T


Receiver = Annotated[Screen | FarField, Kinds("kind")]
