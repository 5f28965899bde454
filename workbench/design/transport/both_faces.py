"""Fits both faces of a lens to the ways that light shall take in it and behind it.

Snell's law says what slopes turn light so, at the places that it meets, and least squares find the
faces. The exit face comes second, and mends with the light that the entrance face really sends what
that could not do. A goal says the ways; see `workbench.design.transport.two_faces` and
`workbench.design.transport.lines`.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.faces import UPRIGHT
from workbench.design.transport.start import FEW_ROUNDS, wanted_cells
from workbench.design.transport.two_face_light import LightInLens, TwoFaceLight
from workbench.geometry.faces import NO_FACES
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.progress import check_interruption
from workbench.scene import Scene, WantedImage

Vector = tuple[Array, Array, Array]

# Cells along each axis, of lens and screen alike; finer nets get more. Each is a ray to follow.
_CELLS = 128
# Rounds of transport, each with light that knows more of the lens.
_ROUNDS = 3
# What is left of the bending at the entrance face in each trial after one whose face did not fit
# between its limits.
_LESS, _TRIALS = 0.9, 4


class Goal(Protocol):
    """Ways for the light of each cell; vectors of three arrays of shape (cells, cells)."""

    def in_glass(self, coming: Vector, traced: LightInLens) -> Callable[[float], Vector]:
        """Ways between the faces, by how much of the bending the entrance face does."""
        ...

    def behind(self, traced: LightInLens) -> Vector:
        """Unit vectors of the ways behind the lens."""
        ...


class BothFaces:
    """Finds both faces of a lens.

    `scene`: with a lens of two freeform faces; an extended source counts as a point at its centre;
    `fixed` (n_u, n_v): control heights of a face that is what it is, by its name, scene units.
    """

    def __init__(self, scene: Scene, fixed: Mapping[str, Array] = NO_FACES) -> None:
        nets = freeform_nets(scene.optic)
        self._index, self._limits = scene.optic.index, HeightLimits.of_faces(bounded(scene))
        self._cells = cells_for(nets)
        self._fits = {face: SlopeFit(net, self._cells) for face, net in nets.items()}
        self._light = TwoFaceLight(scene, self._fits, self._cells)
        self._plate = {
            face: np.full(net.shape, float(self._limits[face].undesigned.mean()))
            for face, net in nets.items()
        }
        self._fixed = fixed
        self._front, self._back = nets
        x, y = nets[self._back].positions
        base = scene.optic.base.height_at(x[:, None], y[None, :])
        self._thickness = float(base.mean()) - scene.optic.datum

    def heights(
        self,
        images: Sequence[WantedImage],
        goal_of: Callable[[Sequence[Transport]], Goal],
        fraction: float,
        fits: int,
    ) -> dict[str, Array] | None:
        """Control heights of a lens whose light goes where transports to images say.

        `images`: each gets a transport; `goal_of`: makes of these the ways that light shall take;
        `fraction`: how much of the bending the entrance face does at the most; `fits`: pairs of
        faces in each round of transport. Returns (n_u, n_v): by the names of the faces, scene
        units; those of the exit face beyond their limits where these are too narrow. None if no
        light leaves a plate.
        """
        heights = {**self._plate, **self._fixed}
        traced = self._light.through(heights)
        if traced.flux is None:
            return None
        transports = [
            Transport(traced.flux, *wanted_cells(each.scene, each.target, self._cells), FEW_ROUNDS)
            for each in images
        ]
        for number in range(_ROUNDS):
            if number:
                traced = self._light.through(heights)
                # A lens that no light leaves is improved blindly.
                if traced.flux is not None:
                    rounds = FEW_ROUNDS if number + 1 < _ROUNDS else MOST_ROUNDS
                    for transport in transports:
                        transport.improve(traced.flux, rounds)
            goal = goal_of(transports)
            for fit in range(fits):
                check_interruption()
                if fit:
                    traced = self._light.through(heights)
                entrance = self._entrance(traced, goal, fraction)
                traced = self._light.through({**heights, self._front: entrance})
                heights = {
                    self._front: entrance,
                    self._back: self._exit(traced, goal, entrance),
                }
        return heights

    def _entrance(self, traced: LightInLens, goal: Goal, fraction: float) -> Array:
        """The entrance face that bends light by a part, or by less where that does not fit."""
        if self._front in self._fixed:
            return self._fixed[self._front]
        coming, limits = self._light.coming, self._limits[self._front]
        way = goal.in_glass(coming, traced)
        for _ in range(_TRIALS):
            slopes = _slopes(coming, unit(way(fraction)), 1.0, self._index)
            slopes = self._light.evenly(slopes, self._front, traced.entrance)
            heights = self._fits[self._front].heights(*slopes)
            lacks = limits.lacks(heights)
            if lacks <= 0:
                return limits.placed(heights)
            extent = float(np.ptp(heights))
            fraction *= _LESS * (extent - lacks) / extent
        return limits.nearest(heights)

    def _exit(self, traced: LightInLens, goal: Goal, entrance: Array) -> Array:
        """The exit face that turns light into its way behind the lens.

        It rises with the entrance face where glass would be thinner than between their places: the
        thinner it is, the more both faces have to bend the light to move it as far.
        """
        if self._back in self._fixed:
            return self._fixed[self._back]
        slopes = _slopes(traced.glass, goal.behind(traced), self._index, 1.0)
        heights = self._fits[self._back].heights(
            *self._light.evenly(slopes, self._back, traced.exit)
        )
        between = float(self._plate[self._back].mean() - entrance.mean())
        return self._limits[self._back].placed(heights, max(self._thickness - between, 0.0))


def cells_for(nets: Mapping[str, ControlNet]) -> int:
    """Cells along each axis of a first lens on the nets of its faces."""
    return max(_CELLS, 2 * max(max(net.shape) for net in nets.values()))


def _slopes(before: Vector, behind: Vector, index: float, other: float) -> tuple[Array, Array]:
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
