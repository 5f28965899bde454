"""Elements of a train in the 3D view: those that the design shapes, and the others."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
import pyvista as pv

from workbench.arrays import Array, Mask
from workbench.geometry.face_grids import element_sides, face_points
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.pictures import meshes
from workbench.pictures.surface import FaceColours, face_colours, lit_normals
from workbench.scene import Element, Scene

Style = Mapping[str, Any]
Add = Callable[..., Any]

_NONE: meshes.Cells = np.zeros(0, dtype=np.int64)
_NET_FIELDS = 8
_BASE_SAMPLES = 33  # per axis, of the base shown until the first update
_SAMPLES = 49  # per axis, of each fixed face
# By `Element.called`; other kinds look like glass.
_BODIES: Mapping[str, Style] = {
    "lens": {"color": "#8fc1e8", "opacity": 0.07, "ambient": 0.3},
    "mirror": {"color": "#59616d", "opacity": 1.0, "ambient": 0.3},
}
_FACES: Mapping[str, Style] = {
    "lens": {"color": "#8fc1e8", "opacity": 0.16, "ambient": 0.05, "specular": 0.5},
    "mirror": {"color": "#aab2bd", "opacity": 1.0, "ambient": 0.3, "specular": 0.6},
}
_COLOURED = 0.92, 0.2  # opacity and gloss of faces whose colours are values
# Schlick's approximation of the Fresnel reflectance, and lamps in rows that show a low relief.
_REFLECTION = """//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 mirrored = reflect(-toEye, normalVCVSOutput);
  float grazing = pow(1.0 - abs(dot(normalVCVSOutput, toEye)), 3.0);
  float lamps = 0.5 + 0.5 * sin(14.0 * (mirrored.y + 0.5 * mirrored.x));
  float reflected = gloss * min(0.75 * grazing + 0.22 * lamps * lamps, 1.0);
  fragOutput0.rgb = mix(fragOutput0.rgb, vec3(0.80, 0.91, 1.0), reflected);
  fragOutput0.a = mix(opacity, 1.0, reflected);
