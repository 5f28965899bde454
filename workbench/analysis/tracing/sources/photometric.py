"""Light of a small lamp whose intensity by direction stands in a file."""

from collections.abc import Iterator

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES, Cells
from workbench.analysis.tracing.sources.near import near_places
from workbench.analysis.tracing.sources.turning import file_axes
from workbench.analysis.tracing.sources.unspread import Unspread
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.measured.lamps import intensity_of
from workbench.scene import Element, PhotometricSource


class PhotometricLight(Unspread):
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
