"""Light of a small lamp whose intensity by direction was measured."""

import math
from functools import lru_cache

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Index
from workbench.measured.lamps import intensity_of
from workbench.measured.photometry import IntensityTable
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.origins import (
    EmittedLight,
    Origins,
    splits_of,
    through_cells,
    vector,
)
from workbench.scene import Element, PhotometricSource


class TurnedTable:
    """Intensity of a lamp that is turned; a `Pattern`.

    `table`: in the directions of the file; `matrix` (3, 3): turns directions of the file into those
    of the scene.
    """

    def __init__(self, table: IntensityTable, matrix: Array) -> None:
        self._table, self._matrix = table, matrix

    def at(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """Intensity, cd; see `Pattern.at`."""
        return self._table.at(np.stack(np.broadcast_arrays(*direction), axis=-1) @ self._matrix)


def light_of_table(source: PhotometricSource) -> EmittedLight:
    """All light of a lamp, in the directions of the scene.

    Raises `Refused` if the file cannot be read or used.
    """
    return _turned(intensity_of(source), tuple(source.matrix.ravel().tolist()))


# Asked for by each plan of a run; tables differ by what they are, not by what they hold.
@lru_cache(maxsize=4)
def _turned(table: IntensityTable, matrix: tuple[float, ...]) -> EmittedLight:
    direction, lumens = table.flux_nodes
    return EmittedLight(direction @ np.reshape(matrix, (3, 3)).T, lumens / table.lumens)


class PhotometricEmitter:
    """One point whose intensity is that of a file; an `Emitter`.

    All light of the lamp is 1, what goes elsewhere than to the lens included. The parameters are
    those of `emitter_of`.
    """

    def __init__(
        self, source: PhotometricSource, optic: Element, samples: Samples | None = None
    ) -> None:
        self._source, self._lens, self.samples = source, optic, samples
        table = intensity_of(source)
        pattern = TurnedTable(table, source.matrix)
        self.origins = Origins(
            np.array([source.position]),
            False,
            np.array([1 / table.lumens]),
            pattern=pattern,
            note=table.note,
            emitted=light_of_table(source),
        )

    beside = 0.0

    @property
    def by_area(self) -> bool:
        """Where they are corners of cells; see `Emitter`."""
        return isinstance(self.samples, Corners)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`."""
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        return splits_of(self.samples, (1, 1))

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays through low-discrepancy places of the face, or at corners; see `Emitter.rays`.

        No ray stands for light that passes the face by.
        """
        if isinstance(self.samples, Corners):
            return through_cells(self.origins, self._lens, self.samples)
        from scipy.stats import qmc  # late: it takes most of a second to import

        count = self._source.rays if self.samples is None else math.prod(self.samples)
        sobol = qmc.Sobol(2, seed=np.random.default_rng([seed, draw]))
        across, up = sobol.random_base2(max(count - 1, 1).bit_length())[:count].T
        r_x, r_y = self._lens.half_width
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
        z = self._lens.front_z
        lit = self.origins.light(x, y, z, np.zeros(1, dtype=np.intp))
        alive = torch.ones(len(x), dtype=torch.bool)
        flux = torch.as_tensor(lit.density * area)
        return RayBundle(vector((x, y, np.full(len(x), z))), vector(lit.direction), flux, alive)
