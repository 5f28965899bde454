"""Fits both faces of a lens to the ways that light shall take in it and behind it.

Snell's law says what slopes turn light so, at the places that it meets, and least squares find the
faces. The exit face comes second, and mends with the light that the entrance face really sends what
that could not do. A goal says the ways; see `workbench.design.transport.two_faces` and
`workbench.design.transport.lines`.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.faces import UPRIGHT
from workbench.design.transport.start import FEW_ROUNDS, wanted_cells
from workbench.design.transport.two_face_light import LightInLens, TwoFaceLight
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.interruption import check_interruption
from workbench.scene import Scene, WantedImage

Vector = tuple[Array, Array, Array]
Heights = dict[str, Array]

# Cells along each axis, of lens and screen alike; finer nets get more. Each is a ray to follow.
_CELLS = 128
# Rounds of transport, each with light that knows more of the lens; and where one of so many times
# fewer control points along an axis, but no fewer than these, is known. With all rounds and fits on
# 960 cells first lenses of the examples *Wide angle* and *Thin plate* begin at 1.6 and 1.6 % for 6
# and 5.6 s of the processor, with two on them at 2.0 and 1.7 % for 4.9 and 2.4 s, with one at 4.2
# and 1.7 %. Lines through several images need all of them: *Photograph at two distances* ends at
# 0.88 % in place of 0.82 %.
_ROUNDS, _KNOWN_ROUNDS = 3, 2
_COARSER, _FEWEST = 4, 32
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

    Parameters
    ----------
    scene : Scene
        With a lens of two freeform faces; an extended source counts as a point at its centre.
    """

    def __init__(self, scene: Scene) -> None:
        nets = freeform_nets(scene.optic)
        self._scene, self._nets = scene, nets
        self._index, self._limits = scene.optic.index, HeightLimits.of_faces(bounded(scene))
        self._cells = cells_for(nets)
        self._fits = {face: SlopeFit(net, self._cells) for face, net in nets.items()}
        self._light = TwoFaceLight(scene, self._fits, self._cells)
        self._plate = {
            face: np.full(net.shape, float(self._limits[face].undesigned.mean()))
            for face, net in nets.items()
        }
        x, y = nets["exit"].positions
        base = scene.optic.base.height_at(x[:, None], y[None, :])
        self._thickness = float(base.mean()) - scene.optic.datum

    def heights(
        self,
        images: Sequence[WantedImage],
        goal_of: Callable[[Sequence[Transport]], Goal],
        fraction: float,
        fits: int,
    ) -> Heights | None:
        """Control heights of a lens whose light goes where transports to images say.

        Parameters
        ----------
        images : sequence of WantedImage
            Each gets a transport.
        goal_of : callable
            Makes of these the ways that light shall take.
        fraction : float
            How much of the bending the entrance face does at the most.
        fits : int
            Pairs of faces in each round of transport.

        Returns
        -------
        dict of str to ndarray, shape (n_u, n_v), or None
            By the names of the faces, scene units; those of the exit face beyond their limits where
            these are too narrow. None if no light leaves a plate.
        """
        rounds, heights = _ROUNDS, self._plate
        coarser = self._coarser() if len(images) == 1 else None
        if coarser is not None:
            rough = coarser.heights(images, goal_of, fraction, fits)
            if rough is None:
                return None
            rounds, fits, heights = _KNOWN_ROUNDS, 1, coarser.carried(rough, self._nets)
        traced = self._light.through(heights)
        flux = self._light.through(self._plate).flux if traced.flux is None else traced.flux
        if flux is None:
            return None
        transports = [
            Transport(flux, *wanted_cells(each.scene, each.target, self._cells), FEW_ROUNDS)
            for each in images
        ]
        for number in range(rounds):
            if number:
                traced = self._light.through(heights)
                # A lens that no light leaves is improved blindly.
                if traced.flux is not None:
                    most = FEW_ROUNDS if number + 1 < rounds else MOST_ROUNDS
                    for transport in transports:
                        transport.improve(traced.flux, most)
            goal = goal_of(transports)
            for fit in range(fits):
                check_interruption()
                if fit:
                    traced = self._light.through(heights)
                entrance = self._entrance(traced, goal, fraction)
                traced = self._light.through({**heights, "entrance": entrance})
                heights = {"entrance": entrance, "exit": self._exit(traced, goal, entrance)}
        return heights

    def carried(self, heights: Mapping[str, Array], nets: Mapping[str, ControlNet]) -> Heights:
        """Control heights of the same faces on other nets."""
        return {face: self._nets[face].carry(z, nets[face]) for face, z in heights.items()}

    def _coarser(self) -> Self | None:
        """The same task on fewer control points; None where they are few."""
        shapes = {
            face: tuple(math.ceil(count / _COARSER) for count in net.shape)
            for face, net in self._nets.items()
        }
        if min(min(shape) for shape in shapes.values()) < _FEWEST:
            return None
        optic = self._scene.optic
        entrance = optic.entrance.model_copy(update={"control_points": shapes["entrance"]})
        changes = {"entrance": entrance, "control_points": shapes["exit"]}
        return type(self)(self._scene.with_optic(optic.model_copy(update=changes)))

    def _entrance(self, traced: LightInLens, goal: Goal, fraction: float) -> Array:
        """The entrance face that bends light by a part, or by less where that does not fit."""
        coming, limits = self._light.coming, self._limits["entrance"]
        way = goal.in_glass(coming, traced)
        for _ in range(_TRIALS):
            slopes = _slopes(coming, unit(way(fraction)), 1.0, self._index)
            slopes = self._light.evenly(slopes, "entrance", traced.entrance)
            heights = self._fits["entrance"].heights(*slopes)
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
        slopes = _slopes(traced.glass, goal.behind(traced), self._index, 1.0)
        heights = self._fits["exit"].heights(*self._light.evenly(slopes, "exit", traced.exit))
        between = float(self._plate["exit"].mean() - entrance.mean())
        return self._limits["exit"].placed(heights, max(self._thickness - between, 0.0))


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
