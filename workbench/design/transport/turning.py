"""Slopes of faces that deflect light, as far as a face can.

A face of glass deflects light by less than 90° less the critical angle, θ_c = arcsin(1/n), and
reflects most of what it deflects by nearly as much. From a direction a, the directions within reach
are a cone about a. Light that should go beyond is sent to the nearest direction of that cone, which
lies between a and the one that is wanted: it lands where a face can send it, and gets a gradient
there. Light that is totally reflected has none.
"""

import math
from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.cells import Pair, Vector
from workbench.geometry.reach import incidence, largest_turn
from workbench.optics.interfaces import Law, TransmittanceLaw, laws_of
from workbench.scene import Element, Lens, Scene

# Where no face could bend the light as wanted, the normal is kept along the axis by this part of
# what it is where light goes straight on or back: n − 1, and 2 for a mirror.
_UPRIGHT = 0.1
# Part of the transmittance at normal incidence that a deflection within reach leaves.
_GOOD = 0.8
# Largest angle to the normal outside the glass, whatever it lets pass.
_GRAZING = math.radians(80)
_ANGLES = 257  # at which a transmittance is tabulated
_PARTS = np.linspace(-0.9, 0.9, 10)  # of the width of a source, even as its light


class Turning(NamedTuple):
    """What a face can do to the direction of light."""

    # Refractive indices before and behind the face; both 1 of a mirror.
    before: float
    behind: float
    upright: float  # least z of the difference of the directions times the indices
    steepest: float  # largest angle to the normal within the denser medium, radians
    law: Law  # of a mirror it has no meaning

    @classmethod
    def at_exit(cls, optic: Element) -> Self:
        """That of the face of an element that the task shapes."""
        upright = _UPRIGHT * optic.deflection
        if not isinstance(optic, Lens):
            return cls(1.0, 1.0, upright, math.inf, TransmittanceLaw.constant(1.0, 0.0))
        law = laws_of(optic)[1]
        return cls(optic.index, 1.0, upright, _steepest(law), law)

    @classmethod
    def at_entrance(cls, lens: Lens) -> Self:
        """That of the entrance face of a lens."""
        law = laws_of(lens)[0]
        return cls(1.0, lens.index, _UPRIGHT * abs(lens.index - 1), _steepest(law), law)

    def passing(self, turn: Array, spread: Array | float = 0.0) -> Array:
        """Part of the light that the face lets pass by its deflection, radians.

        `spread`: half the angle, in the denser medium, of the light that is turned all together.
        """
        index = max(self.before, self.behind)
        possible = turn < largest_turn(index)
        inside = incidence(np.where(possible, turn, 0.0), index)
        off = np.expand_dims(_PARTS, tuple(range(1, 1 + inside.ndim))) * spread
        part = _transmitted(self.law, abs(inside + off)).mean(axis=0)
        return np.where(possible, part, 0.0)

    def slopes(self, coming: Vector, going: Vector) -> Pair:
        """Slopes along x and y of a face that turns light, by Snell's law as vectors.

        The normal is along n a − m b, from before and behind the face; of a mirror, both are 1.
        """
        sign = 1.0 if self.behind > self.before else -1.0
        x, y, z = (
            sign * (self.behind * b - self.before * a) for a, b in zip(coming, going, strict=True)
        )
        z = np.maximum(z, self.upright)
        return -x / z, -y / z

    def largest(self, spread: Array | float = 0.0) -> Array:
        """Largest deflections within reach, radians.

        `spread`: half the angle, in the denser medium, of light that is turned all together.
        """
        index = max(self.before, self.behind)
        inside = np.minimum(self.steepest, np.maximum(math.asin(1 / index) - spread, 0.0))
        return np.asarray(np.arcsin(np.minimum(index * np.sin(inside), 1.0)) - inside)

    def beyond(self, coming: Vector, going: Vector, spread: Array | float = 0.0) -> Array:
        """By how much deflections exceed the reach of the face, radians; at most 0 within it."""
        if math.isinf(self.steepest):
            return np.full_like(going[2], -math.inf)
        cosine = sum(a * b for a, b in zip(coming, going, strict=True))
        return np.asarray(np.arccos(np.clip(cosine, -1, 1)) - self.largest(spread))

    def reached(self, coming: Vector, going: Vector, spread: Array | float = 0.0) -> Vector:
        """The directions behind the face, or the nearest ones within its reach."""
        over = self.beyond(coming, going, spread) > 0
        if not over.any():
            return going
        most = self.largest(spread)
        cosine = sum(a * b for a, b in zip(coming, going, strict=True))
        sine = np.sqrt(np.maximum(1 - cosine**2, np.finfo(float).tiny))
        x, y, z = (
            np.where(over, np.cos(most) * a + np.sin(most) * (b - cosine * a) / sine, b)
            for a, b in zip(coming, going, strict=True)
        )
        return x, y, z


def _steepest(law: Law) -> float:
    """Largest angle in the denser medium at which a face lets enough light pass, radians."""
    index = max(law.ratio, 1 / law.ratio)
    most = math.asin(math.sin(_GRAZING) / index)
    inside = np.linspace(0, most, _ANGLES)
    part = _transmitted(law, inside)
    return float(inside[part >= _GOOD * part[0]].max())


def _transmitted(law: Law, inside: Array) -> Array:
    """Part of the light that passes, by its angle to the normal in the denser medium, radians."""
    index = max(law.ratio, 1 / law.ratio)
    square = 1 - (index * np.sin(inside)) ** 2
    cosines = np.cos(inside), np.sqrt(np.maximum(square, 0.0))
    cos_in, cos_out = cosines if law.ratio > 1 else cosines[::-1]
    return np.where(square > 0, law.at(cos_in, cos_out), 0.0)


def half_angle(scene: Scene) -> float:
    """Half of the angle at which the middle of a lens sees its source, radians."""
    optic, receiver = scene.optic, scene.receiver
    widths = zip(
        scene.source.blur(optic, receiver), receiver.per_radian(optic.leaving_z), strict=True
    )
    return max(math.atan(blur / moved / 2) for blur, moved in widths)
