"""Point sources, grids of points that stand for extended sources, and ray files."""

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Index
from workbench.measured.lamps import placed_rays, ray_model
from workbench.measured.rays.model import RayModel
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.emission import emit, intensity_of
from workbench.optics.sources.origins import (
    Origins,
    TurnedPattern,
    splits_of,
    through_cells,
    vector,
)
from workbench.scene import Element, LightOfPoints, RayFileSource


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


# Points that stand for the rays where nothing says how many.
_POINTS = 16


class ModelPattern:
    """Intensity of points that stand for rays; a `Pattern`."""

    def __init__(self, model: RayModel) -> None:
        self._model = model

    def at(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """See `Pattern.at`."""
        return self._model.intensity(origin, direction)


class RayFileEmitter:
    """Light of a ray file; an `Emitter`.

    All light of the file is 1, what goes elsewhere than to the lens included. At corners of cells
    it is that of as many points as `Corners` says. The parameters are those of `emitter_of`.
    """

    beside = 0.0

    def __init__(
        self, source: RayFileSource, optic: Element, samples: Samples | None = None
    ) -> None:
        self._source, self._lens, self.samples = source, optic, samples
        count = samples.origins if isinstance(samples, Corners) else _POINTS
        self._model = model = ray_model(source, optic, count if source.continuous else 1)
        points = self._model.places
        self.origins = Origins(
            points, False, np.ones(len(points)), pattern=ModelPattern(model), note=model.note
        )

    @property
    def by_area(self) -> bool:
        """Where they are corners of cells; see `Emitter`."""
        return isinstance(self.samples, Corners)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`."""
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        return splits_of(self.samples, (1, len(self.origins.places)))

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays of the file drawn by the seed, or beams at corners; see `Emitter.rays`."""
        if isinstance(self.samples, Corners):
            beams = through_cells(self.origins, self._lens, self.samples)
            # As of `ExtendedEmitter`: the trapezoidal rule may have more than all light.
            return beams._replace(flux=beams.flux / beams.flux.sum().clamp_min(1))
        placed, z = placed_rays(self._source), self._lens.front_z
        x, y, come = placed.onto(z)
        count = self._source.rays
        if count < len(x):
            generator = np.random.default_rng([seed, draw])
            some = generator.choice(len(x), count, replace=False)
            placed = type(placed)(*(part[some] for part in placed))
            x, y, come = x[some], y[some], come[some]
        flux = torch.as_tensor(np.where(come, placed.flux / placed.flux.sum(), 0.0))
        direction = np.where(come[:, None], placed.direction, [0.0, 0.0, 1.0])
        place = vector((x, y, np.full(len(x), z)))
        return RayBundle(place, vector(tuple(direction.T)), flux, torch.as_tensor(come))

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the points in turn; see `Emitter.towards`."""
        origin = np.arange(len(x)) % len(self.origins.places)
        lit = self.origins.light(x.numpy(), y.numpy(), self._lens.front_z, origin)
        start = vector(tuple(self.origins.places[origin].T))
        lights = torch.as_tensor(lit.density > 0)
        flux = torch.where(lights, 1 / len(x), 0.0).double()
        return RayBundle(start, vector(lit.direction), flux, torch.ones_like(lights))
