"""First lenses whose entrance face is not flat: faces are fitted to the ways of the light.

Light is followed from cells of the plane before the lens. Snell's law says what slopes turn it into
its ways in the lens and behind it, at the places that it meets, and least squares find the faces.
The exit face comes second, and mends with the light that the entrance face really sends what that
could not do.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport
from workbench.design.transport.cells import Vector
from workbench.design.transport.faces import SlopeFit, unit
from workbench.design.transport.one_face import FEW_ROUNDS, wanted_cells
from workbench.design.transport.turning import Turning, half_angle
from workbench.design.transport.two_face_light import (
    LightInLens,
    TwoFaceLight,
    to_arrays,
    to_tensors,
)
from workbench.design.transport.view import ReceiverView
from workbench.geometry.faces import NO_FACES
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.interfaces import refract
from workbench.progress import check_interruption
from workbench.scene import Lens, Scene, WantedImage

# Cells along each axis, of lens and screen alike; finer nets get more. Each is a ray to follow.
_CELLS = 128
# Rounds of transport, each with light that knows more of the lens.
_ROUNDS = 3
# The share of the deflection at the entrance face in each trial after one whose face did not fit
# between its limits.
_LESS, _TRIALS = 0.9, 4
# Pairs of faces in each round of transport, for one image and for several.
_FITS, _FITS_OF_LINES = 2, 4
# The part of the turn that the entrance face makes. An LED close by sends 57.8, 59.7 and 58.4 % of
# its light to the screen after 60 steps with 0.25, 0.5 and 0.85. Directions within the glass that
# make 0.85 of the turn ask for faces that are too steep.
_PART = 0.5
_UPRIGHT = np.zeros(()), np.zeros(()), np.ones(())


def split_start(
    scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES
) -> dict[str, Array] | None:
    """Control heights of both faces of a first design that share the bending of the light.

    Between two flat faces light goes on behind the lens as it came. Here it takes the way in the
    glass that it would take there if it came from half-way between where it comes from and where it
    should go: each face then turns light by half, which takes equal slopes of both where these are
    small. Light without a turn finds two flat faces, from however near a source it comes. Where one
    of the faces is fixed, or no freeform face, the other one makes the rest of the deflection.

    `scene`: the design task; an extended source counts as a point at its centre; `target` (n_y,
    n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v): control heights of a face
    that is what it is, by its name, scene units. Returns (n_u, n_v): see
    `_BothFaces.heights`.
    """
    faces = _BothFaces(scene, fixed)
    view = ReceiverView.of(scene)
    exit_fixed = scene.optic.designed_face in fixed

    def goal(transports: Sequence[Transport]) -> _Split:
        (transport,) = transports
        return _Split(scene, *view.places(transport), exit_fixed)

    part = 1.0 if exit_fixed else _PART
    return faces.heights([WantedImage(scene, target, 1.0)], goal, part, _FITS)


class _Split(NamedTuple):
    """Ways to places of the receiver, begun in the glass."""

    scene: Scene
    # (cells, cells), where on the receiver the light of each cell should go.
    to_u: Array
    to_v: Array
    exit_fixed: bool  # whether the exit face turns light as it does, in place of as it should

    def in_glass(self, coming: Vector, traced: LightInLens) -> Callable[[float], Vector]:
        """Ways in the glass of light that leaves between where it comes from and should go.

        It leaves through the exit face where that is fixed, and else through a flat one.
        """
        leaving, index = self.behind(traced), self.scene.optic.index
        normal = to_tensors(traced.normal if self.exit_fixed else _UPRIGHT)

        def way(fraction: float) -> Vector:
            x, y, z = (
                (1 - fraction) * a + fraction * b for a, b in zip(coming, leaving, strict=True)
            )
            # Snell's law is the same both ways: this is how light would enter the glass.
            leaves = to_tensors(unit(x, y, z))
            return to_arrays(refract(leaves, normal, 1 / index).direction)

        return way

    def behind(self, traced: LightInLens) -> Vector:
        """Directions from the exit face to the receiver."""
        x, y, z = self.scene.receiver.towards(self.scene.optic, traced.exit, self.to_u, self.to_v)
        return x, y, z


def line_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """Control heights of both faces of a first design for images on several screens.

    Transport to each image says where on its receiver the light of each cell should go; the line
    that comes nearest to all these places is its way behind the lens. So the entrance face sends it
    to where that line leaves the exit face, and the exit face turns it into the direction of the
    line.

    `scene`: the design task, with further images; an extended source counts as a point at its
    centre; `target` (n_y, n_x): the first wanted image in any scale, row 0 at +y. Returns (n_u,
    n_v): see `_BothFaces.heights`; also None if a receiver is
    at no distance.
    """
    images = scene.wanted(target)
    if not all(image.scene.receiver.at_distance for image in images):
        return None
    weights = [image.weight for image in images]

    def goal(transports: Sequence[Transport]) -> _Lines:
        places = [
            _places(image.scene, transport)
            for image, transport in zip(images, transports, strict=True)
        ]
        return _Lines.through(places, weights)

    return _BothFaces(scene).heights(images, goal, fraction=1.0, fits=_FITS_OF_LINES)


def _places(scene: Scene, transport: Transport) -> Array:
    return scene.receiver.drawn(scene.optic, *ReceiverView.of(scene).places(transport))


class _Lines(NamedTuple):
    """A line for the light of each cell."""

    middle: Array  # (cells, cells, 3), the mean of the places that it comes near to
    slope: Array  # what x and y change by along z, shape (cells, cells, 2)

    @classmethod
    def through(cls, places: Sequence[Array], weights: Sequence[float]) -> "_Lines":
        """The lines of least squares through one place of each image."""
        found = np.stack(places)  # [images, cells, cells, 3]
        middle = np.average(found, axis=0, weights=weights)
        off = found - middle
        part = np.asarray(weights)[:, None, None]
        spread = (part * off[..., 2] ** 2).sum(0)
        moved = (part[..., None] * off[..., 2:] * off[..., :2]).sum(0)
        # Images at the same place determine no direction: light goes straight on.
        return cls(middle, moved / np.where(spread > 0, spread, np.inf)[..., None])

    def at(self, z: Array) -> tuple[Array, Array]:
        """Where the lines are at heights z: x and y."""
        away = (z - self.middle[..., 2])[..., None]
        x, y = np.moveaxis(self.middle[..., :2] + away * self.slope, -1, 0)
        return x, y

    def in_glass(self, coming: Vector, traced: LightInLens) -> Callable[[float], Vector]:
        """Ways from the entrance face to the lines, or less far from where light would go on."""
        at_x, at_y, at_z = traced.entrance
        depth = traced.exit[2] - at_z
        to_x, to_y = self.at(traced.exit[2])
        # Without any bending it would go on as it comes.
        on_x, on_y = (part / coming[2] * depth for part in coming[:2])

        def way(fraction: float) -> Vector:
            way_x = (1 - fraction) * on_x + fraction * (to_x - at_x)
            way_y = (1 - fraction) * on_y + fraction * (to_y - at_y)
            return way_x, way_y, depth

        return way

    def behind(self, traced: LightInLens) -> Vector:
        """From where it really is, light goes to the middle of its line."""
        middle = np.moveaxis(self.middle, -1, 0)
        x, y, z = (to - at for to, at in zip(middle, traced.exit, strict=True))
        return unit(x, y, z)


_Goal = _Split | _Lines
"""Ways for the light of each cell; vectors of three arrays of shape (cells, cells)."""


class _BothFaces:
    """Finds both faces of a lens.

    `scene`: with a lens whose exit face is freeform; an extended source counts as a point at its
    centre; `fixed` (n_u, n_v): control heights of a face that is what it is, by its name.
    """

    def __init__(self, scene: Scene, fixed: Mapping[str, Array] = NO_FACES) -> None:
        nets = freeform_nets(scene.optic)
        optic, self._limits = scene.optic, HeightLimits.of_faces(bounded(scene))
        assert isinstance(optic, Lens)
        self._entering, self._leaving = Turning.at_entrance(optic), Turning.at_exit(optic)
        self._cells = cells_of_faces(nets)
        self._fits = {face: SlopeFit(net, self._cells) for face, net in nets.items()}
        self._light = TwoFaceLight(scene, self._fits, self._cells)
        # Of a source that is seen at a slant less counts, and from farther away.
        self._spread = half_angle(scene) * self._light.coming[2] ** 2 / optic.index
        self._plate = {
            face: np.full(net.shape, float(self._limits[face].undesigned.mean()))
            for face, net in nets.items()
        }
        self._fixed = fixed
        self._front, self._back = (placed.name for placed in optic.placed_faces)
        x, y = nets[self._back].positions
        base = optic.base.height_at(x[:, None], y[None, :])
        self._thickness = float(base.mean()) - optic.datum

    def heights(
        self,
        images: Sequence[WantedImage],
        goal_of: Callable[[Sequence[Transport]], _Goal],
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
                rise = 0.0
                if self._front in self._limits:
                    entrance = self._entrance(traced, goal, fraction)
                    heights[self._front] = entrance
                    traced = self._light.through(heights)
                    between = float(self._plate[self._back].mean() - entrance.mean())
                    rise = max(self._thickness - between, 0.0)
                heights[self._back] = self._exit(traced, goal, rise)
        return heights

    def _entrance(self, traced: LightInLens, goal: _Goal, fraction: float) -> Array:
        """The entrance face that bends light by a part, or by less where that does not fit."""
        if self._front in self._fixed:
            return self._fixed[self._front]
        coming, limits = self._light.coming, self._limits[self._front]
        way = goal.in_glass(coming, traced)
        for _ in range(_TRIALS):
            glass = self._entering.reached(coming, unit(*way(fraction)), self._spread)
            slopes = self._entering.slopes(coming, glass)
            slopes = self._light.evenly(slopes, self._front, traced.entrance)
            heights = self._fits[self._front].heights(*slopes)
            lacks = limits.lacks(heights)
            if lacks <= 0:
                return limits.placed(heights)
            extent = float(np.ptp(heights))
            fraction *= _LESS * (extent - lacks) / extent
        return limits.nearest(heights)

    def _exit(self, traced: LightInLens, goal: _Goal, rise: float) -> Array:
        """The exit face that turns light into its way behind the lens.

        It rises with the entrance face where glass would be thinner than between their places: the
        thinner it is, the more both faces have to bend the light to move it as far.
        """
        if self._back in self._fixed:
            return self._fixed[self._back]
        behind = self._leaving.reached(traced.glass, goal.behind(traced), self._spread)
        slopes = self._leaving.slopes(traced.glass, behind)
        heights = self._fits[self._back].heights(
            *self._light.evenly(slopes, self._back, traced.exit)
        )
        return self._limits[self._back].placed(heights, rise)


def cells_of_faces(nets: Mapping[str, ControlNet]) -> int:
    """Cells along each axis of a first design on the nets of its faces."""
    return max(_CELLS, 2 * max(max(net.shape) for net in nets.values()))
