"""Parallel light along the axis."""

import numpy as np
import torch
from torch import Tensor

from workbench.optics.rays import RayBundle
from workbench.scene import CollimatedSource, Lens


class CollimatedEmitter:
    """An even tensor grid of rays that fills the entrance face; an `Emitter`.

    Parameters
    ----------
    source : CollimatedSource
        How many rays.
    lens : Lens
        Gives the entrance face.
    samples : tuple[int, int], optional
        Rays along x and y; those of the source by default.

    Attributes
    ----------
    count : tuple[int, int]
        Rays along x and y.
    """

    def __init__(
        self, source: CollimatedSource, lens: Lens, samples: tuple[int, int] | None = None
    ) -> None:
        self.count, self._lens = samples or source.rays, lens

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """The same rays for every seed and draw; see `Emitter.rays`."""
        x, y = (
            torch.as_tensor(((np.arange(m) + 0.5) / m * 2 - 1) * r)
            for m, r in zip(self.count, self._lens.half_width, strict=True)
        )
        return _along_axis(x[:, None], y[None, :], self._lens.entrance_z)

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Parallel rays that start half a lens before it; see `Emitter.towards`."""
        return _along_axis(x, y, self._lens.entrance_z - 0.5 * max(self._lens.half_width))


def _along_axis(x: Tensor, y: Tensor, z: float) -> RayBundle:
    """Rays along +z with one flux; one direction, and one z, stand for all."""
    zero, one = x.new_zeros(()), x.new_ones(())
    count = (x + y).numel()
    return RayBundle((x, y, one * z), (zero, zero, one), one / count, one.bool())
