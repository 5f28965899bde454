"""Parallel light."""

from collections.abc import Iterator

import numpy as np

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import Cells
from workbench.analysis.tracing.sources.unspread import Unspread
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.scene import CollimatedSource, Element


class CollimatedLight(Unspread):
    """Parallel light; a `LightSource`.

    It has no edge: it fills the entrance face however that stands. The parameters are those of
    `light_source`.
    """

    def __init__(
        self, source: CollimatedSource, optic: Element, pose: Pose, rays: int, seed: int
    ) -> None:
        r_x, r_y = optic.half_width
        self._outline = outline_of(optic)
        self._direction = pose.ways(source.directions(np.zeros(1), np.zeros(1)))
        self._cells = Cells(rays, r_x / r_y, seed)
        self.rays = self._cells.count
        # Of the rectangle around the lens, all is lit, and rays are drawn on the glass alone.
        self.origins, self.emitted = 1, 4 * r_x * r_y
        self.beside = self.emitted / self._outline.area - 1

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin on the entrance face; see `RandomSource.batch`."""
        for a, b in self._cells.batch(number):
            position = np.zeros((len(a), 3))
            position[:, 0], position[:, 1] = self._outline.evenly(a, b)
            yield TracedRays(position, self._direction, np.ones(len(a)))

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays through places of the entrance face; see `FaceLight.through`."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        return TracedRays(position, self._direction, np.ones_like(x))
