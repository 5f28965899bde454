"""Collimated light in one pass from control heights to the image: `optics.collimated`'s twin.

The loops are those of `workbench.optics.kernels.rows`. Nothing is kept for the way back: it
traces the same rays again, which costs less than memory.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.kernels.collimated_trace import LOOPS, Optics
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.grid import make_axis, middles
from workbench.optics.kernels.locked import Mask, Rays, count, split
from workbench.optics.kernels.passes import GridPasses
from workbench.optics.kernels.spread import Spread, make_canvases, make_spread, pad
from workbench.optics.light import Light, sum_of
from workbench.optics.refraction import normal_reflectance
from workbench.scene import Filter, GaussianFilter, Scene, Screen

AnyArray = npt.NDArray[np.floating[Any]]


class FusedCollimatedRays:
    """A tensor grid of rays; the same rays as `workbench.optics.collimated.CollimatedRays`.

    Parameters
    ----------
    scene : Scene
        The scene; the source is collimated.
    net : ControlNet
        Where the control heights sit.
    samples : tuple[int, int]
        Numbers of rays along x and y.
    mirrored : tuple[bool, bool]
        Whether heights, lens and locks are mirror images of themselves in x, in y: then the rays
        of one half are traced alone, if their number is even.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights are the same in all lenses to come; rays that see none of the
        others are traced for the first lens alone.
    dtype : torch.dtype
        Float type of the trace.
    """

    emitted = 1.0
    missed_lens = 0.0

    def __init__(
        self,
        scene: Scene,
        net: ControlNet,
        samples: tuple[int, int],
        mirrored: tuple[bool, bool] = (False, False),
        dtype: torch.dtype = torch.float32,
        locked: Mask | None = None,
    ) -> None:
        self._dtype = dtype
        kind = self._kind = kind_of(dtype)
        self.mirrored = tuple(
            wanted and along % 2 == 0 for wanted, along in zip(mirrored, samples, strict=True)
        )
        across, up = (
            make_axis(net, axis, middles(along, halved), kind)
            for axis, (along, halved) in enumerate(zip(samples, self.mirrored, strict=True))
        )
        self._moving, self._still = split((across, up), locked)
        self._still_light: tuple[Screen, Filter, Light] | None = None
        self.traced = count(self._moving) / count((across, up))
        self._level = scene.lens.base.height
        self._screen = scene.screen
        n = scene.lens.index
        self.fresnel_entrance = normal_reflectance(n) * self.emitted
        arriving = (self.emitted - self.fresnel_entrance) / (samples[0] * samples[1])
        self._optics = Optics(
            kind(n),
            kind(n * n - 1),
            kind(scene.screen.z - self._level),
            kind(16 * np.finfo(kind).eps),
            kind(arriving),
            kind(arriving * (1 - normal_reflectance(n))),
        )

    def image(self, heights: Tensor, screen: Screen, filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(screen, filter, self._kind, self._screen)
        light = trace(heights, self._level, self._dtype, _Passes(self, self._moving, spread))
        if not self._still:
            return light
        if self._still_light is None or self._still_light[:2] != (screen, filter):
            with torch.no_grad():
                parts = [
                    trace(heights, self._level, self._dtype, _Passes(self, rays, spread))
                    for rays in self._still
                ]
            self._still_light = screen, filter, sum_of(parts)
        return sum_of([light, self._still_light[2]])


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few rays."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    across, up = (make_axis(net, axis, middles(2, False), kind) for axis in (0, 1))
    across, up = (axis._replace(place=axis.place.astype(kind)) for axis in (across, up))
    numbers = Optics(*(kind(1.5) for _ in Optics._fields))
    screen = Screen(z=1.0, half_width=(1.0, 1.0), pixels=(2, 2))
    spread = make_spread(screen, GaussianFilter(), kind)
    canvas = make_canvases(spread, 1)[0]
    heights, gradient = np.zeros(net.shape, kind), np.zeros(net.shape)
    light = across.place, up.place, numbers
    given = heights, (across, up), light, spread, 0, 2
    LOOPS.trace(*given, canvas, np.zeros(3))
    LOOPS.trace_back(*given, pad(spread, np.zeros((2, 2), kind)), gradient)


class _Passes(GridPasses):
    """The trace of one set of rays onto one screen, and its adjoint."""

    def __init__(self, source: FusedCollimatedRays, rays: Rays, spread: Spread) -> None:
        super().__init__(LOOPS, rays, spread, source.mirrored, sums=3)
        across, up = rays
        columns = spread.column_0 + spread.per_x * across.place
        rows = spread.row_0 + spread.per_y * up.place
        kind = spread.per_x.dtype
        self._light = columns.astype(kind), rows.astype(kind), source._optics
        self._arriving = float(source._optics.arriving)
        self._flux = self.copies * count(rays) * self._arriving

    def light(self, heights: AnyArray) -> tuple[Any, ...]:
        """See `GridPasses`."""
        return self._light

    def account(self, sums: list[float]) -> Sums:
        """See `GridPasses`."""
        on_screen, beside, passed = sums
        passed *= self._arriving
        return Sums(
            on_screen,
            off_screen=beside,
            total_reflection=self._flux - passed,
            fresnel_exit=passed - on_screen - beside,
        )
