"""Collimated light on a mirror, in one pass from control heights to the image.

Light along the axis comes straight to the mirror, and goes back to any plane, or to the far field.
"""

from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Mask
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.halves import Halves
from workbench.optics.interfaces import Reflection
from workbench.optics.kernels.function import Sums, kind_of
from workbench.optics.kernels.locked import Rays
from workbench.optics.kernels.mirror_trace import LOOPS, Along
from workbench.optics.kernels.origin_receive import landing_of
from workbench.optics.kernels.parallel import ParallelRays, rays_along
from workbench.optics.kernels.passes import GridPasses
from workbench.optics.kernels.spread import Spread, make_canvases, make_spread, pad
from workbench.optics.light import Light
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import cells
from workbench.optics.sources import CollimatedEmitter
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.said import Said
from workbench.scene import GaussianFilter, Screen


class FusedMirrorRays(ParallelRays):
    """Parallel light on a mirror.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored, locked
        See `ParallelRays`.
    """

    name = "mirror"
    note = Said("collimated light: intersection left out")

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the walk along a path does."""
        return _LitMirror.of(path) is not None

    def __init__(
        self,
        path: Path,
        mirrored: tuple[bool, bool] = (False, False),
        locked: Mask | None = None,
    ) -> None:
        lit = _LitMirror.of(path)
        if lit is None:
            raise TypeError("the kernel for mirrors does not match this path")
        super().__init__(path, lit.emitter, lit.net, lit.name, mirrored, locked)
        self._mirror = lit.mirror
        self._before = {lit.missed: lit.emitter.beside}
        self.arriving = lit.mirror.reflectance / cells(lit.emitter.samples)
        self.landing = landing_of(path.receiver, 0.0, self.kind)

    def passes(self, rays: Rays, spread: Spread) -> GridPasses:
        """See `ParallelRays`."""
        return _MirrorPasses(self, rays, spread)

    def light(self, flux: Tensor, sums: Sums) -> Light:
        """See `ParallelRays`."""
        lost = {**self._before, "off_screen": sums.off_screen}
        if self._mirror.reflectance < 1:
            met = (sums.on_screen + sums.off_screen) / self._mirror.reflectance
            lost[self._mirror.absorbed] = met * (1 - self._mirror.reflectance)
        return Light(flux, Account(sums.on_screen, lost))


class _LitMirror(NamedTuple):
    """What the kernel is for: parallel light and a B-spline that reflects."""

    emitter: CollimatedEmitter
    name: str
    net: ControlNet
    mirror: Reflection
    missed: str

    @classmethod
    def of(cls, path: Path) -> "_LitMirror | None":
        match path.emitter, path.steps:
            case (
                CollimatedEmitter() as emitter,
                (
                    FaceStep(
                        BSplineSurface(name=name, net=net, subdivisions=None, outline=outline),
                        Reflection() as mirror,
                        missed,
                    ),
                ),
            ) if outline.whole:
                return cls(emitter, name, net, mirror, missed)
        return None


class _MirrorPasses(GridPasses):
    """The trace of one set of rays, and its adjoint."""

    def __init__(self, source: FusedMirrorRays, rays: Rays, spread: Spread) -> None:
        super().__init__(LOOPS, rays, spread, source.mirrored, sums=3)
        across, up = rays
        wide = np.ascontiguousarray(source.inside(rays) * across.share, source.kind)
        along = (Along(axis.place.astype(source.kind)) for axis in rays)
        self._light = (*along, wide, up.share, source.kind(source.arriving), source.landing)

    def light(self, heights: AnyArray) -> tuple[Any, ...]:
        """See `GridPasses`."""
        return self._light

    def account(self, sums: list[float]) -> Sums:
        """See `GridPasses`."""
        on_screen, _, reflected = sums
        return Sums(on_screen, reflected - on_screen, total_reflection=0.0, reflected=0.0)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few rays."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    across, up = (
        rays_along(net, (2, 2), axis, np.ones(2), Halves(None, None), kind) for axis in (0, 1)
    )
    receiver = PlaneReceiver(Screen(z=-1.0, half_width=(1.0, 1.0), pixels=(2, 2)), 0.0, -1)
    spread = make_spread(receiver, GaussianFilter(), kind)
    canvas = make_canvases(spread, 1)[0]
    heights, gradient = np.zeros(net.shape, kind), np.zeros(net.shape)
    along = (Along(axis.place.astype(kind)) for axis in (across, up))
    light = (*along, across.share[None, :], up.share, kind(1), landing_of(receiver, 0.0, kind))
    given = heights, (across, up), light, spread, 0, 2
    LOOPS.trace(*given, canvas, np.zeros(3))
    LOOPS.trace_back(*given, pad(spread, np.zeros((2, 2), kind)), gradient)
    nodes = np.zeros((3, 2, 2), kind)
    LOOPS.land(*given, nodes, np.zeros(3))
    LOOPS.land_back(*given, nodes, gradient)
