"""Light of one point, or of a grid of points that stands for an extended source."""

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.emission import emit
from workbench.optics.entering import intensity_of
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.origins import Origins, TurnedPattern, splits_of, through_cells
from workbench.scene import Element, LightOfPoints


class PointEmitter:
    """Rays into the cones that just cover the entrance face; an `Emitter`.

    `source`: where the points are, and how they emit; `optic`: gives the entrance face; `samples`:
    corners of cells of the first freeform face; rays drawn at random by default.
    """

    beside = 0.0

    def __init__(
        self,
        source: LightOfPoints,
        optic: Element,
        samples: Samples | None = None,
    ) -> None:
        self.source, self.optic, self.samples = source, optic, samples

    @property
    def by_area(self) -> bool:
        """See `Emitter`."""
        return isinstance(self.samples, Corners)

    @property
    def origins(self) -> Origins:
        """See `Emitter`."""
        points = self.source.positions
        intensity = np.full(len(points), intensity_of(self.source, self.optic))
        lambertian = self.source.emission == "lambertian"
        if lambertian and self.source.turn is not None:
            pattern = TurnedPattern(self.source.facing, lambertian)
            return Origins(points, False, intensity, pattern=pattern)
        return Origins(points, False, intensity, lambertian)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`; points come one after the other along y."""
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        return splits_of(self.samples, (1, len(self.source.positions)))

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays drawn by the seed, or at corners of cells; see `Emitter.rays`."""
        if isinstance(self.samples, Corners):
            return through_cells(self.origins, self.optic, self.samples)
        rays = emit(self.source, self.optic, seed, draw)
        onto_face = np.column_stack([rays.crossing, np.full(len(rays.flux), self.optic.front_z)])
        return _bundle(onto_face, rays.direction, rays.flux)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the middle of the source and its corners in turn; see `Emitter.towards`."""
        corners = np.vstack([self.source.place, self.source.corners])
        place = np.column_stack([x, y, np.full(len(x), self.optic.front_z)])
        origin = corners[np.arange(len(place)) % len(corners)]
        direction = place - origin
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        return _bundle(origin, direction, np.full(len(place), 1 / len(place)))


def _bundle(origin: Array, direction: Array, flux: Array) -> RayBundle:
    alive = torch.ones(len(flux), dtype=torch.bool)
    return RayBundle(_vector(origin), _vector(direction), torch.as_tensor(flux), alive)


def _vector(rows: Array) -> Vector:
    x, y, z = torch.as_tensor(rows).unbind(1)
    return x.contiguous(), y.contiguous(), z.contiguous()
