"""The reference: plain torch, on any device, differentiable forward and backward.

The fused kernels are held to it by tests; where there is no kernel, it does the work.
"""

import torch
from torch import Tensor

from workbench.optics.collimated import CollimatedRays
from workbench.optics.face_samples import FaceSamples
from workbench.optics.irradiance import reconstruct
from workbench.optics.light import Light
from workbench.optics.point import PointRays
from workbench.scene import Filter, Screen


class Reference:
    """A `workbench.optics.light.Tracer` of rays that know how to find the screen.

    Parameters
    ----------
    rays : CollimatedRays, PointRays or FaceSamples
        The rays.
    """

    def __init__(self, rays: CollimatedRays | PointRays | FaceSamples) -> None:
        self.rays = rays

    @property
    def emitted(self) -> float:
        """Flux of the source."""
        return self.rays.emitted

    @property
    def missed_lens(self) -> float:
        """Flux that passes the entrance face by."""
        return self.rays.missed_lens

    @property
    def fresnel_entrance(self) -> float:
        """Flux reflected at the entrance face."""
        return self.rays.fresnel_entrance

    def image(self, heights: Tensor, screen: Screen, filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        hits = self.rays.trace(heights)
        flux = reconstruct(hits.x, hits.y, hits.weight, screen, filter)
        with torch.no_grad():
            lands = self.rays.screen.contains(hits.x, hits.y)
            return Light(
                flux,
                on_screen=_sum(hits.weight * lands),
                off_screen=_sum(hits.weight * ~lands),
                total_reflection=_sum(hits.arriving * ~hits.passes),
                fresnel_exit=_sum((hits.arriving - hits.weight) * hits.passes),
                left_side=hits.left_side.item(),
            )

    def flux(self, heights: Tensor, screen: Screen, filter: Filter) -> Tensor:
        """The image alone, for `torch.func` transforms, which no sums survive as numbers."""
        hits = self.rays.trace(heights)
        return reconstruct(hits.x, hits.y, hits.weight, screen, filter)


def _sum(flux: Tensor) -> float:
    return float(flux.sum(dtype=torch.float64))
