"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

import copy
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays
from workbench.optics.hits import Hits
from workbench.optics.irradiance import Image, reconstruct
from workbench.optics.ledger import Ledger
from workbench.optics.point import PointRays
from workbench.scene import CollimatedSource, Filter, Scene, Screen

_NEARLY_ALL = 0.999


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
        dtype: torch.dtype = torch.float32,
    ) -> None:
        self._screen = scene.screen
        self._filter = filter or scene.filter
        net = net or ControlNet.of(scene.lens)
        self._fresh = not isinstance(scene.source, CollimatedSource) and scene.source.fresh
        self._rays: CollimatedRays | PointRays
        # Collimated light needs no entrance refraction and no intersection: it is not in its plan.
        if isinstance(scene.source, CollimatedSource):
            self._rays = CollimatedRays(scene, net, dtype, device_of(scene))
        else:
            self._rays = PointRays(scene, net, dtype=dtype, device=device_of(scene))

    def trace(self, heights: Tensor) -> Traced:
        """Image and ledger of a lens.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, scene units.
        """
        rays = self._rays
        hits, image = self._image(heights)
        arriving, weight, passes = hits.arriving.detach(), hits.weight.detach(), hits.passes
        ledger = Ledger(
            emitted=rays.emitted,
            on_screen=_sum(image.flux.detach()),
            off_screen=image.off_screen.item(),
            missed_lens=rays.missed_lens,
            left_side=hits.left_side.item(),
            total_reflection=_sum(arriving * ~passes),
            fresnel_entrance=rays.fresnel_entrance,
            fresnel_exit=_sum((arriving - weight) * passes),
        )
        return Traced(image.flux, ledger)

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        if isinstance(self._rays, PointRays) and self._fresh:
            self._rays.redraw()

    def reach(self, heights: Tensor) -> tuple[float, float]:
        """How far from the axis, along x and y, nearly all light on the screen plane falls."""
        with torch.no_grad():
            hits = self._rays.trace(heights)
        lands = (hits.weight > 0) & hits.x.isfinite()
        if not lands.any():
            return 0.0, 0.0
        x, y = (c[lands].abs().double().cpu().numpy() for c in (hits.x, hits.y))
        return float(np.quantile(x, _NEARLY_ALL)), float(np.quantile(y, _NEARLY_ALL))

    def on(self, screen: Screen) -> "Plan":
        """The same rays on another part of the same plane; nothing of them is computed again."""
        other = copy.copy(self)
        other._screen = screen
        return other

    def flux(self, heights: Tensor) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp, which no ledger survives."""
        return self._image(heights)[1].flux

    def _image(self, heights: Tensor) -> tuple[Hits, Image]:
        hits = self._rays.trace(heights)
        return hits, reconstruct(hits.x, hits.y, hits.weight, self._screen, self._filter)


def _sum(flux: Tensor) -> float:
    return float(flux.sum(dtype=torch.float64))


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
