"""Light of measured rays, which are followed themselves."""

from collections.abc import Iterator

import numpy as np

from workbench import units
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.sources.turning import file_axes
from workbench.analysis.tracing.sources.unspread import Unspread
from workbench.arrays import Array
from workbench.measured.lamps import ray_model, rays_of
from workbench.scene import Element, RayFileSource

_AT_ONCE = 1 << 15
# Points that stand for the rays where cells ask for light.
_POINTS = 64
_FEET = 12 * units.METRES["inch"]


class RayFileLight(Unspread):
    """Rays of a file, as many as are asked for or all; a `LightSource`.

    Cells, which need light at any place, have that of the points that stand for the rays: how far
    their image is from that of the rays tells what this leaves out. The parameters are those of
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
