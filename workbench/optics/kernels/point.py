"""Rays in any direction to +z, from the exit face to the image in one pass.

Rays are kept sorted by the patch of the exit face in which they met the last lens, and their
depths there are where the search starts for the next one. When many have moved to other patches,
they are sorted again.
"""

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels import threads
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.point_face import Face, heights_cotangent, make_table
from workbench.optics.kernels.point_order import Sorted, arrange
from workbench.optics.kernels.point_trace import (
    ABSORBED,
    BESIDE,
    FRESNEL,
    ON_SCREEN,
    RUNS,
    SIDE,
    SUMS,
    TOTAL,
    adjoint,
    make_glass,
)
from workbench.optics.kernels.point_trace import trace as trace_rays
from workbench.optics.kernels.spread import Spread, add_up, make_canvases, make_spread, pad
from workbench.optics.light import Light
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import Filter, GaussianFilter, Screen

# An interruption of the order costs about as much as sorting so many rays.
_INTERRUPTION = 2


class FusedPointRays:
    """The rays of a path on the CPU, also after these were drawn anew.

    Whatever emits them, and whatever they pass before the exit face: the walk follows them there.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored
        What else is known of the lenses; no use is made of that.
    """

    name = "point"
    notes: ClassVar[list[str]] = []

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the walk along a path does."""
        face = ExitFace.of(path)
        return path.receiver.upright and face is not None and not face.mesh

    def __init__(
        self,
        path: Path,
        mirrored: tuple[bool, bool] = (False, False),
    ) -> None:
        face = ExitFace.of(path)
        if face is None:
            raise TypeError("the kernel for rays that search does not match this path")
        self._path, self._exit = path, face
        self.kind = kind_of(path.dtype)
        self.face = Face(face.net, path.dtype)
        start = _start(path) if face.absorption > 0 else 0.0
        screen_z = path.receiver.numbers().point[2]
        self.glass = make_glass(face.law, screen_z, face.absorption, start, self.kind)
        self._sorted: Sorted | None = None

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        path = self._path
        spread = make_spread(path.receiver, filter, self.kind)
        passes, face = _PointPasses(self, spread), self._exit
        light = trace(heights[face.name], face.net, path.datum, path.dtype, passes)
        return face.light(*light, {name: part.item() for name, part in path.lost.items()})

    def ready(self, level: float) -> Sorted:
        """The rays, sorted for a lens much like the last one, or for a plate of some height."""
        drawn, known = self._path.lines, self._sorted
        if known is None or known.drawn is not drawn:
            bundle = np.stack([part.flatten().numpy() for part in drawn])
            depths = np.full(bundle.shape[1], level, self.kind)
            return arrange(self.face.net, drawn, bundle, depths)
        if known.interruptions * _INTERRUPTION > len(known.depths):
            return arrange(self.face.net, drawn, known.bundle, known.depths)
        return known

    def remember(self, known: Sorted) -> None:
        """Where the rays met the last lens."""
        self._sorted = known


def _start(path: Path) -> float:
    """The z of the face that rays passed last, counted from the path's datum."""
    z = path.rays.position[2]
    return z.flatten()[0].item() if z.numel() else 0.0


class _PointPasses:
    """The trace of one set of rays onto one screen, and its adjoint."""

    def __init__(self, rays: FusedPointRays, spread: Spread) -> None:
        self._rays, self._spread = rays, spread

    def forward(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        rays, spread = self._rays, self._spread
        known = rays.ready(float(heights.mean()))
        bounds = rays.face.bounds(heights, known.steepest)
        table = make_table(heights, rays.face.powers)
        count = known.bundle.shape[1]
        parts = threads.parts(count)
        ends = threads.bounds(count, parts)
        canvases = make_canvases(spread, parts)
        depths = np.empty(count, rays.kind)
        sums = np.empty((parts, SUMS))
        args = rays.face.net, bounds, table, rays.glass, spread, known.bundle, known.depths

        def work(part: int) -> None:
            span = ends[part], ends[part + 1]
            sums[part] = trace_rays(*args, *span, depths, canvases[part])

        threads.run(work, parts)
        total = sums.sum(axis=0)
        runs = int(total[RUNS])
        fewest = known.fewest or runs
        more = known.interruptions + max(runs - fewest, 0)
        rays.remember(known._replace(depths=depths, fewest=fewest, interruptions=more))
        self._table, self._bundle, self._depths = table, known.bundle, depths
        parts = total[[ON_SCREEN, BESIDE, TOTAL, FRESNEL, SIDE, ABSORBED]].tolist()
        return add_up(spread, canvases), Sums(*parts)

    def backward(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        rays, spread, table = self._rays, self._spread, self._table
        count = len(self._depths)
        parts = threads.parts(count)
        ends = threads.bounds(count, parts)
        canvas = pad(spread, cotangent)
        d_tables = np.zeros((parts, *table.shape))
        args = rays.face.net, table, rays.glass, spread, self._bundle, self._depths

        def work(part: int) -> None:
            adjoint(*args, ends[part], ends[part + 1], canvas, d_tables[part])

        threads.run(work, parts)
        return heights_cotangent(d_tables, heights.shape, rays.face.powers)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a ray."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    face, heights = Face(net, dtype), np.zeros(net.shape, kind)
    known = arrange(face.net, None, np.zeros((5, 1), kind), np.zeros(1, kind))
    bounds, table = face.bounds(heights, known.steepest), make_table(heights, face.powers)
    glass = make_glass(TransmittanceLaw.fresnel(1.5), 1.5, 0.0, 0.0, kind)
    screen = Screen(kind="plane", position=(0.0, 0.0, 1.0), half_width=(1.0, 1.0), pixels=(2, 2))
    spread = make_spread(PlaneReceiver(screen, 0.0), GaussianFilter(), kind)
    canvas, d_table = make_canvases(spread, 1)[0], np.zeros(table.shape)
    rays = known.bundle, known.depths
    trace_rays(face.net, bounds, table, glass, spread, *rays, 0, 1, known.depths, canvas)
    adjoint(
        face.net, table, glass, spread, *rays, 0, 1, pad(spread, np.zeros((2, 2), kind)), d_table
    )
    heights_cotangent(d_table[None], heights.shape, face.powers)
