"""Faces of elements on grids that fill their outlines, in the coordinates of the scene."""

from collections.abc import Mapping

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.scene import Element, PlacedFace
from workbench.scene.spline_face import SplineFace


def face_points(
    element: Element, placed: PlacedFace, u: Array, v: Array, heights: Mapping[str, Array]
) -> Array:
    """Return points (m_x, m_y, 3) of a face at its place in the scene.

    ``u`` (m_x,) and ``v`` (m_y,) in [-1, 1] are coordinates of the square that is mapped onto the
    outline. ``heights`` are control heights by face; a B-spline face without has its base shape.
    """
    outline, face = outline_of(element), placed.face
    if isinstance(face, SplineFace) and placed.name in heights:
        net = freeform_nets(element)[placed.name]
        x, y, z, *_ = net.over(outline, u, v, heights[placed.name])
    else:
        x, y = outline.from_square(u[:, None], v)
        z = placed.z + face.base.sag(x, y)
    return element.in_scene(np.stack([x, y, z], axis=-1))


def face_normals(
    element: Element, placed: PlacedFace, u: Array, v: Array, heights: Mapping[str, Array]
) -> Array:
    """Return unit normals (m_x, m_y, 3) of a face along +z of its element; see `face_points`."""
    outline, face = outline_of(element), placed.face
    if isinstance(face, SplineFace):
        net = freeform_nets(element)[placed.name]
        _, _, _, slope_x, slope_y = net.over(outline, u, v, heights[placed.name])
        own = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=-1)
        own /= np.linalg.norm(own, axis=-1, keepdims=True)
    else:
        own = face.normal(*outline.from_square(u[:, None], v))
    return np.asarray(own @ element.turn.T)


def element_sides(
    element: Element, u: Array, v: Array, heights: Mapping[str, Array]
) -> tuple[Array, Array]:
    """Return points (m_x, m_y, 3) of the front and of the back of an element's solid part.

    They are its faces; a single face has a flat back, as in exports. See `face_points`.
    """
    front, *others = (
        face_points(element, placed, u, v, heights) for placed in element.placed_faces
    )
    if others:
        return front, others[-1]
    back = element.seen(front).copy()
    back[..., 2] = element.flat_z(back[..., 2])
    return front, element.in_scene(back)
