"""The reference: plain torch, on any device, differentiable forward and backward.

The fused kernels are held to it by tests; where there is no kernel, it does the work.
"""

from collections.abc import Callable, Mapping

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.optics.account import Account
from workbench.optics.arrival import Arrival
from workbench.optics.face_samples import FaceSamples, SampledFace
from workbench.optics.front_samples import FrontGrid, FrontSamples
from workbench.optics.irradiance import reconstruct
from workbench.optics.light import Light, Nodes
from workbench.optics.mirror_samples import MirrorSamples, SharedMirror
from workbench.optics.path import Path
from workbench.optics.shared_grid import SharedGrid, SharedSamples
from workbench.optics.sources import Emitter
from workbench.scene import Filter


class Reference:
    """A `workbench.optics.light.Tracer` that walks along a path.

    Parameters
    ----------
    path : Path
        The path; where samples of its exit face are wanted, light starts there.

    Attributes
    ----------
    notes : list of str
        What is special about it, in words.
    mirrored : tuple[bool, bool]
        It traces all rays, mirror images or not.
    """

    def __init__(self, path: Path) -> None:
        self.mirrored = False, False
        self._path = path
        self._walk: Callable[[Mapping[str, Tensor]], Arrival] = path.walk
        self.notes: list[str] = []
        self._corners: SharedMirror | SampledFace | SharedGrid | FrontGrid | Emitter = path.emitter
        # The kernel for samples of points, too, knows upright screens and rectangles alone.
        by_points = path.outline.whole and path.receiver.upright
        face, shared = SampledFace.of(path), SharedGrid.of(path)
        if (mirror := SharedMirror.of(path)) is not None:
            self._begin(mirror, MirrorSamples(mirror, path))
        elif shared is not None and (face is None or not by_points):
            self._begin(shared, SharedSamples(shared, path))
        elif face is not None:
            self._begin(face, FaceSamples(face, path))
        elif (front := FrontGrid.of(path)) is not None:
            self._begin(front, FrontSamples(front, path))

    def _begin(
        self,
        corners: SharedMirror | SampledFace | SharedGrid | FrontGrid,
        samples: MirrorSamples | FaceSamples | SharedSamples | FrontSamples,
    ) -> None:
        """Let light start at samples of a face, in place of a walk from the source."""
        self._corners, self._walk, self.notes = corners, samples.walk, [samples.note]

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
        column, row, rays, lost, room = self.arrival(heights)
        parts = column, row, rays.flux
        nodes = torch.stack([part.expand(rays.flux.shape).T for part in parts])
        left = rays.flux.detach().sum(dtype=torch.float64).item()
        account = Account(left, {name: flux.item() for name, flux in lost.items()})
        return Nodes(nodes, account, None if room is None else room.T)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._corners.splits

    def flux(self, heights: Mapping[str, Tensor], filter: Filter) -> Tensor:
        """The image alone, for `torch.func` transforms, which no sums survive as numbers."""
        column, row, rays, *_ = self.arrival(heights)
        return reconstruct(column, row, rays.flux, self._path.receiver.part.pixels, filter)
