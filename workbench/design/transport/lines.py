"""A first lens of two faces that sends light along lines through several images.

Transport to each image says where on its receiver the light of each cell should go; the line that
comes nearest to all these places is its way behind the lens. So the entrance face sends it to where
that line leaves the exit face, and the exit face turns it into the direction of the line. As in
`workbench.design.transport.two_faces`, light is followed from cells of the plane before the lens.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.both_faces import BothFaces, Vector, unit
from workbench.design.transport.two_face_light import LightInLens
from workbench.design.transport.view import ReceiverView
from workbench.scene import Scene

# Faces in each round of transport.
_FITS = 4


def line_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """Control heights of both faces of a first lens for images on several screens.

    `scene`: the design task, with further images; an extended source counts as a point at its
    centre; `target` (n_y, n_x): the first wanted image in any scale, row 0 at +y. Returns (n_u,
    n_v): see `workbench.design.transport.both_faces.BothFaces.heights`; also None if a receiver is
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

    return BothFaces(scene).heights(images, goal, fraction=1.0, fits=_FITS)


def _places(scene: Scene, transport: Transport) -> Array:
    """Where the light of each cell should go, shape (cells, cells, 3)."""
    return scene.receiver.drawn(scene.optic, *ReceiverView.of(scene).places(transport))


class _Lines(NamedTuple):
    """A line for the light of each cell; see `both_faces.Goal`."""

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
        # Images at the same place tell no direction: light goes straight on.
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
        return unit((x, y, z))
