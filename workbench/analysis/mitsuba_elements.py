"""The elements of a train as shapes of Mitsuba: a function for each kind, and a row in ``_KINDS``.

Faces are meshes with their exact normals. Black walls close the sides of a lens, and black baffles
surround an element as far as no other part of the train's light passes there.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.mitsuba_scatter import scattering
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.face_grids import face_normals, face_points
from workbench.geometry.outlines import Rectangle, outline_of
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.scene import Diffuser, Element, Lens, Mirror, Part, Scene, Screen, Source
from workbench.scene.part import row_of

Indices = npt.NDArray[np.uint32]
Shapes = dict[str, Any]

# Least number of cells of the mesh of a freeform face along each axis; they divide the knot spans
# evenly. Finer nets get the second number of cells a span, up to twice as many in all: with 5 a
# span, two lenses of 240² control points were 0.77 % off in 16 million rays, 3 standard deviations;
# with 9, 0.9.
_CELLS, _PER_SPAN = 1024, 8
# The same of a curved fixed face, and of a plane face within an ellipse.
_SMOOTH, _ROUND = 512, 256
# In half-widths of the smallest element: what counts as 1.
_UNIT = 0.01
# In half-widths of the designed element: how far a baffle goes.
_BAFFLE = 1000.0
# Which part of the distance to other light of the train a baffle takes.
_CLEAR = 0.95
# Points of each element and of the source along each axis, between which light goes.
_ACROSS = 5
_BLACK = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}}


class Coordinates(NamedTuple):
    """Coordinates of Mitsuba: those of the first element, from its aperture on, in small units.

    Mitsuba counts in single precision, and starts each ray 9e-5 (1 + d) units beyond its surface,
    where d is the largest coordinate. With the half-width of the lens as unit, rays of an LED 0.1
    mm before a dome started 2 µm closer to it, and 0.05 % of its light missed the lens behind.
    """

    first: Element
    unit: float  # scene units

    @classmethod
    def of(cls, scene: Scene) -> "Coordinates":
        """Those of a scene."""
        return cls(scene.first, _UNIT * min(min(each.half_width) for each in scene.elements))

    def entrance(self, scene: Scene) -> tuple[Source, Element]:
        """Source and first element, scene units."""
        source, first = (_lowered(each, self.begin) for each in scene.entrance)
        return source, first

    def places(self, points: Array) -> Array:
        """Places (..., 3) of points of the scene."""
        return np.asarray(self.first.seen(points) - [0.0, 0.0, self.begin]) / self.unit

    def vectors(self, vectors: Array) -> Array:
        """Unit vectors (..., 3) of those of the scene."""
        return np.asarray(vectors @ self.first.turn)

    @property
    def begin(self) -> float:
        """The z of the first element that counts as 0."""
        return self.first.front_z


def _lowered(part: Part, z: float) -> Any:
    if (position := getattr(part, "position", None)) is None:
        return part
    return part.model_copy(update={"position": (*position[:2], position[2] - z)})


class _Placed(NamedTuple):
    """An element with what its shapes need.

    ``reach`` is how far its baffle may go from its axis, scene units.
    """

    mi: Any
    element: Element
    heights: Mapping[str, Array]
    reach: float
    coordinates: Coordinates

    def grid(self) -> tuple[Array, Array]:
        """Places in [-1, 1] along each axis; knots of a freeform face are among them."""
        net = freeform_nets(self.element).get(self.element.designed_face)
        if net is not None:
            spans = [n - p for n, p in zip(net.shape, net.degree, strict=True)]
            counts = [
                count
                * max(math.ceil(_CELLS / count), min(_PER_SPAN, math.ceil(2 * _CELLS / count)))
                for count in spans
            ]
        elif not all(placed.face.flat for placed in self.element.placed_faces):
            counts = [_SMOOTH, _SMOOTH]
        else:
            counts = [1, 1] if outline_of(self.element).whole else [_ROUND, _ROUND]
        u, v = (np.linspace(-1, 1, count + 1) for count in counts)
        return u, v


def mitsuba_elements(
    mi: Any,
    scene: Scene,
    heights: Mapping[str, Array],
    screen: Screen,
    coordinates: Coordinates,
) -> Shapes:
    """Shapes of all elements by name.

    Parameters
    ----------
    mi : module
        Mitsuba.
    scene : Scene
        Gives the elements and the source.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.
    screen : Screen
        Where light goes behind the elements.
    coordinates : Coordinates
        Those of Mitsuba.

    Raises
    ------
    Refused
        If Mitsuba is given no shapes of a kind of element.
    """
    shapes: Shapes = {}
    stations, farthest = _stations(scene, screen), _BAFFLE * max(scene.optic.half_width)
    for number, each in enumerate(scene.elements):
        if not isinstance(each, tuple(_KINDS)):
            unknown = Message("Mitsuba is given no {kind}; leave it out to compare", kind=each.kind)
            raise Refused(f"elements[{number}].kind", unknown)
        element = each.lit(scene.source.wavelength)
        reach = min(_free_reach(stations, number, each), farthest)
        placed = _Placed(mi, element, heights, reach, coordinates)
        own = row_of(_KINDS, element)(placed, element)
        if number or element.onwards > 0:  # light of the source comes to a mirror alone
            own |= _baffles(placed, apertured=number == 0)
        shapes |= {f"{name}{number}": shape for name, shape in own.items()}
    return shapes


def _lens(placed: _Placed, element: Lens) -> Shapes:
    """Both faces, and walls that absorb light which leaves by the sides."""
    mi = placed.mi
    u, v = placed.grid()
    front, back = (
        face_points(element, face, u, v, placed.heights) for face in element.placed_faces
    )
    inwards, outwards = (
        face_normals(element, face, u, v, placed.heights) for face in element.placed_faces
    )
    glass = mi.load_dict({"type": "dielectric", "int_ior": element.index, "ext_ior": 1.0})
    walls = np.stack([_rim(front), _rim(back)], axis=1)
    return {
        "back": _mesh(placed, back, glass, outwards),
        "front": _mesh(placed, front[:, ::-1], glass, -inwards[:, ::-1]),
        "walls": _mesh(placed, walls, mi.load_dict(_BLACK)),
    }


def _mirror(placed: _Placed, element: Mirror) -> Shapes:
    """The face, which reflects on both sides."""
    u, v = placed.grid()
    (face,) = element.placed_faces
    metal = placed.mi.load_dict(
        {
            "type": "twosided",
            "bsdf": {
                "type": "conductor",
                "material": "none",
                "specular_reflectance": {"type": "rgb", "value": element.reflectance},
            },
        }
    )
    points = face_points(element, face, u, v, placed.heights)
    return {"face": _mesh(placed, points, metal, face_normals(element, face, u, v, placed.heights))}


def _diffuser(placed: _Placed, element: Diffuser) -> Shapes:
    """The plane, which scatters all light to its other side."""
    u, v = placed.grid()
    (face,) = element.placed_faces
    law = scattering(placed.mi, element)
    return {"plane": _mesh(placed, face_points(element, face, u, v, placed.heights), law)}


def _baffles(placed: _Placed, apertured: bool) -> Shapes:
    """Black surfaces around the outline: at the rim, and in the plane of an aperture."""
    element, (u, v) = placed.element, placed.grid()
    rims = [
        element.seen(_rim(face_points(element, face, u, v, placed.heights)))
        for face in element.placed_faces
    ]
    levels = {float(min(rims[0][:, 2].max(), rims[-1][:, 2].min()))}
    if apertured:
        levels.add(element.front_z)
    outline = outline_of(element)
    black = placed.mi.load_dict(_BLACK)
    shapes: Shapes = {}
    for number, level in enumerate(levels):
        shapes |= _beside(placed, level, f"baffle{number}_")
        if outline.whole:
            continue
        # Black from the outline to its bounding rectangle, where the rectangles begin.
        x, y = Rectangle(element.half_width).from_square(u[:, None], v)
        around = _rim(np.stack([x, y, np.full_like(x, level)], axis=-1))
        foot = rims[0] * [1, 1, 0] + [0, 0, level]
        ring = element.in_scene(np.stack([around, foot], axis=1))
        shapes[f"frame{number}_"] = _mesh(placed, ring, black)
    return shapes


def _beside(placed: _Placed, level: float, name: str) -> Shapes:
    """Black rectangles around the bounding rectangle, at a z of the element."""
    r_x, r_y = placed.element.half_width
    wide, to = placed.reach, placed.mi.ScalarTransform4f
    if wide <= max(r_x, r_y):
        return {}
    place = np.eye(4)
    place[:3, :3] = placed.coordinates.vectors(placed.element.turn.T).T
    place[:3, 3] = placed.coordinates.places(placed.element.origin)
    beside_x, beside_y = (r_x + wide) / 2, (r_y + wide) / 2
    rectangles = [
        (-beside_x, 0.0, (wide - r_x) / 2, wide),
        (beside_x, 0.0, (wide - r_x) / 2, wide),
        (0.0, -beside_y, r_x, (wide - r_y) / 2),
        (0.0, beside_y, r_x, (wide - r_y) / 2),
    ]
    unit = placed.coordinates.unit
    return {
        f"{name}{number}_": {
            "type": "rectangle",
            "to_world": to(place)
            @ to().translate([x / unit, y / unit, level / unit])
            @ to().scale([half_x / unit, half_y / unit, 1]),
            "bsdf": _BLACK,
        }
        for number, (x, y, half_x, half_y) in enumerate(rectangles)
    }


def _stations(scene: Scene, screen: Screen) -> list[Array]:
    """Points (n, 3) of the source, of each element and of the screen, in the order of the light."""
    elements = [_across(each) for each in scene.elements]
    if scene.source.place is None:
        first = elements[0] - 2 * max(scene.elements[0].half_width) * scene.ways[0]
    else:
        first = scene.source.seen((_ACROSS, _ACROSS))
    x, y = _square(screen.half_width)
    right, up, _ = screen.sides
    last = np.array(screen.position) + x[:, None] * right + y[:, None] * up
    return [first, *elements, last]


def _across(element: Element) -> Array:
    x, y = _square(element.half_width)
    return element.in_scene(np.stack([x, y, np.full_like(x, element.position[2])], axis=1))


def _square(half_width: tuple[float, float]) -> tuple[Array, Array]:
    side = np.linspace(-1, 1, _ACROSS)
    x, y = np.meshgrid(side * half_width[0], side * half_width[1])
    return x.ravel(), y.ravel()


def _free_reach(stations: Sequence[Array], number: int, element: Element) -> float:
    """How far from the axis of an element its plane meets no other light of the train."""
    nearest = math.inf
    for before in range(len(stations) - 1):
        if number + 1 in (before, before + 1):
            continue
        start, end = (
            element.seen(points) - [0.0, 0.0, element.position[2]]
            for points in stations[before : before + 2]
        )
        start, end = np.broadcast_arrays(start[:, None], end[None, :])
        crosses = start[..., 2] * end[..., 2] < 0
        start, end = start[crosses], end[crosses]
        part = start[:, 2:] / (start[:, 2:] - end[:, 2:])
        places = np.abs(start + part * (end - start))[:, :2].max(axis=1)
        nearest = min(nearest, float(places.min(initial=math.inf)))
    return _CLEAR * nearest


def _mesh(placed: _Placed, points: Array, material: Any, normals: Array | None = None) -> Any:
    """Points (m, n, 3) of the scene as triangles; counterclockwise if they run along x and y."""
    mi, triangles = placed.mi, _triangles(points.shape[0], points.shape[1])
    properties = mi.Properties()
    properties["bsdf"] = material
    mesh = mi.Mesh(
        "",
        points.size // 3,
        len(triangles),
        props=properties,
        has_vertex_normals=normals is not None,
    )
    content = mi.traverse(mesh)
    content["vertex_positions"] = placed.coordinates.places(points).astype(np.float32).ravel()
    content["faces"] = triangles.ravel()
    if normals is not None:
        content["vertex_normals"] = placed.coordinates.vectors(normals).astype(np.float32).ravel()
    content.update()
    return mesh


def _rim(points: Array) -> Array:
    """Border (m, 3) of a grid of points (m_x, m_y, 3), closed."""
    return np.concatenate([points[:-1, 0], points[-1, :-1], points[:0:-1, -1], points[0, ::-1]])


def _triangles(rows: int, columns: int) -> Indices:
    """Two for each cell of a grid of vertices."""
    index = np.arange(rows * columns, dtype=np.uint32).reshape(rows, columns)
    a, b = index[:-1, :-1].ravel(), index[1:, :-1].ravel()
    c, d = index[1:, 1:].ravel(), index[:-1, 1:].ravel()
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


_KINDS: Mapping[type, Callable[[_Placed, Any], Shapes]] = {
    Lens: _lens,
    Mirror: _mirror,
    Diffuser: _diffuser,
}
