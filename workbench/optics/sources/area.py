"""Light of a flat emitter that faces the lens."""

import math

import numpy as np
import torch
from torch import Tensor

from workbench.optics.rays import RayBundle
from workbench.optics.samples import Samples
from workbench.optics.sources.evenly import SpreadPlaces
from workbench.optics.sources.extended import ExtendedEmitter
from workbench.optics.sources.origins import Origins, TurnedPattern, vector
from workbench.scene import AreaSource, Element


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
        pattern = TurnedPattern(self._source.facing, lambertian)
        return Origins(points, False, flux, pattern=pattern)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays from the middle of the emitter and its corners in turn; see `Emitter.towards`."""
        starts = np.vstack([self._source.position, self._source.corners])
        start = starts[np.arange(len(x)) % len(starts)]
        way = np.column_stack([x, y, np.full(len(x), self.optic.front_z)]) - start
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        flux = torch.full((len(x),), 1 / max(len(x), 1), dtype=torch.float64)
        return RayBundle(vector([*start.T]), vector([*way.T]), flux, torch.ones_like(flux).bool())
