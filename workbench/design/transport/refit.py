"""A face for a task that has changed a little: light goes where it went before.

No transport is needed, which takes most of the time of a first lens. With the index of a flame's
lens 2 % higher or its screen 10 % farther, the face is found in 0.2 s, and its image is 1.5 to
2.1 % off where it was 1.5 % off before; by transport it takes 1 to 2 s and begins at 6 to 8 %.
"""

import math

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.face_light import FaceLight
from workbench.design.transport.faces import Faces
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Scene

# Cells along an axis for each control point: one, and so many more for each degree; and at least. A
# flame's lens of 480 control points of degree 3 is 1.63 % off with 1.25 to 1.8 of them, for 0.26 to
# 0.60 s of the processor. With fewer, slopes in cells tell a spline no longer: near its ends it
# runs wild, the more so the higher its degree.
_PER_DEGREE, _FEWEST = 0.15, 256
# The first fit takes slopes where the former face was. Another one follows where the face has moved
# by more than this part of its extent along z.
_STILL = 0.01


def refitted(before: Scene, heights: Array, scene: Scene) -> Array | None:
    """Control heights that send light where those of another scene send it.

    `before`: what a lens or mirror was designed for; `heights` (n_u, n_v): control heights of its
    only freeform face, scene units; `scene`: what it is to be good for: source, optic or receiver
    may differ, as long as the target is the same in parts of the receiver. Returns (n_u, n_v):
    heights, beyond their limits where these are too narrow. None if the tasks differ in more, have
    several images or faces, or light of the former face does not all come to the plane of the
    receiver.
    """
    if not _alike(before, scene):
        return None
    net, former_net = ControlNet.of(scene.optic), ControlNet.of(before.optic)
    per_control_point = 1 + _PER_DEGREE * max(net.degree)
    cells = max(math.ceil(per_control_point * max(net.shape)), _FEWEST)
    former = FaceLight(before, former_net, SlopeFit(former_net, cells), cells).goes_to(heights)
    if former is None:
        return None
    (n_x, n_y), (m_x, m_y) = scene.receiver.pixels, before.receiver.pixels
    column, row = before.receiver.to_pixels(*former)
    to = scene.receiver.from_pixels(column * (n_x / m_x), row * (n_y / m_y))
    fit = SlopeFit(net, cells)
    light, limits = FaceLight(scene, net, fit, cells), HeightLimits.of(bounded(scene), net)
    faces = Faces(scene, light, fit, limits)
    found = faces.fitted(to, heights, 1)
    if np.ptp(found - heights) > _STILL * np.ptp(heights):
        found = faces.fitted(to, found, 1)
    return found if np.isfinite(found).all() else None


def _alike(before: Scene, scene: Scene) -> bool:
    """Whether the same places on a receiver are meant, and a net has the same numbers."""
    first, second = before.optic, scene.optic
    return (
        first.called == second.called
        and first.net_shape == second.net_shape
        and list(freeform_nets(first)) == list(freeform_nets(second)) == [second.designed_face]
        and type(before.receiver) is type(scene.receiver)
        and before.unit == scene.unit
        and len(before.images) == len(scene.images) == 1
    )
