"""Lens, rays and receivers in the 3D view.

Right-handed axes: z, the optical axis, runs to the right of the default view, y up. The camera
stands beyond the exit face: the screen is seen from behind and reads as its image does, x to the
right, row 0 at the top.

1. `LensPicture.update` moves points and repaints textures of existing actors. Adding the actors
   again costs ten times as much.
2. Glass is drawn before rays and without depth peeling, which is slow in software OpenGL.
3. A source so far away that lens and screen would shrink to nothing is left out of the view, and
   its rays start nearer, on their line.
4. Nothing here renders: the caller decides when.
"""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
import pyvista as pv
from matplotlib import colormaps

from workbench.arrays import Array, Mask
from workbench.pictures import meshes
from workbench.pictures.actors import ColourScale, LitReceiver, add_to
from workbench.pictures.camera import FittedCamera, drawn_start_z, source_in_view
from workbench.pictures.compressed import compress_distances, compress_paths
from workbench.pictures.elements import DesignedElement, add_fixed_elements
from workbench.pictures.surface import (
    FaceColours,
    colour_scale_of,
    scale_top,
)
from workbench.scene import Scene, Source

if TYPE_CHECKING:
    from workbench.optics.paths import RayPaths

_SOURCE_POINTS = (25, 25)  # most points of a grid that are drawn
_INK = {True: "#b4bcc8", False: "#475060"}  # by dark
_GROUND = {
    True: ("#12151a", "#2a303a"),
    False: ("#dfe4eb", "#fcfdfe"),
}  # bottom and top of the background
_ARRIVING = {True: (255, 206, 110), False: (196, 122, 0)}  # light that reaches the screen
_LOST = {True: (255, 90, 90), False: (200, 30, 30)}
_WEIGHT = {True: "viridis", False: "viridis_r"}  # maps from no light to all of it
_FADING = 0.05, 0.12  # opacity of the start and the end of a ray, relative to its middle


