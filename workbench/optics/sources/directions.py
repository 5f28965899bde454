"""Light from infinitely far that is tilted, or comes from a disc as that of the sun."""

import math

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Samples
from workbench.optics.sources.crowding import where_lit
from workbench.optics.sources.evenly import SpreadPlaces
from workbench.optics.sources.extended import ExtendedEmitter
from workbench.optics.sources.origins import Origins, vector
from workbench.scene import CollimatedSource, Element

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
