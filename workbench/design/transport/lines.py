"""A first lens of two faces that sends light along lines through several images.

Transport to each image says where on its receiver the light of each cell should go; the line that
comes nearest to all these places is its way behind the lens. So the entrance face sends it to where
that line leaves the exit face, and the exit face turns it into the direction of the line. As in
`workbench.design.transport.two_faces`, light is followed from cells of the plane before the lens.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.start import FEW_ROUNDS, destinations, wanted_cells
from workbench.design.transport.two_face_light import LightInLens, TwoFaceLight
from workbench.design.transport.two_faces import CELLS, slopes, unit
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

Array = npt.NDArray[np.float64]
Vector = tuple[Array, Array, Array]

# Rounds of transport, each with light that knows more of the lens; and of faces in each.
_ROUNDS, _FITS = 3, 4
# What is left of the way across the glass in each trial after one whose entrance face did not fit.
_LESS, _TRIALS = 0.9, 4


def line_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """Control heights of both faces of a first lens for images on several screens.

    Parameters
    ----------
    scene : Scene
        The design task, with further images; an extended source counts as a point at its centre.
    target : ndarray, shape (n_y, n_x)
        The first wanted image in any scale, row 0 at +y.

    Returns
    -------
    dict of str to ndarray, shape (n_u, n_v), or None
        Heights by the names of the faces, scene units; those of the exit face beyond their limits
        where these are too narrow for the task. None if no light leaves a plate, or a receiver is
        at no distance.
    """
    images = scene.images(target)
    if not all(image.scene.receiver.at_distance for image in images):
        return None
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
    transports = [
        Transport(traced.flux, *wanted_cells(image.scene, image.target, cells), FEW_ROUNDS)
        for image in images
    ]
    weights = [image.weight for image in images]
    fits = {face: SlopeFit(net, cells) for face, net in nets.items()}
    faces = _Faces(scene, light, fits, limits)
    for number in range(_ROUNDS):
        places = [
            _places(image.scene, transport)
            for image, transport in zip(images, transports, strict=True)
        ]
        heights = faces.bent(_Lines.through(places, weights), heights)
        flux = light.through(heights).flux
        if number + 1 < _ROUNDS and flux is not None:
            for transport in transports:
                transport.improve(flux, FEW_ROUNDS if number + 2 < _ROUNDS else MOST_ROUNDS)
    return heights


def _places(scene: Scene, transport: Transport) -> Array:
    """Where the light of each cell should go, shape (cells, cells, 3)."""
    return scene.receiver.drawn(scene.optic, *destinations(transport, scene.receiver))


class _Lines(NamedTuple):
    """A line for the light of each cell; arrays of shape (cells, cells, 2) for x and y.

    Attributes
    ----------
    middle : ndarray, shape (cells, cells, 3)
        The mean of the places that it comes near to.
    slope : ndarray
        What x and y change by along z.
    """

    middle: Array
    slope: Array

    @classmethod
    def through(cls, places: Sequence[Array], weights: Sequence[float]) -> "_Lines":
        """The lines of least squares through one place of each image."""
        found = np.stack(places)  # [images, cells, cells, 3]
        middle = np.average(found, axis=0, weights=weights)
        off = found - middle
        part = np.asarray(weights)[:, None, None]
        spread = (part * off[..., 2] ** 2).sum(0)
        moved = (part[..., None] * off[..., 2:] * off[..., :2]).sum(0)
        # Images at the same place tell no direction: light goes straight on.
        return cls(middle, moved / np.where(spread > 0, spread, np.inf)[..., None])

    def at(self, z: Array) -> tuple[Array, Array]:
        """Where the lines are at heights z: x and y."""
        away = (z - self.middle[..., 2])[..., None]
        x, y = np.moveaxis(self.middle[..., :2] + away * self.slope, -1, 0)
        return x, y


class _Faces(NamedTuple):
    """Finds faces that send light along lines."""

    scene: Scene
    light: TwoFaceLight
    fits: dict[str, SlopeFit]
    limits: dict[str, HeightLimits]

    def bent(self, lines: _Lines, heights: dict[str, Array]) -> dict[str, Array]:
        """Control heights of both faces, from those of a lens like it."""
        n, middle = self.scene.optic.index, np.moveaxis(lines.middle, -1, 0)
        for _ in range(_FITS):
            entrance = self._entrance(lines, self.light.through(heights))
            traced = self.light.through({**heights, "entrance": entrance})
            # From where it really is, light goes to the middle of its line.
            x, y, z = (to - at for to, at in zip(middle, traced.exit, strict=True))
            bends = slopes(traced.glass, unit((x, y, z)), n, 1.0)
            bent = self.fits["exit"].heights(*self.light.evenly(bends, "exit", traced.exit))
            heights = {"entrance": entrance, "exit": self.limits["exit"].placed(bent)}
        return heights

    def _entrance(self, lines: _Lines, traced: LightInLens) -> Array:
        """The entrance face that sends light to its line, or less far where that does not fit."""
        coming, limits, n = self.light.coming, self.limits["entrance"], self.scene.optic.index
        at_x, at_y, at_z = traced.entrance
        depth = traced.exit[2] - at_z
        to_x, to_y = lines.at(traced.exit[2])
        # Without any bending it would go on as it comes.
        on_x, on_y = (part / coming[2] * depth for part in coming[:2])
        part = 1.0
        for _ in range(_TRIALS):
            way_x = (1 - part) * on_x + part * (to_x - at_x)
            way_y = (1 - part) * on_y + part * (to_y - at_y)
            bends = slopes(coming, unit((way_x, way_y, depth)), 1.0, n)
            bends = self.light.evenly(bends, "entrance", traced.entrance)
            bent = self.fits["entrance"].heights(*bends)
            lacks = limits.lacks(bent)
            if lacks <= 0:
                return limits.placed(bent)
            extent = float(np.ptp(bent))
            part *= _LESS * (extent - lacks) / extent
        return limits.nearest(bent)