"""


def _style_of(styles: Mapping[str, Style], element: Element) -> Style:
    return styles.get(element.called, styles["lens"])


def _add_body(add: Add, mesh: pv.PolyData, **style: Any) -> Any:
    """Add a part of an element, which reflects more at grazing angles, as glass and metal do."""
    actor = add(mesh, body=True, **style)
    if mesh.point_data.active_normals is not None:
        actor.prop.interpolation = "Phong"  # by normals of points; flat shading has none
    shader = actor.GetShaderProperty()
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, _REFLECTION, False)
    shader.GetFragmentCustomUniforms().SetUniformf("gloss", 1.0)
    return actor


class DesignedElement:
    """An element with freeform faces that `place` moves; at first they have their base shape.

    ``add`` is `LensPicture._add`; ``lines`` are the actors of nets and edges.
    """

    def __init__(self, add: Add, optic: Element) -> None:
        self.optic, self.lines = optic, list[Any]()
        nets, points = freeform_nets(optic), np.zeros((1, 3))
        self._walls, self._edges = pv.PolyData(points), pv.PolyData(points)
        self._faces = {face: (pv.PolyData(points), pv.PolyData(points)) for face in nets}
        self._front = pv.PolyData(points)  # a fixed one that is curved
        self._front_z: Array | None = None
        self._samples = (0, 0)
        body, style = _style_of(_BODIES, optic), dict(_style_of(_FACES, optic))
        self._material, self._opacity = style.pop("color"), style["opacity"]
        self._shaped = list[Any]()
        side = np.linspace(-1, 1, _BASE_SAMPLES)
        x, y = outline_of(optic).from_square(side[:, None], side)
        base = {face: np.stack([x, y, optic.place_of(face, x, y)], axis=-1) for face in nets}
        self.place(base, "material", 1.0, exaggerated=False)
        actors = [_add_body(add, self._walls, **body)]
        if self._curved_front:
            actors.append(_add_body(add, self._front, **body))
        for face, net in self._faces.values():
            shaded = {"diffuse": 0.9, "specular_power": 30, **style}
            actor = _add_body(add, face, scalars="colour", rgb=True, **shaded)
            actor.prop.color = self._material
            self.lines.append(add(net, line_width=1.0, opacity=0.25, lighting=False))
            self._shaped.append(actor)
        self.lines.append(add(self._edges, line_width=1.5, lighting=False))
        for actor in [*actors, *self._shaped, *self.lines]:
            actor.user_matrix = _place_of(optic)

    @property
    def _curved_front(self) -> bool:
        return self._front_z is not None and float(np.ptp(self._front_z)) > 0

    def place(
        self,
        surfaces: Mapping[str, Array],
        by: FaceColours,
        top: float,
        exaggerated: bool,
        beyond: Mapping[str, Mask] = MappingProxyType({}),
    ) -> None:
        """Move its faces to points on grids, see `sample_faces`; colours as by `face_colours`."""
        optic, surface = self.optic, surfaces[self.optic.designed_face]
        self.top = float(surface[..., 2].max())
        m_u, m_v = count = surface.shape[:2]
        anew, self._samples = count != self._samples, count
        if anew:
            self._place_front(m_u, m_v)
        walls = meshes.wall_points(surface, self._other_z(surfaces, surface))
        for mesh in (self._walls, self._edges):
            mesh.points = walls
        for face, (mesh, net) in self._faces.items():
            mesh.points = net.points = surfaces[face].reshape(-1, 3)
            if anew:
                mesh.faces = meshes.quads(m_u, m_v)
                net.lines = meshes.net_lines(m_u, m_v, _NET_FIELDS)
                mesh.verts = net.verts = _NONE
            mesh.point_data["colour"] = face_colours(
                surfaces[face], by, self._material, top, beyond.get(face)
            )
            mesh.point_data.active_normals = lit_normals(surfaces[face], exaggerated)
        for actor in self._shaped:
            look = (self._opacity, 1.0) if by == "material" else _COLOURED
            actor.prop.opacity = look[0]
            actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniformf("gloss", look[1])
        if anew:
            straight, flat = outline_of(optic).whole, len(self._faces) == 1
            flat = flat and not self._curved_front
            self._walls.faces = meshes.wall_faces(m_u, m_v, straight, flat=flat)
            self._edges.lines = meshes.wall_lines(m_u, m_v, straight, flat=flat)
            self._walls.verts = self._edges.verts = _NONE

    def _place_front(self, m_u: int, m_v: int) -> None:
        front, *others = self.optic.placed_faces
        if not others or front.face.designed:
            return
        u, v = np.linspace(-1, 1, m_u), np.linspace(-1, 1, m_v)
        points = face_points(self.optic.straightened, front, u, v, {})
        self._front_z = points[..., 2]
        self._front.points = points.reshape(-1, 3)
        self._front.verts = _NONE
        self._front.faces = meshes.quads(m_u, m_v)
        self._front.point_data.active_normals = meshes.normals(points)

    def _other_z(self, surfaces: Mapping[str, Array], surface: Array) -> Array | float:
        """The z of the side opposite to `Element.designed_face`."""
        if self.optic.designed_front is not None:
            return surfaces[self.optic.designed_front][..., 2]
        return self.optic.flat_z(surface[..., 2]) if self._front_z is None else self._front_z


def _place_of(optic: Element) -> Array:
    """Matrix (4, 4) that takes points of an element to the scene; see `Element.in_scene`."""
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = optic.turn, optic.origin
    return place


def add_fixed_elements(add: Add, scene: Scene) -> list[Any]:
    """Draw all elements that the design leaves as they are; return the actors of their edges."""
    return [_add_fixed(add, element) for element in scene.elements if not element.designed]


def _add_fixed(add: Add, element: Element) -> Any:
    style = _style_of(_BODIES, element)
    side = np.linspace(-1, 1, _SAMPLES)
    front, back = element_sides(element, side, side, {})
    for face in (front, back):
        surface = pv.PolyData(face.reshape(-1, 3), faces=meshes.quads(_SAMPLES, _SAMPLES))
        surface.point_data.active_normals = meshes.normals(face)
        _add_body(add, surface, **style)
    rims = np.stack([meshes.rim(face) for face in (front, back)])
    count = rims.shape[1]
    walls = pv.PolyData(rims.reshape(-1, 3), faces=meshes.quads(2, count))
    _add_body(add, walls, **style)
    index = np.arange(2 * count).reshape(2, count)
    lines = [index[0], index[1]]
    if outline_of(element).whole:
        lines += list(index[:, :: _SAMPLES - 1].T)  # at the corners
    outline = pv.PolyData(rims.reshape(-1, 3), lines=meshes.polylines(lines))
    return add(outline, line_width=1.5, lighting=False)
