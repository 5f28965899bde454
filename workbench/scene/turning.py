"""Places and rotations: tilts of elements, receivers and lamps, and of collimated light."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import numpy as np
from pydantic import Field

from workbench.arrays import Array
from workbench.levels import EXPERT
from workbench.scene.fields import ANGLE, PLACE

Place = tuple[float, float, float]
_Angle = Annotated[float, Field(ge=-180, le=180)]
Tilt = Annotated[tuple[_Angle, _Angle, _Angle], ANGLE, PLACE, EXPERT]

# Parts of unit vectors below this are rounding.
_ROUNDING = 1e-14


class Standing:
    """What stands somewhere in the scene, with coordinates of its own."""

    if TYPE_CHECKING:  # fields of the part
        position: Place
        tilt: Place

    @property
    def upright(self) -> bool:
        """Whether it stands upright on the axis z of the scene."""
        return not any(self.tilt) and not any(self.position[:2])

    @property
    def turn(self) -> Array:
        """Its unit vectors in the scene, as the columns of a matrix (3, 3)."""
        return tilted(self.tilt)

    @property
    def origin(self) -> Array:
        """Where its own coordinates begin in the scene, shape (3,).

        Control heights, `placed_faces` and all other z of an element are counted from there along
        its own z: ``position[2]`` is the z of its front vertex, however it stands. So they are z of
        the scene where it stands upright.
        """
        return np.array(self.position) - self.position[2] * self.turn[:, 2]

    def seen(self, places: Array) -> Array:
        """Return places (..., 3) of the scene in its own coordinates, see `origin`."""
        return places if self.upright else np.asarray((places - self.origin) @ self.turn)

    def in_scene(self, places: Array) -> Array:
        """Return places (..., 3) in its own coordinates as places of the scene."""
        return places if self.upright else np.asarray(places @ self.turn.T + self.origin)


def turned(about: tuple[float, float]) -> Array:
    """The matrix (3, 3) of a turn; its columns are where it takes x, y and z.

    `about`: degrees about x and about y, as a rotation vector: their root sum of squares is the
    angle between the axis z before and after it.

    Notes
    -----
    Rodrigues' formula, 1 + sin(a) K + (1 − cos(a)) K² with the cross product K of its axis.
    """
    angle = math.hypot(*about)
    if angle == 0:
        return np.eye(3)
    x, y = (part / angle for part in about)
    cross = np.array([[0.0, 0.0, y], [0.0, 0.0, -x], [-y, x, 0.0]])
    radians = math.radians(angle)
    turn = math.sin(radians) * cross + (1 - math.cos(radians)) * cross @ cross
    return np.asarray(np.eye(3) + turn)


def tilted(tilt: Sequence[float]) -> Array:
    """Return the matrix (3, 3) R_x(a) R_y(b) R_z(c) of a tilt (a, b, c) in degrees.

    An element is turned about its own x, then about its new y, then about its new z.
    """
    turn = np.eye(3)
    for axis, degrees in enumerate(tilt):
        if degrees:
            turn = turn @ _about(axis, math.radians(degrees))
    return turn


def tilt_of(turn: Array) -> tuple[float, float, float]:
    """Return the tilt in degrees of a rotation matrix (3, 3): the inverse of `tilted`."""
    b = math.asin(min(max(float(turn[0, 2]), -1.0), 1.0))
    a = math.atan2(-turn[1, 2], turn[2, 2])
    c = math.atan2(-turn[0, 1], turn[0, 0])
    degrees = (math.degrees(angle) + 0.0 for angle in (a, b, c))
    x, y, z = degrees
    return x, y, z


def proper(turn: Array) -> Array:
    """Return a matrix (3, 3) of unit vectors without reflection: of a mirror image, x is flipped.

    Exact where it differs from another axis by rounding.
    """
    turn = np.where(np.abs(turn) < _ROUNDING, 0.0, turn)
    turn = np.where(np.abs(np.abs(turn) - 1) < _ROUNDING, np.sign(turn), turn)
    return turn if np.linalg.det(turn) > 0 else np.asarray(turn * [-1.0, 1.0, 1.0])


def _about(axis: int, radians: float) -> Array:
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[i, i] = turn[j, j] = math.cos(radians)
    turn[j, i], turn[i, j] = math.sin(radians), -math.sin(radians)
    return turn
