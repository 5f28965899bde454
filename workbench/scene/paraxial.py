"""Paraxial images through the fixed elements of a train, and its axis unfolded at their mirrors.

The first design, and bounds of heights, take the train as its designed element alone, with the
source and the receivers where that element sees them (Hecht, *Optics*, 5th ed., chapter 5). All is
in the coordinates of that element: it stands upright on the axis.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.scene.element import Element
from workbench.scene.lens import Lens
from workbench.scene.mirror_diffuser import Mirror
from workbench.scene.points import PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.sources import CollimatedSource, Source
from workbench.scene.train import outgoing

if TYPE_CHECKING:
    from workbench.scene.task import Scene

# A source farther away than so many half-widths of the designed element counts as collimated.
_FAR = 1e3
# Degrees across the light of a source that the fixed elements collimate, at most.
_WIDEST = 10.0
# A receiver is not imaged to one so many times as large, or as small.
_LARGEST = 1e3
# Parts of a length that are rounding, over the length of its vector.
_ROUNDING = 1e-13


class _Vertex(NamedTuple):
    """A surface on an axis: its z, its power, and the indices before and behind."""

    z: float
    power: float
    before: float
    behind: float


class _Seen(NamedTuple):
    """An object as light sees it through some elements."""

    # (3,), of its middle in the scene; None of an object that is infinitely far.
    place: Array | None
    # (3, 3), takes its own vectors there; a mirror image behind an odd number of mirrors.
    turn: Array
    magnification: float = 1.0  # how many times as large it is across


def of_designed_element(scene: "Scene") -> "Scene":
    """Return the scene with its designed element alone, source and receivers as that sees them.

    Distortion and the aberrations of the fixed elements are left out.
    """
    optic, number = scene.optic, scene.designed_number
    if len(scene.elements) == 1 and optic.upright:
        return scene
    images = tuple(
        image.model_copy(update={"receiver": _receiver_seen(scene, image.receiver)})
        for image in scene.images
    )
    return scene.model_copy(
        update={
            "elements": (scene.elements[number].straightened,),
            "source": _source_seen(scene, optic),
            "images": images,
        }
    )


def seen_by(source: Source, element: Element) -> Source:
    """Return a source in the coordinates of an element, see `Element.origin`."""
    if element.upright:
        return source
    place = None if source.place is None else _exact(element.seen(np.array(source.place)))
    return source.standing(place, element.turn.T)


def _source_seen(scene: "Scene", optic: Element) -> Source:
    """The source as light of it comes to the designed element, in the coordinates of that."""
    source, before = scene.source, scene.elements[: scene.designed_number]
    if not before:
        return seen_by(source, optic)
    place = None if source.place is None else np.array(source.place)
    seen = _Seen(place, np.eye(3))
    for element, way in zip(before, scene.ways, strict=False):
        lit = element.lit(source.wavelength)
        axis = outgoing(lit, way)
        seen = _through(lit, seen, way, axis, seen.turn @ source.heading)
    turn, size = optic.turn.T @ seen.turn, max(optic.half_width)
    if seen.place is None and source.place is None:
        return source.standing(None, turn)
    away = math.inf
    if seen.place is not None:
        own = _exact(optic.seen(seen.place))
        away = optic.front_z - own[2]
    if 0 < away < _FAR * size:
        if source.place is not None:
            return source.standing(own, turn).shrunk(abs(seen.magnification))
        x, y, z = own.tolist()
        return PointSource(kind="point", position=(x, y, z), **source.colour)
    width = 0.0 if place is None else _angle(source, before[0])
    parallel = CollimatedSource(kind="collimated", angular_diameter=width, **source.colour)
    return parallel if seen.place is not None else parallel.standing(None, turn)


def _angle(source: Source, first: Element) -> float:
    """Degrees across the light of a source that the elements before collimate."""
    half = max(getattr(source, "half_width", (0.0, 0.0)))
    place = source.place
    if not half or place is None:
        return 0.0
    away = max(math.dist(first.position, place), 1e-9 * half)
    return min(math.degrees(2 * math.atan(half / away)), _WIDEST)


def _receiver_seen(scene: "Scene", receiver: AnyReceiver) -> AnyReceiver:
    """A receiver as the designed element sees it, in the coordinates of that."""
    optic, number, ways = scene.optic, scene.designed_number, scene.ways
    behind = list(zip(scene.elements, ways, strict=True))[number + 1 :]
    if receiver.stands_at is None:
        turn = np.diag([1.0, 1.0, float(scene.onwards(receiver))])
        folded = _traced_back(behind, _Seen(None, turn), scene.source.wavelength, rigid=True)
        turn = optic.turn.T @ folded.turn
        same = np.array_equal(turn, np.diag([1.0, 1.0, optic.onwards]))
        return receiver if same else receiver.seen(None, turn, 1.0)
    begin = _Seen(receiver.stands_at, receiver.sides.T)
    seen = _traced_back(behind, begin, scene.source.wavelength, rigid=False)
    place, ahead = seen.place, outgoing(optic, ways[number])
    if (
        not behind
        or place is None
        or (place - behind[0][0].position) @ ahead <= 0
        or not 1 / _LARGEST < abs(seen.magnification) < _LARGEST
    ):
        seen = _traced_back(behind, begin, scene.source.wavelength, rigid=True)
    own = None if seen.place is None else _exact(optic.seen(seen.place))
    turn = optic.turn.T @ seen.turn
    if not np.array_equal(turn, receiver.sides.T):
        turn = np.column_stack([_exact(column) for column in turn.T])
    return receiver.seen(own, turn, abs(seen.magnification))


def _traced_back(
    behind: Sequence[tuple[Element, Array]], seen: _Seen, wavelength_um: float, rigid: bool
) -> _Seen:
    """An object behind elements as light before them sees it; lenses leave it if it is rigid."""
    for element, way in reversed(behind):
        if isinstance(element, Mirror) or not rigid:
            lit = element.lit(wavelength_um)
            back = -way if isinstance(lit, Mirror) else -outgoing(lit, way)
            seen = _through(lit, seen, way, back, back, rigid)
    return seen


def _through(
    element: Element, seen: _Seen, way: Array, axis: Array, heading: Array, rigid: bool = False
) -> _Seen:
    """An object as light sees it behind an element.

    `way` (3,): along which light comes to the element; `axis` (3,): along which light of the
    object, or to it, leaves the element; `heading` (3,): of light of an object that is infinitely
    far.
    """
    vertex, normal, (place, turn, size) = np.array(element.position), element.turn[:, 2], seen
    if isinstance(element, Mirror):
        reflection = np.eye(3) - 2 * np.outer(normal, normal)
        turn, heading = reflection @ turn, reflection @ heading
        place = None if place is None else vertex + reflection @ (place - vertex)
    vertices = [] if rigid else _vertices(element, way, axis)
    if not any(v.power or v.before != v.behind for v in vertices):
        return _Seen(place, turn, size)
    if place is None:
        z, _ = _imaged(vertices, -math.inf)
        if math.isinf(z):
            return _Seen(None, turn, size)
        slope = heading / (heading @ axis) - axis
        middle = sum(v.z for v in vertices) / len(vertices)
        return _Seen(vertex + z * axis + (z - middle) * slope, turn, size)
    away = float((place - vertex) @ axis)
    aside = place - vertex - away * axis
    z, m = _imaged(vertices, away)
    if math.isinf(z):
        return _Seen(None, np.column_stack([turn[:, :2], axis]), size)
    if m < 0:  # upside down
        turn = (2 * np.outer(axis, axis) - np.eye(3)) @ turn
    return _Seen(vertex + z * axis + m * aside, turn, size * m)


def _vertices(element: Element, way: Array, axis: Array) -> list[_Vertex]:
    """Surfaces of an element in the order in which light along an axis meets them.

    z is counted along the axis, from the front vertex of the element.
    """
    side = 1.0 if axis @ element.turn[:, 2] > 0 else -1.0
    curvatures = [placed.face.vertex_curvature for placed in element.placed_faces]
    if not isinstance(element, Lens):
        towards = 1.0 if way @ element.turn[:, 2] > 0 else -1.0
        return [_Vertex(0.0, -2 * towards * curvatures[0], 1.0, 1.0)]
    n, (front, back) = element.index, curvatures
    found = [_Vertex(0.0, (n - 1) * front, 1.0, n)]
    found.append(_Vertex(element.thickness, (1 - n) * back, n, 1.0))
    if side > 0:
        return found
    return [_Vertex(-v.z, v.power, v.behind, v.before) for v in reversed(found)]


def _imaged(vertices: Sequence[_Vertex], z: float) -> tuple[float, float]:
    """Where a place on an axis is imaged to, and the lateral magnification.

    Of light from infinitely far z is negative infinity; an image there is at positive infinity.
    """
    system, last = np.eye(2), vertices[0]
    for vertex in vertices:
        transfer = np.array([[1.0, (vertex.z - last.z) / vertex.before], [0.0, 1.0]])
        system = np.array([[1.0, 0.0], [-vertex.power, 1.0]]) @ transfer @ system
        last = vertex
    # Height and angle of a ray of the object in the first surface.
    ray = np.array([1.0, 0.0] if math.isinf(z) else [vertices[0].z - z, 1.0])
    height, angle = system @ ray
    if abs(angle) <= _ROUNDING * abs(system[1]) @ abs(ray):
        return math.inf, math.inf
    return float(last.z - height / angle), float(1 / angle)


def _exact(vector: Array) -> Array:
    """A vector without parts that are rounding."""
    return np.where(np.abs(vector) <= _ROUNDING * np.linalg.norm(vector), 0.0, vector)
