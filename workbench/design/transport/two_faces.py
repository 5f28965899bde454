"""A first lens of two faces that share the bending of the light.

As in `workbench.design.transport.start`, but light is followed from cells of the plane before the
lens. In the glass it takes a direction between where it comes from and where it should go.
Collimated light is turned by 1/(2n) of the way, which takes equal slopes of both faces where these
are small. That of near points is turned by most of the way: what would be turned later leaves
through the side before it comes to the exit face.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.both_faces import BothFaces, Vector
from workbench.design.transport.two_face_light import LightInLens
from workbench.design.transport.view import ReceiverView
from workbench.scene import Scene, WantedImage

# Faces in each round of transport.
_FITS = 2
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
        See `workbench.design.transport.both_faces.BothFaces.heights`.
    """
    faces = BothFaces(scene)
    view = ReceiverView.of(scene)
    part = 0.5 / scene.optic.index if faces.collimated else _NEAR_PART

    def goal(transports: Sequence[Transport]) -> _Split:
        (transport,) = transports
        return _Split(scene, *view.places(transport))

    return faces.heights([WantedImage(scene, target, 1.0)], goal, part, _FITS)


class _Split(NamedTuple):
    """Ways to places of the receiver, begun in the glass; see `both_faces.Goal`.

    Attributes
    ----------
    scene : Scene
        The design task.
    to_u, to_v : ndarray, shape (cells, cells)
        Where on the receiver the light of each cell should go.
    """

    scene: Scene
    to_u: Array
    to_v: Array

    def in_glass(self, coming: Vector, traced: LightInLens) -> Callable[[float], Vector]:
        """Directions between where light comes from and where it goes."""
        leaving = self.behind(traced)

        def way(fraction: float) -> Vector:
            x, y, z = (
                (1 - fraction) * a + fraction * b for a, b in zip(coming, leaving, strict=True)
            )
            return x, y, z

        return way

    def behind(self, traced: LightInLens) -> Vector:
        """Directions from the exit face to the receiver."""
        x, y, z = self.scene.receiver.towards(self.scene.optic, traced.exit, self.to_u, self.to_v)
        return x, y, z
