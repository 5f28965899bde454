"""The reference: plain torch, on any device, differentiable forward and backward.

The fused kernels are held to it by tests; where there is no kernel, it does the work.
"""

from collections.abc import Callable, Mapping

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.account import Account
from workbench.optics.images import reconstruct
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.rays import Arrival
from workbench.optics.sampled import SampledTrain, SampledWalk, is_even
from workbench.optics.sources import Emitter
from workbench.scene import Filter


class Reference:
    """A `workbench.optics.light.Tracer` that walks along a path.

    `path`: the path; where samples of its exit face are wanted, light starts there. `notes`: what
    is special about it, in words; `mirrored`: it traces all rays, mirror images or not.
    """

    def __init__(self, path: Path) -> None:
        self.mirrored = False, False
        self._path = path
        self._walk: Callable[[Mapping[str, Tensor]], Arrival] = path.walk
        self.notes: list[str] = []
        self._corners: SampledTrain | Emitter = path.emitter
        train = SampledTrain.of(path)
        if train is not None and not is_even(train, path):
            self._corners, self.notes = train, [train.note]
            self._walk = SampledWalk(train, path).walk

    def arrival(self, heights: Mapping[str, Tensor]) -> Arrival:
        """The light of a lens at the receiver, before it becomes an image."""
        return self._walk(heights)

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        column, row, rays, lost, _ = self.arrival(heights)
        receiver = self._path.receiver.part
        image = reconstruct(column, row, rays.flux, receiver.pixels, filter)
        with torch.no_grad():
            lands = receiver.covers(column, row)
            on_screen, off_screen = (
                (rays.flux * part).sum(dtype=torch.float64) for part in (lands, ~lands)
            )
            lost = lost | {"off_screen": off_screen}
        account = Account(on_screen.item(), {name: flux.item() for name, flux in lost.items()})
        return Light(image, account)

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        column, row, rays, lost, rim_distance = self.arrival(heights)
        parts = column, row, rays.flux
        nodes = torch.stack([part.expand(rays.flux.shape).T for part in parts])
        left = rays.flux.detach().sum(dtype=torch.float64).item()
        account = Account(left, {name: flux.item() for name, flux in lost.items()})
        return Nodes(nodes, account, None if rim_distance is None else rim_distance.T)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._corners.splits

    def flux(self, heights: Mapping[str, Tensor], filter: Filter) -> Tensor:
        """The image alone, for `torch.func` transforms, which no sums survive as numbers."""
        column, row, rays, *_ = self.arrival(heights)
        return reconstruct(column, row, rays.flux, self._path.receiver.part.pixels, filter)