class LensPicture:
    """Draws a scene on a plotter of the caller; until `update`, faces have their base shape.

    `plotter`: empty plotter, off screen or in a window; `target` (n_y, n_x): target image; the
    brightness of the screen is relative to it; `dark`: dark background; `explode`: compress
    distances; `perspective`: perspective instead of parallel projection; `by_weight`: colour rays
    by their transmittance instead of by where they end.
    """

    def __init__(
        self,
        plotter: Any,
        scene: Scene,
        target: npt.NDArray[Any],
        *,
        dark: bool = False,
        explode: bool = False,
        perspective: bool = False,
        by_weight: bool = False,
    ) -> None:
        self._plotter = plotter
        self._traced, self._explode = scene, explode
        self._scene = compress_distances(scene) if explode else scene  # as it is drawn
        self._colours = ""
        self._face_colours: FaceColours = "material"
        self._exaggerated, self._title = False, ""
        self._beyond: Mapping[str, Mask] = {}
        self._dark = dark
        self._by_weight = by_weight
        self._lines: list[Any] = []
        self._scale = ColourScale(plotter)
        self._camera = FittedCamera(plotter, self._scene, perspective=perspective)
        self._designed = [DesignedElement(self._add, optic) for optic in self._scene.optics]
        for element in self._designed:
            self._lines += element.lines
        self._lines += add_fixed_elements(self._add, self._scene)
        self._add_receivers(target)
        self._add_source()
        self._add_axis()
        self._rays = pv.PolyData(np.zeros((4, 3)), lines=[4, 0, 1, 2, 3])
        self._rays.point_data["colour"] = np.zeros((4, 4), dtype=np.uint8)
        self._arriving = np.zeros(1, dtype=bool)
        self._weight = np.zeros(1)
        self._light = self._add(
            self._rays, scalars="colour", rgba=True, line_width=1.0, lighting=False
        )
        self.recolour(dark)

    def update(
        self,
        surfaces: Mapping[str, Array],
        paths: "RayPaths",
        irradiance: Array,
        source: Source | None = None,
        further: Sequence[Array] = (),
    ) -> None:
        """Show another state of the same scene; the camera stays.

        `surfaces` (m_u, m_v, 3): points of each freeform face on a grid including its rim; see
        `sample_faces`; `paths`: rays from source to receiver; `irradiance` (n_y, n_x): flux per
        area on the receiver, row 0 at +y; `source`: source of the rays, if a stage of the run has
        its own; `further` (n_y, n_x): flux per area at the receiver of each further image.
        """
        lit = self._traced.model_copy(update={"source": source or self._traced.source})
        points = paths.points
        if self._explode:
            points, lit = compress_paths(points, lit), compress_distances(lit)
        self._place_elements(surfaces)
        self._place_source(lit)
        self._place_rays(paths._replace(points=points), lit)
        for receiver, light in zip(self._receivers, (irradiance, *further), strict=True):
            receiver.paint(light, self._colours)
        self._plotter.renderer.ResetCameraClippingRange()

    @property
    def camera(self) -> FittedCamera:
        """The camera."""
        return self._camera

    def fit(self, view: str = "") -> None:
        """Turn the camera to one of `VIEWS`, by default the three-quarter view."""
        self._camera.fit(view)

    def fit_again(self) -> None:
        """Fit the same view again, after the window changed its size."""
        self._camera.fit(self._camera.view)

    def project(self, perspective: bool) -> None:
        """Set perspective or parallel projection."""
        self._camera.project(perspective)

    def colour_rays(self, by_weight: bool) -> None:
        """Colour rays by transmittance, or by where they end."""
        self._by_weight = by_weight
        self._colour_rays()

    @property
    def fitted(self) -> bool:
        """Whether the camera is where `fit` put it."""
        return self._camera.untouched

    def set_colours(self, name: str) -> None:
        """Set the colour map of receivers, used from the next update on."""
        self._colours = name

    def set_faces(
        self,
        by: FaceColours,
        exaggerated: bool,
        title: str = "",
        beyond: Mapping[str, Mask] = MappingProxyType({}),
    ) -> None:
        """Set colours and shading of faces, used from the next update on; see `face_colours`."""
        self._face_colours, self._exaggerated, self._title = by, exaggerated, title
        self._beyond = beyond

    def recolour(self, dark: bool) -> None:
        """Change between dark and light background."""
        self._dark = dark
        bottom, top = _GROUND[dark]
        self._plotter.set_background(bottom, top=top)
        for actor in self._lines:
            actor.prop.color = _INK[dark]
        self._scale.recolour(_INK[dark])
        for actor in (self._source, self._glow):
            actor.prop.color = _ARRIVING[dark]
        self._colour_rays()

    def _add(self, mesh: pv.PolyData, *, body: bool = False, **style: Any) -> Any:
        return add_to(self._plotter, mesh, **style, pickable=body)

    def _place_elements(self, surfaces: Mapping[str, Array]) -> None:
        by = self._face_colours
        top = scale_top(surfaces.values(), by)
        self._scale.show(colour_scale_of(by, top, self._scene.unit), self._title)
        for element in self._designed:
            element.place(surfaces, by, top, self._exaggerated, self._beyond)
            self._camera.tops[element.optic.name] = element.top

    def _add_receivers(self, target: npt.NDArray[Any]) -> None:
        images = self._traced.wanted(target)
        self._receivers = [
            LitReceiver(self._add, receiver, self._scene.elements[-1], image)
            for receiver, image in zip(self._scene.receivers, images, strict=True)
        ]
        self._lines += [receiver.frame for receiver in self._receivers]

    def _add_source(self) -> None:
        self._places = pv.PolyData(np.zeros((1, 3)))
        # Sizes in pixels: as easy to see beside a large screen as beside a small lens.
        self._source = self._add(
            self._places, style="points", render_points_as_spheres=True, lighting=False
        )
        self._emitter = pv.PolyData(np.zeros((1, 3)))
        # Its rim is drawn too: the disc of the sun would be narrower than a pixel.
        self._glow = self._add(self._emitter, line_width=4.0, lighting=False)
        self._place_source(self._scene)

    def _place_face(self, lit: Scene) -> None:
        face = lit.source.face(lit.first, drawn_start_z(lit))
        self._glow.SetVisibility(face.size > 0)
        if not face.size:  # VTK takes no empty arrays
            return
        rim = meshes.rim_places(*face.shape[:2])
        self._emitter.points = face.reshape(-1, 3)
        self._emitter.faces = meshes.quads(*face.shape[:2])
        self._emitter.lines = meshes.polylines([rim])
        self._emitter.verts = np.zeros(0, dtype=np.int64)

    def _place_source(self, lit: Scene) -> None:
        source = lit.source
        self._place_face(lit)
        shown = source_in_view(lit)
        self._source.SetVisibility(shown)
        if not shown:
            return
        places = source.seen(_SOURCE_POINTS)
        if not np.array_equal(places, self._places.points):
            self._places.points = places
            self._places.verts = np.insert(np.arange(len(places)), np.arange(len(places)), 1)
        self._source.prop.point_size = 14.0 if len(places) == 1 else 4.0

    def _place_rays(self, paths: "RayPaths", lit: Scene) -> None:
        count = len(paths.weight)
        self._light.SetVisibility(count > 0)
        if not count:  # VTK takes no empty arrays
            return
        points = paths.points.copy()
        points[:, 0] = meshes.starting_at(points[:, 0], points[:, 1], drawn_start_z(lit))
        places = points.shape[1]  # of each ray: where it begins, meets each face, and ends
        if points.size != self._rays.points.size or count != self._rays.n_cells:
            ends = np.arange(places * count).reshape(count, places)
            self._rays.copy_from(
                pv.PolyData(points.reshape(-1, 3), lines=np.insert(ends, 0, places, axis=1).ravel())
            )
        self._rays.points = points.reshape(-1, 3)
        self._arriving, self._weight = paths.on_screen, paths.weight
        self._colour_rays()

    def _colour_rays(self) -> None:
        colours = np.empty((len(self._weight), 4), dtype=np.uint8)
        if self._by_weight:
            colours[:, :3] = 255 * colormaps[_WEIGHT[self._dark]](self._weight)[:, :3]
        else:
            colours[:, :3] = np.where(
                self._arriving[:, None], _ARRIVING[self._dark], _LOST[self._dark]
            )
        # Lost rays have little or no weight and must still be visible; many rays get less opacity.
        ink = 255 * min(1.0, 7 / math.sqrt(max(len(self._weight), 1)))
        colours[:, 3] = ink * np.where(self._arriving, 0.25 + 0.75 * self._weight, 0.5)
        # Fading ends leave image and source visible.
        along = np.repeat(colours[:, None], self._rays.n_points // len(colours), axis=1)
        along[:, [0, -1], 3] = np.multiply(_FADING, along[:, [0, -1], 3])
        self._rays.point_data["colour"] = along.reshape(-1, 4)

    def _add_axis(self) -> None:
        optical = pv.lines_from_points(_axis(self._scene))
        self._lines.append(self._add(optical, line_width=1.0, opacity=0.6, lighting=False))


def _axis(scene: Scene) -> Array:
    """Points (n, 3) of the optical axis: straight, or from element to element where one is tilted.

    A receiver beside a straight axis is not on it.
    """
    outline = scene.receiver.outline(scene.elements[-1])
    start, end = drawn_start_z(scene), float(outline[..., 2].max())
    if not any(any(element.tilt) for element in scene.elements):
        return np.array([[0.0, 0.0, start], [0.0, 0.0, end]])
    first = [scene.elements[0].position[0], scene.elements[0].position[1], start]
    last = outline.reshape(-1, 3).mean(axis=0)
    return np.array([first, *(element.position for element in scene.elements), last])
