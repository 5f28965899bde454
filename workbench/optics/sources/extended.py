"""Light that comes from all of a disc of directions or of a flat emitter."""

from abc import ABC, abstractmethod
from functools import cached_property

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.evenly import Outline, SpreadPlaces, at_corners, filling, spread
from workbench.optics.sources.origins import Origins, splits_of, through_cells, vector
from workbench.scene import Element


class ExtendedEmitter(ABC):
    """Light of a source of some size, which stands as a set of origins; an `Emitter`.

    Rays are drawn from anywhere on the source to anywhere on the entrance face; those at corners
    of cells come from as many origins as `Corners` says.

    Parameters
    ----------
    optic : Element
        Gives the entrance face.
    rays : int
        How many rays are drawn, where no corners are asked for.
    samples : tuple[int, int] or Corners, optional
        Corners of cells; or so many middles of cells, lit from the middle of the source alone.
    """

    by_area = True
    outline: Outline
    aspect: float = 1.0
    many: Corners = Corners(64, 64, 64)
    """Cells and origins that tell how much light meets the lens, where rays are drawn at random."""

    def __init__(self, optic: Element, rays: int, samples: Samples | None) -> None:
        self.optic, self.samples = optic, samples
        self._rays = rays

    @abstractmethod
    def origins_at(self, places: SpreadPlaces) -> Origins:
        """Origins at places of the source's outline."""

    def onto_face(self, across: Array, up: Array) -> tuple[Array, Array, Array]:
        """Places (x, y) of the entrance face for even parts in [0, 1], and the area of each.

        The area is in any unit.
        """
        r_x, r_y = self.optic.half_width
        return (2 * across - 1) * r_x, (2 * up - 1) * r_y, np.ones_like(across)

    @abstractmethod
    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """See `Emitter.towards`."""

    @cached_property
    def beside(self) -> float:
        """See `Emitter`; all of it that misses the lens."""
        rays = self._through_cells(self.samples or self.many)
        return 1 - float(rays.flux.sum())

    @property
    def origins(self) -> Origins:
        """See `Emitter`; the middle alone where no corners are asked for."""
        return self._origins_of(self.samples)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`."""
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        return splits_of(self.samples, (1, len(self.origins.places)))

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays drawn by the seed, or at corners of cells; see `Emitter.rays`."""
        if self.samples is None:
            return self._drawn(seed, draw)
        return self._through_cells(self.samples)

    def _through_cells(self, samples: Samples) -> RayBundle:
        rays = through_cells(self._origins_of(samples), self.optic, samples)
        # The sum over cells has the error of the trapezoidal rule. An emitter may light the face
        # with all of its light: then the sum is scaled to that, or ``beside`` would be negative.
        return rays._replace(flux=rays.flux / rays.flux.sum().clamp_min(1))

    def _origins_of(self, samples: Samples | None) -> Origins:
        if not isinstance(samples, Corners):
            return self.origins_at(spread(1, self.outline, self.aspect))
        if samples.of_source is not None:
            return self.origins_at(at_corners(samples.of_source, self.outline))
        return self.origins_at(spread(samples.origins, self.outline, self.aspect))

    def _drawn(self, seed: int, draw: int) -> RayBundle:
        """Rays between low-discrepancy places of the source and of the face."""
        from scipy.stats import qmc  # late: it takes most of a second to import

        count = self._rays
        sobol = qmc.Sobol(4, seed=np.random.default_rng([seed, draw]))
        a, b, across, up = sobol.random_base2(max(count - 1, 1).bit_length())[:count].T
        x, y, area = self.onto_face(across, up)
        share = np.full(count, 1 / count)
        origins = self.origins_at(SpreadPlaces(*filling(a, b, self.outline), share))
        lit = origins.light(x, y, self.optic.front_z, np.arange(count))
        flux = lit.density * area * outline_of(self.optic).contains(x, y)
        if flux.any():  # else all rays pass the outline by
            flux *= (1 - self.beside) / flux.sum()
        place = x, y, np.full(count, self.optic.front_z)
        alive = torch.ones(count, dtype=torch.bool)
        return RayBundle(vector(place), vector(lit.direction), torch.as_tensor(flux), alive)
