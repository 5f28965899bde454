"""A first lens of two faces that share the bending of the light.

As in `workbench.design.transport.start`, but light is followed from cells of the plane before the
lens. In the glass it takes a direction between where it comes from and where it should go.
Collimated light is turned by 1/(2n) of the way, which takes equal slopes of both faces where these
are small. That of near points is turned by most of the way: what would be turned later leaves
through the side before it comes to the exit face. Snell's law says what slopes that takes, at the
places that the light meets, and least squares find the faces. The exit face comes second, and mends
with the light that the entrance face really sends what that could not do.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.start import (
    FEW_ROUNDS,
    UPRIGHT,
    destinations,
    wanted_cells,
)
from workbench.design.transport.two_face_light import LightInLens, TwoFaceLight
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

Array = npt.NDArray[np.float64]
Vector = tuple[Array, Array, Array]

# Cells along each axis, of lens and screen alike; finer nets get more. Each is a ray to follow.
CELLS = 128
# Rounds of transport, each with light that knows more of the lens; and of faces in each.
_ROUNDS, _FITS = 3, 2
# The part of the way by which light of near points is turned at the entrance face. Half of it would
# be by equal angles. A point 14 mm before a round lens of 50 mm, entrance face with 12 mm of room:
#
# | part | error after 50 steps | lands on the screen of what meets the lens |
# |---|---|---|
# | flat entrance face | 13.3 % | 64 % |
# | 0.6 | 6.0 % | 72 % |
# | 0.7 | 2.8 % | 79 % |
# | 0.85 | 2.9 % | 85 % |
_NEAR_PART = 0.85
# What is left of the bending at the entrance face in each trial after one whose face did not fit
# between its limits.
_LESS, _TRIALS = 0.9, 4


def split_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """Control heights of both faces of a first lens.

    Parameters
    ----------
    scene : Scene
        The design task; an extended source counts as a point at its centre.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.

    Returns
    -------
    dict of str to ndarray, shape (n_u, n_v), or None
        Heights by the names of the faces, scene units; those of the exit face beyond their limits
        where these are too narrow for the task. None if no light leaves a plate.
    """
    nets, limits = freeform_nets(scene.optic), HeightLimits.of_faces(bounded(scene))
    cells = max(CELLS, 2 * max(max(net.shape) for net in nets.values()))
    light = TwoFaceLight(scene, cells)
    heights = {
        face: np.full(net.shape, float(limits[face].undesigned.mean()))
        for face, net in nets.items()
    }
    traced = light.through(heights)
    if traced.flux is None:
        return None
    transport = Transport(traced.flux, *wanted_cells(scene, target, cells), FEW_ROUNDS)
    fits = {face: SlopeFit(net, cells) for face, net in nets.items()}
    faces = _Faces(scene, light, fits, limits)
    for number in range(_ROUNDS):
        heights = faces.bent(transport, traced, heights)
        if number + 1 < _ROUNDS:
            traced = light.through(heights)
            # A lens that no light leaves is improved blindly.
            if traced.flux is not None:
                rounds = FEW_ROUNDS if number + 2 < _ROUNDS else MOST_ROUNDS
                transport.improve(traced.flux, rounds)
    return heights


class _Faces(NamedTuple):
    """Finds faces that send light where a transport says."""

    scene: Scene
    light: TwoFaceLight
    fits: dict[str, SlopeFit]
    limits: dict[str, HeightLimits]

    def bent(
        self, transport: Transport, traced: LightInLens, heights: dict[str, Array]
    ) -> dict[str, Array]:
        """Control heights of both faces, from those of a lens like it and the light in that."""
        receiver, n = self.scene.receiver, self.scene.optic.index
        to_u, to_v = destinations(transport, receiver)
        for fit in range(_FITS):
            if fit:
                traced = self.light.through(heights)
            leaving = _three(receiver.towards(self.scene.optic, traced.exit, to_u, to_v))
            entrance = self._entrance(traced, leaving)
            traced = self.light.through({**heights, "entrance": entrance})
            leaving = _three(receiver.towards(self.scene.optic, traced.exit, to_u, to_v))
            bends = slopes(traced.glass, leaving, n, 1.0)
            bent = self.fits["exit"].heights(*self.light.evenly(bends, "exit", traced.exit))
            heights = {"entrance": entrance, "exit": self.limits["exit"].placed(bent)}
        return heights

    def _entrance(self, traced: LightInLens, leaving: Vector) -> Array:
        """The entrance face that bends light by its part, or by less where that does not fit."""
        coming, limits, n = self.light.coming, self.limits["entrance"], self.scene.optic.index
        part = 0.5 / n if self.light.collimated else _NEAR_PART
        for _ in range(_TRIALS):
            x, y, z = ((1 - part) * a + part * b for a, b in zip(coming, leaving, strict=True))
            bends = slopes(coming, unit((x, y, z)), 1.0, n)
            bends = self.light.evenly(bends, "entrance", traced.entrance)
            bent = self.fits["entrance"].heights(*bends)
            lacks = limits.lacks(bent)
            if lacks <= 0:
                return limits.placed(bent)
            extent = float(np.ptp(bent))
            part *= _LESS * (extent - lacks) / extent
        return limits.nearest(bent)


def slopes(before: Vector, behind: Vector, index: float, other: float) -> tuple[Array, Array]:
    """Slopes of a face between media of two indices that turns light, by Snell's law as vectors."""
    sign = 1.0 if other > index else -1.0
    x, y, z = (sign * (other * b - index * a) for a, b in zip(before, behind, strict=True))
    z = np.maximum(z, UPRIGHT * abs(other - index))
    return -x / z, -y / z


def unit(vector: Vector) -> Vector:
    """Vectors of length 1 along others."""
    x, y, z = vector
    length = np.sqrt(x**2 + y**2 + z**2)
    return x / length, y / length, z / length


def _three(parts: Sequence[Array]) -> Vector:
    x, y, z = parts
    return x, y, z
