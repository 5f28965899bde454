"""A first lens of two faces that share the bending of the light.

As in `workbench.design.transport.start`, but light is followed from cells of the plane before the
lens. Between two flat faces light goes on behind the lens as it came. Here it takes the way in the
glass that it would take there if it came from half-way between where it comes from and where it
should go: each face then turns light by half, which takes equal slopes of both where these are
small. Light without a turn finds two flat faces, from however near a source it comes.

Where one of the faces is fixed, the other one makes all of the turn that is left.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.both_faces import BothFaces, Vector, unit
from workbench.design.transport.two_face_light import LightInLens, to_arrays, to_tensors
from workbench.design.transport.view import ReceiverView
from workbench.geometry.faces import NO_FACES
from workbench.optics.interfaces import refract
from workbench.scene import Scene, WantedImage

# Faces in each round of transport.
_FITS = 2
# The part of the turn that the entrance face makes. An LED close by sends 57.8, 59.7 and 58.4 % of
# its light to the screen after 60 steps with 0.25, 0.5 and 0.85. Directions within the glass that
# make 0.85 of the turn ask for faces that are too steep.
_PART = 0.5
_UPRIGHT = np.zeros(()), np.zeros(()), np.ones(())


def split_start(
    scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES
) -> dict[str, Array] | None:
    """Control heights of both faces of a first lens.

    `scene`: the design task; an extended source counts as a point at its centre; `target` (n_y,
    n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v): control heights of a face
    that is what it is, by its name, scene units. Returns (n_u, n_v): see
    `workbench.design.transport.both_faces.BothFaces.heights`.
    """
    faces = BothFaces(scene, fixed)
    view = ReceiverView.of(scene)
    exit_fixed = scene.optic.designed_face in fixed

    def goal(transports: Sequence[Transport]) -> _Split:
        (transport,) = transports
        return _Split(scene, *view.places(transport), exit_fixed)

    part = 1.0 if exit_fixed else _PART
    return faces.heights([WantedImage(scene, target, 1.0)], goal, part, _FITS)


class _Split(NamedTuple):
    """Ways to places of the receiver, begun in the glass; see `both_faces.Goal`."""

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
            leaves = to_tensors(unit((x, y, z)))
            return to_arrays(refract(leaves, normal, 1 / index).direction)

        return way

    def behind(self, traced: LightInLens) -> Vector:
        """Directions from the exit face to the receiver."""
        x, y, z = self.scene.receiver.towards(self.scene.optic, traced.exit, self.to_u, self.to_v)
        return x, y, z
