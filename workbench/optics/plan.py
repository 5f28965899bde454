"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

from typing import NamedTuple

import torch
from torch import Tensor

from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays, Hits
from workbench.optics.irradiance import Image, reconstruct
from workbench.optics.ledger import Ledger
from workbench.scene import Filter, Scene


class Traced(NamedTuple):
    """The image of a lens, and where the rest of its light went.

    Attributes
    ----------
    flux : Tensor, shape (n_y, n_x)
        Flux in each pixel, row 0 at +y; differentiable.
    ledger : Ledger
        The account of all light.
    """

    flux: Tensor
    ledger: Ledger


class Plan:
    """A trace that is ready to go.

    Parameters
    ----------
    scene : Scene
        What is traced.
    net : ControlNet, optional
        Control net of the heights to come; the scene's own by default.
    filter : BoxFilter or GaussianFilter, optional
        Reconstruction filter; the scene's own by default.
    shift : tuple[float, float]
        Position of the rays in the cells of their grid, each in [0, 1).
    dtype : torch.dtype
        Float type of the trace.

    Raises
    ------
    Refused
        If the scene asks for a device that is not there.
    """

    def __init__(
        self,
        scene: Scene,
        net: ControlNet | None = None,
        filter: Filter | None = None,
        shift: tuple[float, float] = (0.5, 0.5),
        dtype: torch.dtype = torch.float32,
    ) -> None:
        self._screen = scene.screen
        self._filter = filter or scene.filter
        net = net or ControlNet.of(scene.lens)
        self._rays = CollimatedRays(scene, net, shift, dtype, device_of(scene))

    def trace(self, heights: Tensor) -> Traced:
        """Image and ledger of a lens.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, scene units.
        """
        rays = self._rays
        hits, image = self._image(heights)
        transmitted = hits.weight.detach().sum(dtype=torch.float64).item()
        arriving = hits.passes.sum().item() * hits.arriving
        ledger = Ledger(
            emitted=rays.emitted,
            on_screen=image.flux.detach().sum(dtype=torch.float64).item(),
            off_screen=image.off_screen.item(),
            missed_lens=0.0,
            total_reflection=(~hits.passes).sum().item() * hits.arriving,
            fresnel_entrance=rays.fresnel_entrance,
            fresnel_exit=arriving - transmitted,
        )
        return Traced(image.flux, ledger)

    def flux(self, heights: Tensor) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp, which no ledger survives."""
        return self._image(heights)[1].flux

    def _image(self, heights: Tensor) -> tuple[Hits, Image]:
        hits = self._rays.trace(heights)
        return hits, reconstruct(hits.x, hits.y, hits.weight, self._screen, self._filter)


def device_of(scene: Scene) -> torch.device:
    """The device on which a scene wants to be traced.

    Raises
    ------
    Refused
        If it is not there.
    """
    if scene.run.device == "cuda" and not torch.cuda.is_available():
        raise Refused(
            "run.device", "'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'"
        )
    return torch.device(scene.run.device)
