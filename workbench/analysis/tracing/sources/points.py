"""Light of one point, or of a grid of points that stands for an extended source."""

import math
from collections.abc import Iterator

import numpy as np

from workbench.analysis.tracing.elements import LightSource, TracedRays
from workbench.analysis.tracing.kernels import emit
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cones import Cones, covering_cones, powers
from workbench.analysis.tracing.sources.sampling import Cells
from workbench.arrays import Array
from workbench.scene import Element, LightOfPoints


class PointLight(LightSource):
    """Light into the cones that just cover the entrance face; a `LightSource`.

    All points have the same intensity, so those that see the face larger emit more. The parameters
    are those of `light_source`.
    """

    beside = 0.0

    def __init__(
        self, source: LightOfPoints, optic: Element, pose: Pose, rays: int, seed: int
    ) -> None:
        self._seed = seed
        # Flux goes with the cosine to this; even light has none.
        lambertian = source.emission == "lambertian"
        self._upwards = pose.axis() if lambertian else np.zeros(3)
        self.places: Array = pose.to_lens(source.positions, optic.front_z)
        cones = covering_cones(self.places, optic.half_width, 0.0)
        # In one order of memory always, or the loops would be compiled for each.
        self._cones = Cones(*map(np.ascontiguousarray, cones))
        self._cells = Cells(rays, 1.0, seed)
        self.rays = self._cells.count
        self.origins = len(self.places)
        self.emitted = float(powers(cones, self._upwards).sum())

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin in the plane of the entrance face; see `RandomSource.batch`.

        A point may be so far that only the first digits of a way from there would be right.
        """
        cones = len(self._cones.axis)
        shuffle = np.random.default_rng([self._seed, 100 + number])
        for a, b in self._cells.batch(number):
            # As many rays from each point as from any other, but for one.
            from_point = shuffle.permutation(len(a)) + shuffle.integers(cones)
            rays = TracedRays(np.empty((len(a), 3)), np.empty((len(a), 3)), np.empty(len(a)))
            emit(self._cones, from_point % cones, a, b, self._upwards, *rays)
            yield rays

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays of a point through places of the entrance face; see `FaceLight.through`.

        Intensity is 1 / 2π, so that an even cone has the power of its versine.
        """
        position = np.column_stack([x, y, np.zeros_like(x)])
        direction = position - self.places[origin]
        distance = np.linalg.norm(direction, axis=1)
        direction /= distance[:, None]
        flux = direction[:, 2] / (2 * math.pi * distance**2)
        if self._upwards.any():
            flux *= (direction @ self._upwards).clip(min=0)
        return TracedRays(position, direction, flux)
