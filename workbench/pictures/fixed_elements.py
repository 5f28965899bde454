"""Elements of a train that the design leaves as they are, in the 3D view."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pyvista as pv

from workbench.geometry.face_grids import element_sides
from workbench.geometry.outlines import outline_of
from workbench.pictures import meshes
from workbench.scene import Element, Scene

_SAMPLES = 49  # per axis, of each face

Add = Callable[..., Any]


def add_fixed_elements(
    add: Add, scene: Scene, style_of: Callable[[Element], Mapping[str, Any]]
) -> list[Any]:
    """Draw all elements but the designed one; return the actors of their edges.

    ``add`` is `LensPicture._add`; ``style_of`` gives how the surfaces of an element look.
    """
    edges = []
    for number, element in enumerate(scene.elements):
        if number != scene.designed_number:
            edges.append(_add_element(add, element, style_of(element)))
    return edges


def _add_element(add: Add, element: Element, style: Mapping[str, Any]) -> Any:
    side = np.linspace(-1, 1, _SAMPLES)
    front, back = element_sides(element, side, side, {})
    for face in (front, back):
        surface = pv.PolyData(face.reshape(-1, 3), faces=meshes.quads(_SAMPLES, _SAMPLES))
        surface.point_data.active_normals = meshes.normals(face)
        actor = add(surface, body=True, **style)
        actor.prop.interpolation = "Phong"
    rims = np.stack([meshes.rim(face) for face in (front, back)])
    count = rims.shape[1]
    walls = pv.PolyData(rims.reshape(-1, 3), faces=meshes.quads(2, count))
    add(walls, body=True, **style)
    index = np.arange(2 * count).reshape(2, count)
    lines = [index[0], index[1]]
    if outline_of(element).whole:
        lines += list(index[:, :: _SAMPLES - 1].T)  # at the corners
    outline = pv.PolyData(rims.reshape(-1, 3), lines=meshes.polylines(lines))
    return add(outline, line_width=1.5, lighting=False)
