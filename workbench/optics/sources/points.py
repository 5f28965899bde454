"""Sources of points: grids of them, ray files, and lamps with a measured intensity."""

import math
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Index
from workbench.measured.lamps import intensity_of as table_of
from workbench.measured.lamps import placed_rays, ray_model
from workbench.measured.photometry import IntensityTable
from workbench.measured.rays.model import RayModel
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Corners, Samples, counts
from workbench.optics.sources.emission import emit, intensity_of
from workbench.optics.sources.emitter import Emitter
from workbench.optics.sources.origins import EmittedLight, Origins, TurnedPattern, vector
from workbench.scene import Element, LightOfPoints, PhotometricSource, RayFileSource


class PointEmitter(Emitter):
    """Rays into the cones that just cover the entrance face."""

    def __init__(
        self, source: LightOfPoints, optic: Element, samples: Samples | None = None
    ) -> None:
        super().__init__(optic, samples)
        self.source = source

    @property
    def origins(self) -> Origins:
        """See `Emitter`."""
        points = self.source.positions
        intensity = np.full(len(points), intensity_of(self.source, self.optic))
        lambertian = self.source.emission == "lambertian"
        if lambertian and self.source.turn is not None:
            pattern = TurnedPattern(tuple(self.source.facing.tolist()), lambertian)
            return Origins(points, False, intensity, pattern=pattern)
        return Origins(points, False, intensity, lambertian)

    def _drawn(self, seed: int, draw: int) -> RayBundle:
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


class RayFileEmitter(Emitter):
    """Light of a ray file.

    All light of the file is 1, what goes elsewhere than to the lens included. At corners of cells
    it is that of as many points as `Corners` says.
    """

    def __init__(
        self, source: RayFileSource, optic: Element, samples: Samples | None = None
    ) -> None:
        super().__init__(optic, samples)
        self._source = source

    @cached_property
    def origins(self) -> Origins:
        """See `Emitter`."""
        source, samples = self._source, self.samples
        count = samples.origins if isinstance(samples, Corners) else _POINTS
        model = ray_model(source, self.optic, count if source.continuous else 1)
        flux, pattern = np.ones(len(model.places)), ModelPattern(model)
        return Origins(model.places, False, flux, pattern=pattern, note=model.note)

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays of the file drawn by the seed, or beams at corners; see `Emitter.rays`."""
        rays = super().rays(seed, draw)
        if self.by_area:
            # As of `ExtendedEmitter`: the trapezoidal rule may have more than all light.
            rays = rays._replace(flux=rays.flux / rays.flux.sum().clamp_min(1))
        return rays

    def _drawn(self, seed: int, draw: int) -> RayBundle:
        placed, z = placed_rays(self._source), self.optic.front_z
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
        lit = self.origins.light(x.numpy(), y.numpy(), self.optic.front_z, origin)
        start = vector(tuple(self.origins.places[origin].T))
        lights = torch.as_tensor(lit.density > 0)
        flux = torch.where(lights, 1 / len(x), 0.0).double()
        return RayBundle(start, vector(lit.direction), flux, torch.ones_like(lights))


class TurnedTable(NamedTuple):
    """Intensity of a lamp that is turned; a `Pattern`."""

    table: IntensityTable  # in the directions of the file
    # (9,), row after row, turns directions of the file into those of the scene.
    matrix: tuple[float, ...]

    def at(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """Intensity, cd; see `Pattern.at`."""
        matrix = np.reshape(self.matrix, (3, 3))
        return self.table.at(np.stack(np.broadcast_arrays(*direction), axis=-1) @ matrix)


def light_of_table(source: PhotometricSource) -> EmittedLight:
    """All light of a lamp, in the directions of the scene.

    Raises `Refused` if the file cannot be read or used.
    """
    return _turned(table_of(source), tuple(source.matrix.ravel().tolist()))


# Asked for by each plan of a run; tables differ by what they are, not by what they hold.
@lru_cache(maxsize=4)
def _turned(table: IntensityTable, matrix: tuple[float, ...]) -> EmittedLight:
    direction, lumens = table.flux_nodes
    return EmittedLight(direction @ np.reshape(matrix, (3, 3)).T, lumens / table.lumens)


class PhotometricEmitter(Emitter):
    """One point whose intensity is that of a file.

    All light of the lamp is 1, what goes elsewhere than to the lens included.
    """

    def __init__(
        self, source: PhotometricSource, optic: Element, samples: Samples | None = None
    ) -> None:
        super().__init__(optic, samples)
        self._source = source

    @cached_property
    def origins(self) -> Origins:
        """See `Emitter`."""
        source, table = self._source, table_of(self._source)
        pattern = TurnedTable(table, tuple(source.matrix.ravel().tolist()))
        return Origins(
            np.array([source.position]),
            False,
            np.array([1 / table.lumens]),
            pattern=pattern,
            note=table.note,
            emitted=light_of_table(source),
        )

    def _drawn(self, seed: int, draw: int) -> RayBundle:
        """Rays through low-discrepancy places of the face.

        No ray stands for light that passes the face by.
        """
        from scipy.stats import qmc  # late: it takes most of a second to import

        count = self._source.rays if self.samples is None else math.prod(counts(self.samples))
        sobol = qmc.Sobol(2, seed=np.random.default_rng([seed, draw]))
        across, up = sobol.random_base2(max(count - 1, 1).bit_length())[:count].T
        r_x, r_y = self.optic.half_width
        x, y = (2 * across - 1) * r_x, (2 * up - 1) * r_y
        return self._onto_face(x, y, 4 * r_x * r_y / count)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the point; see `Emitter.towards`."""
        rays = self._onto_face(x.numpy(), y.numpy(), 1.0)
        start = [torch.full_like(x, place) for place in self._source.position]
        flux = torch.where(rays.flux > 0, 1 / len(x), 0.0)
        return rays._replace(position=(start[0], start[1], start[2]), flux=flux)

    def _onto_face(self, x: Array, y: Array, area: float) -> RayBundle:
        """Rays through places of the face, each of which stands for an area of it."""
        z = self.optic.front_z
        lit = self.origins.light(x, y, z, np.zeros(1, dtype=np.intp))
        alive = torch.ones(len(x), dtype=torch.bool)
        flux = torch.as_tensor(lit.density * area)
        return RayBundle(vector((x, y, np.full(len(x), z))), vector(lit.direction), flux, alive)
