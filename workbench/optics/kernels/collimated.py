"""Collimated light in one pass from control heights to the image.

The bundle is parallel to z and meets the flat entrance face at a right angle, so it goes straight
on and can start on the exit face (de Koning et al. 2023, section 2.2): no entrance refraction, no
intersection, and slopes on a tensor grid by small matrix products.
"""

from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Mask
from workbench.geometry.surface import ControlNet
from workbench.optics.halves import Halves
from workbench.optics.interfaces import Refraction
from workbench.optics.kernels.collimated_trace import LOOPS, Optics
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.function import Sums, kind_of
from workbench.optics.kernels.locked import Rays
from workbench.optics.kernels.parallel import ParallelRays, rays_along
from workbench.optics.kernels.passes import GridPasses
from workbench.optics.kernels.spread import Spread, make_canvases, make_spread, pad
from workbench.optics.light import Light
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import cells
from workbench.optics.sources import CollimatedEmitter
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import Plane
from workbench.optics.transmittance import TransmittanceLaw
from workbench.said import Said
from workbench.scene import GaussianFilter, Screen


class FusedCollimatedRays(ParallelRays):
    """Parallel light through a lens with a flat entrance face.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored, locked
        See `ParallelRays`.
    """

    name = "collimated"
    note = Said("collimated light: entrance refraction and intersection left out")

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the walk along a path does."""
        return path.receiver.upright and _ParallelLens.of(path) is not None

    def __init__(
        self,
        path: Path,
        mirrored: tuple[bool, bool] = (False, False),
        locked: Mask | None = None,
    ) -> None:
        lens = _ParallelLens.of(path)
        if lens is None:
            raise TypeError("the kernel for collimated light does not match this path")
        super().__init__(path, lens.emitter, lens.face.net, lens.face.name, mirrored, locked)
        self._face, n, kind = lens.face, lens.face.law.ratio, self.kind
        entering, beside = lens.entering.at(1.0, 1.0), lens.emitter.beside
        self._before = {lens.missed: beside, lens.reflected: (1 - entering) * (1 - beside)}
        self.optics = Optics(
            kind(n),
            kind(n * n - 1),
            kind(path.receiver.numbers().point[2]),
            kind(16 * np.finfo(kind).eps),
            kind(entering / cells(lens.emitter.samples)),
            kind(-lens.entrance_z),
            kind(lens.face.absorption),
            lens.face.law.cast(kind),
        )

    def passes(self, rays: Rays, spread: Spread) -> GridPasses:
        """See `ParallelRays`."""
        return _CollimatedPasses(self, rays, spread)

    def light(self, flux: Tensor, sums: Sums) -> Light:
        """See `ParallelRays`."""
        return self._face.light(flux, sums, self._before)


class _ParallelLens(NamedTuple):
    """What the kernel is for: parallel light, a flat face across it and a B-spline."""

    emitter: CollimatedEmitter
    entrance_z: float
    missed: str
    entering: TransmittanceLaw
    reflected: str
    face: ExitFace

    @classmethod
    def of(cls, path: Path) -> "_ParallelLens | None":
        face = ExitFace.rectangular(path)
        match path.emitter, path.steps:
            case (
                CollimatedEmitter() as emitter,
                (FaceStep(Plane(z=z), Refraction(law=law, reflected=reflected), missed), _),
            ) if face is not None:
                return cls(emitter, z, missed, law, reflected, face)
        return None


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few rays."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    across, up = (
        rays_along(net, (2, 2), axis, np.ones(2), Halves(None, None), kind) for axis in (0, 1)
    )
    law = TransmittanceLaw.fresnel(1.5).cast(kind)
    numbers = Optics._make([*(kind(1.5) for _ in Optics._fields[:-1]), law])
    screen = Screen(z=1.0, half_width=(1.0, 1.0), pixels=(2, 2))
    spread = make_spread(PlaneReceiver(screen, 0.0), GaussianFilter(), kind)
    canvas = make_canvases(spread, 1)[0]
    heights, gradient = np.zeros(net.shape, kind), np.zeros(net.shape)
    wide = across.share[None, :]
    light = across.place.astype(kind), up.place.astype(kind), wide, up.share, numbers
    given = heights, (across, up), light, spread, 0, 2
    LOOPS.trace(*given, canvas, np.zeros(4))
    LOOPS.trace_back(*given, pad(spread, np.zeros((2, 2), kind)), gradient)
    nodes = np.zeros((3, 2, 2), kind)
    LOOPS.land(*given, nodes, np.zeros(4))
    LOOPS.land_back(*given, nodes, gradient)


class _CollimatedPasses(GridPasses):
    """The trace of one set of rays onto one screen, and its adjoint."""

    def __init__(self, source: FusedCollimatedRays, rays: Rays, spread: Spread) -> None:
        super().__init__(LOOPS, rays, spread, source.mirrored, sums=4)
        across, up = rays
        columns = spread.column_0 + spread.per_x * across.place
        rows = spread.row_0 + spread.per_y * up.place
        kind = spread.per_x.dtype
        wide = source.inside(rays) * across.share
        self._light = (
            columns.astype(kind),
            rows.astype(kind),
            np.ascontiguousarray(wide, kind),
            up.share,
            source.optics,
        )
        self._arriving = float(source.optics.arriving)
        shares = float((wide.sum(axis=1, dtype=float) * up.share).sum(dtype=float))
        self._flux = self.copies * shares * self._arriving

    def light(self, heights: AnyArray) -> tuple[Any, ...]:
        """See `GridPasses`."""
        return self._light

    def account(self, sums: list[float]) -> Sums:
        """See `GridPasses`."""
        on_screen, beside, passed, absorbed = sums
        passed *= self._arriving
        absorbed *= self._arriving
        return Sums(
            on_screen,
            off_screen=beside,
            total_reflection=self._flux - absorbed - passed,
            reflected=passed - on_screen - beside,
            absorbed=absorbed,
        )
