"""Parallel light along the axis, even or a Gaussian beam."""

import math

import numpy as np
import scipy
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples, cells, counts, parts_inside, places, shares
from workbench.optics.sources.emitter import Emitter
from workbench.optics.sources.origins import Origins
from workbench.scene import CollimatedSource, Element


class CollimatedEmitter(Emitter):
    """A tensor grid of rays that fills the entrance face."""

    by_area = True
    samples: Samples

    def __init__(
        self, source: CollimatedSource, optic: Element, samples: Samples | None = None
    ) -> None:
        super().__init__(optic, samples or source.rays)
        self._outline = outline_of(optic)
        self._waist = source.profile.radius

    @property
    def origins(self) -> Origins:
        """One direction; see `Emitter`."""
        area = 4 * math.prod(self.optic.half_width)
        even = math.isinf(self._waist)
        flux = 1 / area if even else 2 / (math.pi * self._waist**2)
        return Origins(np.array([[0.0, 0.0, 1.0]]), True, np.array([flux]), waist=self._waist)

    @property
    def beside(self) -> float:
        """See `Emitter`."""
        if not math.isinf(self._waist):
            return 1 - float(self.rays(0).flux.sum())
        if self._outline.whole:
            return 0.0
        return 1 - self._outline.area / (4 * math.prod(self.optic.half_width))

    @property
    def inside(self) -> Array | None:
        """Which part of what each ray stands for is glass, shape (m_x, m_y); None where all is."""
        if self._outline.whole:
            return None
        return parts_inside(self._outline, *(places(self.samples, axis) for axis in (0, 1)))

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `Emitter`."""
        return places(self.samples, 0).split, places(self.samples, 1).split

    def shares(self, axis: int) -> Array:
        """Light of each ray along x (0) or y (1), in that of a cell if all light met the face.

        Products of both are exact: a Gaussian beam is integrated over what each ray stands for.
        """
        if math.isinf(self._waist):
            return shares(self.samples, axis)
        sampled, r = places(self.samples, axis), self.optic.half_width[axis]
        high, low = (
            scipy.special.erf(math.sqrt(2) * (2 * part - 1) * r / self._waist)
            for part in (sampled.high, sampled.low)
        )
        return np.asarray(counts(self.samples)[axis] * (high - low) / 2)

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """The same rays for every seed and draw; see `Emitter.rays`."""
        return self._drawn(seed, draw)

    def _drawn(self, seed: int, draw: int) -> RayBundle:
        x, y = (
            torch.as_tensor((2 * places(self.samples, axis).part - 1) * r)
            for axis, r in enumerate(self.optic.half_width)
        )
        rays = _along_axis(x[:, None], y[None, :], self.optic.front_z)
        flux = x.new_ones(()) / cells(self.samples)
        if isinstance(self.samples, Corners) or math.isfinite(self._waist):
            across, up = (torch.as_tensor(self.shares(axis)) for axis in (0, 1))
            flux = flux * across[:, None] * up
        if (inside := self.inside) is not None:
            flux = flux * torch.as_tensor(inside)
        return rays._replace(flux=flux)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Parallel rays that start half a lens before it; see `Emitter.towards`."""
        return _along_axis(x, y, self.optic.front_z - 0.5 * max(self.optic.half_width))


def _along_axis(x: Tensor, y: Tensor, z: float) -> RayBundle:
    """Rays along +z with one flux; one direction, and one z, stand for all."""
    zero, one = x.new_zeros(()), x.new_ones(())
    count = (x + y).numel()
    return RayBundle((x, y, one * z), (zero, zero, one), one / count, one.bool())
