"""Faces for an edited task, from where the face before the edit sent light."""

import math

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.cells import Pair, between
from workbench.design.transport.faces import FaceLight, Faces, SlopeFit
from workbench.design.transport.one_face import cells_for
from workbench.geometry.surface import ControlNet, nets_of
from workbench.scene import Scene

# Cells along an axis for each control point: 1, and this for each degree; and at least those of a
# first design, whose matrices are there. A flame's lens of 480 control points of degree
# 3 is 1.63 % off with 1.25 to 1.8 of them. With fewer, slopes in cells do not determine a spline:
# near its ends it oscillates, the more so the higher its degree.
_PER_DEGREE = 0.15
# A fit takes slopes where the former face was. How far it moves is smooth: it is found before on a
# net of the first number of control points along an axis, from the second number of cells, in the
# third number of fits. A flame behind a screen 5 % farther is 1.22 % off with it, as after two fits
# of all control points, and 1.50 % without it.
_ROUGH, _ROUGH_CELLS, _ROUGH_MOVES = 64, 256, 2


def refitted(before: Scene, heights: Array, scene: Scene) -> Array | None:
    """Control heights that send light where those of another scene send it.

    No transport is needed, which takes most of the time of a first design. With the screen of a
    photograph 5 % farther (768 × 624 control points), the image of the face is there after 0.3 s of
    the processor, and 1.29 % off where it was 1.17 % off before; by transport the face takes 1.5 s
    and begins at 6.2 %.

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
    cells = max(math.ceil(per_control_point * max(net.shape)), cells_for(net))
    places = FaceLight(before, former_net, SlopeFit(former_net, cells), cells).goes_to(heights)
    if places is None:
        return None
    (n_x, n_y), (m_x, m_y) = scene.receiver.pixels, before.receiver.pixels
    column, row = before.receiver.to_pixels(*places)
    to = scene.receiver.from_pixels(column * (n_x / m_x), row * (n_y / m_y))
    found = Faces(scene, net, cells).fitted(to, _raised(scene, net, to, heights), 1)
    return found if np.isfinite(found).all() else None


def _raised(scene: Scene, net: ControlNet, to: Pair, heights: Array) -> Array:
    """Heights moved to about where those of a face are that sends light to places."""
    n_u, n_v = (min(count, _ROUGH) for count in net.shape)
    few = ControlNet.of(scene.optic.shaped(control_points=(n_u, n_v)))
    middles = (np.arange(_ROUGH_CELLS) + 0.5) * (len(to[0]) / _ROUGH_CELLS) - 0.5
    at_x, at_y = np.meshgrid(middles, middles, indexing="ij")
    u, v = (between(each, (at_x, at_y)) for each in to)
    rough = net.carry(heights, few)
    found = Faces(scene, few, _ROUGH_CELLS).fitted((u, v), rough, _ROUGH_MOVES)
    # The move is smooth: control heights are where the face is.
    at = ((place / half + 1) / 2 for place, half in zip(net.positions, net.half_width, strict=True))
    return np.asarray(heights + few.grid(*at).evaluate(found - rough)[0])


def _alike(before: Scene, scene: Scene) -> bool:
    """Whether the same places on a receiver are meant, and a net has the same numbers."""
    first, second = before.optic, scene.optic
    return (
        first.called == second.called
        and first.net_shape == second.net_shape
        and list(nets_of(before)) == list(nets_of(scene)) == [second.designed_face]
        and type(before.receiver) is type(scene.receiver)
        and before.unit == scene.unit
        and len(before.images) == len(scene.images) == 1
    )
