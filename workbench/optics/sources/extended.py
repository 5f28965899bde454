"""Extended sources: flat emitters, and collimated light from a disc of directions."""

import math
from abc import abstractmethod
from functools import cached_property

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.crowding import where_lit
from workbench.optics.sources.emitter import Emitter
from workbench.optics.sources.origins import (
    Origins,
    Outline,
    SpreadPlaces,
    TurnedPattern,
    at_corners,
    filling,
    spread,
    through_cells,
    vector,
)
from workbench.scene import AreaSource, CollimatedSource, Element


class ExtendedEmitter(Emitter):
    """Light of a source of some size, which stands as a set of origins.

    Rays are drawn from anywhere on the source to anywhere on the entrance face; those at corners
    of cells come from as many origins as `Corners` says.

    `rays`: how many are drawn, where no corners are asked for; `samples`: corners of cells; or so
    many middles of cells, lit from the middle of the source alone.
    """

    by_area = True
    outline: Outline
    aspect: float = 1.0
    many: Corners = Corners(64, 64, 64)
    """Cells and origins that estimate how much light meets the lens, where rays are random."""

    def __init__(self, optic: Element, rays: int, samples: Samples | None) -> None:
        super().__init__(optic, samples)
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

    @cached_property
    def beside(self) -> float:
        """See `Emitter`; all of it that misses the lens."""
        rays = self._through_cells(self.samples or self.many)
        return 1 - float(rays.flux.sum())

    @property
    def origins(self) -> Origins:
        """See `Emitter`; the middle alone where no corners are asked for."""
        return self._origins_of(self.samples)

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


class AreaEmitter(ExtendedEmitter):
    """Points of an emitter's face; the parameters are those of `emitter_of`.

    All light of the half-space before it is 1: what misses the entrance face misses the lens.
    """

    def __init__(self, source: AreaSource, optic: Element, samples: Samples | None = None) -> None:
        super().__init__(optic, source.rays, samples)
        self._source, self.outline = source, source.outline
        self.aspect = source.half_width[0] / source.half_width[1]

    def origins_at(self, places: SpreadPlaces) -> Origins:
        """See `ExtendedEmitter`."""
        r_x, r_y = self._source.half_width
        points = self._source.places(r_x * places.x, r_y * places.y)
        lambertian = self._source.emission == "lambertian"
        flux = places.share / (math.pi if lambertian else 2 * math.pi)
        if self._source.turn is None:
            return Origins(points, False, flux, lambertian)
        pattern = TurnedPattern(tuple(self._source.facing.tolist()), lambertian)
        return Origins(points, False, flux, pattern=pattern)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the middle of the emitter and its corners in turn; see `Emitter.towards`."""
        starts = np.vstack([self._source.position, self._source.corners])
        start = starts[np.arange(len(x)) % len(starts)]
        way = np.column_stack([x, y, np.full(len(x), self.optic.front_z)]) - start
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        flux = torch.full((len(x),), 1 / max(len(x), 1), dtype=torch.float64)
        return RayBundle(vector([*start.T]), vector([*way.T]), flux, torch.ones_like(flux).bool())


# The shadow of a beam on the face is not taken to be longer than this many of its radii.
_LONGEST = 20.0
# Directions to look at, beside that in the middle.
_RIM = SpreadPlaces(np.array([0.0, -1, 1, 0, 0]), np.array([0.0, 0, 0, -1, 1]), np.full(5, 0.2))


class DirectionEmitter(ExtendedEmitter):
    """As much light from everywhere in a disc of directions; the parameters are `emitter_of`'s.

    Even light fills the entrance face, and nothing of it misses the lens.
    """

    outline = "ellipse"

    def __init__(
        self, source: CollimatedSource, optic: Element, samples: Samples | None = None
    ) -> None:
        super().__init__(optic, source.ray_count, samples)
        self._source, self.many = source, where_lit(self.many, source, optic)

    def origins_at(self, places: SpreadPlaces) -> Origins:
        """See `ExtendedEmitter`; directions are even in solid angle."""
        waist = self._source.profile.radius
        ways = self._source.directions(places.x, places.y)
        flux = places.share * 2 / (math.pi * waist**2)
        if math.isinf(waist):
            area = 4 * math.prod(self.optic.half_width)
            flux = places.share / (area * (places.share @ ways[:, 2]))
        return Origins(ways, True, flux, waist=waist)

    def onto_face(self, across: Array, up: Array) -> tuple[Array, Array, Array]:
        """See `ExtendedEmitter`; rays of a beam are as dense as its light, however slim it is."""
        waist = self._source.profile.radius
        if math.isinf(waist):
            return super().onto_face(across, up)
        (x, wide), (y, high) = (
            _as_dense(part, r, waist / 2 / _ahead(self._source))
            for part, r in zip((across, up), self.optic.half_width, strict=True)
        )
        return x, y, wide * high

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays of the middle of the disc and of its rim in turn; see `Emitter.towards`."""
        number = np.arange(len(x)) % (5 if self._source.continuous else 1)
        ways = self.origins_at(_RIM).places[number]
        back = 0.5 * max(self.optic.half_width) / ways[:, 2]
        face = np.column_stack([x, y, np.full(len(x), self.optic.front_z)])
        flux = torch.full((len(x),), 1 / max(len(x), 1), dtype=torch.float64)
        start = (face - back[:, None] * ways).T
        return RayBundle(vector([*start]), vector([*ways.T]), flux, torch.ones_like(flux).bool())


def _ahead(source: CollimatedSource) -> float:
    """Cosine to the axis of the most slanted light."""
    steepest = math.hypot(*source.direction) + source.angular_diameter / 2
    return max(math.cos(math.radians(steepest)), 1 / _LONGEST)


def _as_dense(part: Array, r: float, deviation: float) -> tuple[Array, Array]:
    """Places from −r to r as dense as a normal distribution, and the length that each stands for.

    The length is in any unit.
    """
    from scipy.special import ndtr, ndtri  # late: as of all that rays are drawn with

    outside = ndtr(-r / deviation)
    place = ndtri(outside + (1 - 2 * outside) * part)
    return (deviation * place).clip(-r, r), np.exp(place**2 / 2)
