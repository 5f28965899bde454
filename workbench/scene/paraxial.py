"""Paraxial images through the fixed elements of a train.

The first design, and bounds of heights, take the train as its designed element alone, with the
source and the receivers where that element sees them (Hecht, *Optics*, 5th ed., chapter 5).
"""

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from workbench.scene.collimated_source import CollimatedSource
from workbench.scene.element import Element
from workbench.scene.faces import ConicFace
from workbench.scene.image import Image
from workbench.scene.lens import Lens
from workbench.scene.screen import Screen
from workbench.scene.source import Source

if TYPE_CHECKING:
    from workbench.scene.task import Scene

# A source farther away than so many half-widths of the designed element counts as collimated.
_FAR = 1e3
# Degrees across the light of a source that the fixed elements collimate, at most.
_WIDEST = 10.0


class _Vertex(NamedTuple):
    """A refracting surface on the axis: its z, curvature, and the indices before and behind."""

    z: float
    curvature: float
    before: float
    behind: float


class _Object(NamedTuple):
    """A place on the axis, infinite for collimated light, and a lateral magnification."""

    z: float
    magnification: float


def of_designed_element(scene: "Scene") -> "Scene":
    """Return the scene with its designed element alone, source and receivers as that sees them.

    Distortion and the aberrations of the fixed elements are left out.
    """
    if len(scene.elements) == 1:
        return scene
    number = scene.designed_number
    before = [each.lit(scene.source.wavelength) for each in scene.elements[:number]]
    behind = [each.lit(scene.source.wavelength) for each in scene.elements[number + 1 :]]
    images = tuple(_seen_from_before(image, behind) for image in scene.images)
    return scene.model_copy(
        update={
            "elements": (scene.elements[number],),
            "source": _seen_from_behind(scene.source, before, scene.optic),
            "images": images,
        }
    )


def _vertices(elements: Sequence[Element]) -> Iterator[_Vertex]:
    for element in elements:
        if isinstance(element, Lens):
            for placed, (before, behind) in zip(
                element.placed_faces, ((1.0, element.index), (element.index, 1.0)), strict=True
            ):
                face = placed.face
                curvature = 1 / face.radius if isinstance(face, ConicFace) else 0.0
                yield _Vertex(placed.z, curvature, before, behind)


def _imaged(vertices: Sequence[_Vertex], z: float) -> _Object:
    """The image of a place on the axis; of collimated light, where z is infinite."""
    magnification = 1.0
    vergence = 0.0 if math.isinf(z) else math.nan
    for vertex in vertices:
        if not math.isinf(z):
            vergence = vertex.before / (z - vertex.z) if z != vertex.z else math.inf
        power = (vertex.behind - vertex.before) * vertex.curvature
        after = vergence + power
        if math.isinf(vergence):  # a place in the surface is its own image
            continue
        if math.isinf(z):
            z = math.inf if after == 0 else vertex.z + vertex.behind / after
        else:
            magnification *= vergence / after if after else math.inf
            z = vertex.z + vertex.behind / after if after else math.inf
        vergence = 0.0 if math.isinf(z) else after
    return _Object(z, magnification)


def _seen_from_behind(source: Source, before: Sequence[Element], element: Element) -> Source:
    """The source as light of it comes to the designed element."""
    vertices = list(_vertices(before))
    if not vertices:
        return source
    place, size = source.place, max(element.half_width)
    seen = _imaged(vertices, -math.inf if place is None else place[2])
    away = element.front_z - seen.z
    if place is not None and 0 < away < _FAR * size:
        x, y, _ = place
        m = seen.magnification
        return source.placed((m * x, m * y, seen.z)).shrunk(abs(m))
    if place is None and (math.isinf(seen.z) or not 0 < away < _FAR * size):
        return source
    width = 0.0 if place is None else _angle(source, vertices[0].z)
    return CollimatedSource(kind="collimated", angular_diameter=width, **source.colour)


def _angle(source: Source, front_z: float) -> float:
    """Degrees across the light of a source that the elements before collimate."""
    half = max(getattr(source, "half_width", (0.0, 0.0)))
    place = source.place
    if not half or place is None:
        return 0.0
    away = max(front_z - place[2], 1e-9 * half)
    return min(math.degrees(2 * math.atan(half / away)), _WIDEST)


def _seen_from_before(image: Image, behind: Sequence[Element]) -> Image:
    """An image as the designed element sees its receiver through the elements behind."""
    receiver = image.receiver
    vertices = [
        _Vertex(v.z, -v.curvature, v.behind, v.before) for v in reversed(list(_vertices(behind)))
    ]
    if not vertices or not isinstance(receiver, Screen):
        return image
    mirrored = [v._replace(z=-v.z) for v in vertices]  # light goes the other way
    seen = _imaged(mirrored, -receiver.z)
    z, m = -seen.z, abs(seen.magnification)
    if math.isinf(z) or z <= vertices[-1].z or not 1e-3 < m < 1e3:
        return image
    x, y, _ = receiver.position
    r_x, r_y = receiver.half_width
    changes = {"position": (m * x, m * y, z), "half_width": (m * r_x, m * r_y)}
    return image.model_copy(update={"receiver": receiver.model_copy(update=changes)})
