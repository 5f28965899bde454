"""The generic walk as one more way to trace a scene."""

import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.irradiance import reconstruct
from workbench.optics.light import Light
from workbench.optics.path import Path
from workbench.scene import Filter, Scene, Screen


class WalkTracer:
    """A `workbench.optics.light.Tracer` that walks along the path of a scene."""

    emitted = 1.0

    def __init__(self, scene: Scene, net: ControlNet, dtype: torch.dtype) -> None:
        self._path, self._screen = Path.of(scene, net, dtype), scene.screen
        lost = self._path.lost
        self.missed_lens = lost["missed_lens"].item()
        self.fresnel_entrance = lost["fresnel_entrance"].item()

    def image(self, heights: torch.Tensor, screen: Screen, filter: Filter) -> Light:
        arrival = self._path.walk({"exit": heights})
        x, y, flux = torch.broadcast_tensors(arrival.x, arrival.y, arrival.rays.flux)
        lands = self._screen.contains(x, y)
        sums = [
            part.detach().sum(dtype=torch.float64).item() for part in (flux * lands, flux * ~lands)
        ]
        return Light(
            reconstruct(x, y, flux, screen, filter),
            *sums,
            *(
                arrival.lost[name].item()
                for name in ("total_reflection", "fresnel_exit", "left_side")
            ),
        )
