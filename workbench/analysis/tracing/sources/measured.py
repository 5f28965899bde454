"""Light of lamps of files: of a small lamp by its intensity, and of measured rays."""

from collections.abc import Iterator

import numpy as np
from scipy.interpolate import RegularGridInterpolator
from scipy.spatial.transform import Rotation

from workbench import units
from workbench.analysis.tracing.elements import LightSource, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES, Cells, near_places
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.measured.lamps import intensity_of, ray_model, rays_of
from workbench.scene import Element, PhotometricSource, RayFileSource


def file_axes(degrees: tuple[float, float, float]) -> Rotation:
    """Return the rotation about x, new y and new z from the axes of a file to the scene's."""
    return Rotation.from_euler("XYZ", degrees, degrees=True)


class PhotometricLight(LightSource):
    """Light of one point, of which rays through the entrance face are drawn; a `LightSource`.

    What goes elsewhere is one ray of each batch that misses the face. From a point that is near,
    rays go to places that are as dense as its light. The parameters are those of `light_source`.
    """

    beside = 0.0

    def __init__(
        self, source: PhotometricSource, optic: Element, pose: Pose, rays: int, seed: int
    ) -> None:
        r_x, r_y = optic.half_width
        self._outline, self._half_width, self._beside = outline_of(optic), (r_x, r_y), 2 * r_x
        self._point = pose.to_lens(np.array([source.position]), optic.front_z)[0]
        # Directions as the lens sees them, into those of the file.
        turned = file_axes(source.rotation)
        to_scene, _ = pose.to_scene(optic.front_z)
        self._to_file = turned.inv().as_matrix() @ to_scene
        table = intensity_of(source)
        self._intensity = RegularGridInterpolator(
            (table.c, table.gamma), table.candela, bounds_error=False, fill_value=0.0
        )
        self._cells = Cells(rays, r_x / r_y, seed)
        self.rays = self._cells.count + BATCHES
        self.origins, self.emitted, self.places = 1, table.lumens, self._point[None]
        self._near = -self._point[2] < max(r_x, r_y)

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin on the entrance face; see `RandomSource.batch`."""
        missing = self.emitted / BATCHES
        for a, b in self._cells.batch(number):
            x, y, area = self._places(a, b)
            rays = self.through(0, x, y)
            # Each ray stands for so much of the face, in all batches together.
            rays.flux[:] *= area / self._cells.count
            missing -= float(rays.flux.sum())
            yield rays
        # Rays are drawn, so their sum scatters about the light that meets the face. Where that is
        # all light, the sum of a batch may be more, and nothing passes the face by: the account of
        # the batch is then of what its rays have.
        beside = np.array([[self._beside, 0.0, 0.0]])
        yield TracedRays(beside, np.array([[0.0, 0.0, 1.0]]), np.array([max(missing, 0.0)]))

    def _places(self, a: Array, b: Array) -> tuple[Array, Array, Array | float]:
        """Places for pairs that fill a square evenly, and areas whose mean is that of the face."""
        if self._near:
            return near_places(a, b, self._point[None], self._half_width)
        return *self._outline.evenly(a, b), self._outline.area

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays through places of the entrance face; see `FaceLight.through`."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        way = position - self._point
        square = np.einsum("ij,ij->i", way, way)
        direction = way / np.sqrt(square)[:, None]
        seen = direction @ self._to_file.T
        # Counterclockwise for who looks against the light: the nadir is +z.
        c = np.rad2deg(np.arctan2(-seen[:, 1], seen[:, 0])) % 360
        gamma = np.rad2deg(np.arccos(seen[:, 2].clip(-1, 1)))
        flux = self._intensity(np.column_stack([c, gamma])) * direction[:, 2].clip(min=0) / square
        return TracedRays(position, direction, flux)


_AT_ONCE = 1 << 15
# Points that stand for the rays where cells ask for light.
_POINTS = 64
_FEET = 12 * units.METRES["inch"]


class RayFileLight(LightSource):
    """Rays of a file, as many as are asked for or all; a `LightSource`.

    Cells, which need light at any place, have that of the points that stand for the rays: how far
    their image is from that of the rays shows what this leaves out. The parameters are those of
    `light_source`.
    """

    beside, sampled = 0.0, True

    def __init__(
        self, source: RayFileSource, optic: Element, pose: Pose, rays: int, seed: int
    ) -> None:
        found = rays_of(source)
        count = len(found.flux)
        order = np.random.default_rng([seed, 25]).permutation(count)
        self._chosen = order[: min(max(rays, BATCHES), count)]
        self.rays = len(self._chosen)
        self._found, self._pose, self._z = found, pose, optic.front_z
        unit = source.file_unit or found.unit or source.unit
        metres = _FEET if unit == "feet" else units.METRES[unit]
        self._scale = float(metres / units.METRES[source.unit])
        self._turn, self._place = file_axes(source.rotation), np.array(source.position)
        self._beside = 2 * optic.half_width[0]
        self._model = ray_model(source, optic, _POINTS)
        self._to_scene, _ = pose.to_scene(optic.front_z)
        self.places: Array = pose.to_lens(self._model.places, optic.front_z)
        self.origins, self.emitted = len(self.places), 1.0

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays where they come to the plane of the entrance face; see `RandomSource.batch`."""
        mine = self._chosen[number::BATCHES]
        for first in range(0, len(mine), _AT_ONCE):
            some = mine[first : first + _AT_ONCE]
            start = self._scale * self._found.position[some].astype(np.float64)
            start = self._pose.to_lens(self._turn.apply(start) + self._place, self._z)
            way = self._turn.apply(self._found.direction[some].astype(np.float64))
            way = way @ self._to_scene  # as the lens sees it: its turn undone
            come = (way[:, 2] > 0) & (start[:, 2] <= 0)
            far = np.where(come, -start[:, 2], 0.0) / np.where(come, way[:, 2], 1.0)
            position = start + far[:, None] * way
            position[:, 2] = 0.0
            # What never comes there is as if it passed by.
            position[~come], way[~come] = [self._beside, 0.0, 0.0], [0.0, 0.0, 1.0]
            yield TracedRays(position, way, self._found.flux[some].astype(np.float64))

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Light of one of the points that stand for the rays; see `FaceLight.through`."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        way = position - self.places[origin]
        square = np.einsum("ij,ij->i", way, way)
        direction = way / np.sqrt(square)[:, None]
        x_scene, y_scene, z_scene = (direction @ self._to_scene.T).T
        number = np.full(len(x), origin)
        flux = self._model.intensity(number, (x_scene, y_scene, z_scene))
        return TracedRays(position, direction, flux * direction[:, 2].clip(min=0) / square)
