"""Collimated light in one pass from control heights to the image.

The bundle is parallel to z and meets the flat entrance face at a right angle, so it goes straight
on and can start on the exit face (de Koning et al. 2023, section 2.2): no entrance refraction, no
intersection, and slopes on a tensor grid by small matrix products.

The loops are those of `workbench.optics.kernels.rows`. Nothing is kept for the way back: it
traces the same rays again, which costs less than memory.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.halves import Halves
from workbench.optics.interfaces import Refraction
from workbench.optics.kernels.collimated_trace import LOOPS, Optics
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.grid import Axis, make_axis
from workbench.optics.kernels.locked import Mask, Rays, count, split
from workbench.optics.kernels.passes import GridPasses, Landing
from workbench.optics.kernels.spread import Spread, make_canvases, make_spread, pad
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import Samples, cells, places
from workbench.optics.sources import CollimatedEmitter
from workbench.optics.steps import Step
from workbench.optics.surfaces import Plane
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import BoxFilter, Filter, GaussianFilter, Screen

Array = npt.NDArray[np.float64]
AnyArray = npt.NDArray[np.floating[Any]]


class FusedCollimatedRays:
    """A tensor grid of rays; a `workbench.optics.light.Tracer`.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored : tuple[bool, bool]
        Whether heights, lens and locks are mirror images of themselves in x, in y: then the rays
        of one half are traced alone, if their number is even.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights are the same in all lenses to come; rays that see none of the
        others are traced for the first lens alone.
    """

    name = "collimated"

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
        net, samples, n = lens.face.net, lens.emitter.samples, lens.face.law.ratio
        self._face, self._dtype = lens.face, path.dtype
        kind = self._kind = kind_of(path.dtype)
        self._halves, self._emitter = Halves.of(samples, (1, 1), mirrored), lens.emitter
        self.mirrored = self._halves.mirrored
        shares = [lens.emitter.shares(axis) for axis in (0, 1)]
        across, up = (
            _rays(net, samples, axis, shares[axis], self._halves, kind) for axis in (0, 1)
        )
        self._all, self._inside = (across, up), lens.emitter.inside
        self._moving, self._still = split((across, up), locked)
        self._still_light: tuple[Filter, Tensor, Sums] | None = None
        self.traced = count(self._moving) / count((across, up))
        self._level, self._receiver = path.datum, path.receiver
        entering, beside = lens.entering.at(1.0, 1.0), lens.emitter.beside
        self._before = {lens.missed: beside, lens.reflected: (1 - entering) * (1 - beside)}
        self._optics = Optics(
            kind(n),
            kind(n * n - 1),
            kind(path.receiver.numbers().point[2]),
            kind(16 * np.finfo(kind).eps),
            kind(entering / cells(samples)),
            kind(-lens.entrance_z),
            kind(lens.face.absorption),
            lens.face.law.cast(kind),
        )

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.Tracer`."""
        notes = ["collimated light: entrance refraction and intersection left out"]
        notes += self._halves.notes
        if self.traced < 1:
            notes.append(f"locked control points: {self.traced:.0%} of the rays after the first")
        return notes

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._halves.splits(self._emitter.splits)

    def inside(self, rays: Rays) -> Array:
        """Part of what some rays stand for that is glass: a row for each v, or one for all."""
        if self._inside is None:
            return np.ones((1, len(rays[0].place)))
        columns, rows = (
            np.searchsorted(every.place, some.place)
            for every, some in zip(self._all, rays, strict=True)
        )
        return self._inside[columns].T[rows]

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(self._receiver, filter, self._kind)
        face = heights[self._face.name]

        def traced(rays: Rays) -> tuple[Tensor, Sums]:
            return trace(face, self._level, self._dtype, _Passes(self, rays, spread))

        flux, sums = traced(self._moving)
        if self._still:
            if self._still_light is None or self._still_light[0] != filter:
                with torch.no_grad():
                    parts = [traced(rays) for rays in self._still]
                self._still_light = filter, *_together(parts)
            flux, sums = _together([(flux, sums), self._still_light[1:]])
        return self._face.light(flux, sums, self._before)

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        spread = make_spread(self._receiver, BoxFilter(), self._kind)
        landing = Landing(_Passes(self, self._moving, spread))
        traced = trace(heights[self._face.name], self._level, self._dtype, landing)
        return Nodes(*self._face.light(*traced, self._before))


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
                (Step(Plane(z=z), Refraction(law=law, reflected=reflected), missed), _),
            ) if face is not None:
                return cls(emitter, z, missed, law, reflected, face)
        return None


def _rays(
    net: ControlNet,
    samples: Samples,
    axis: int,
    share: Array,
    halves: Halves,
    kind: type[np.floating[Any]],
) -> Axis:
    """All rays along an axis, or the first half of them; see `CollimatedEmitter.shares`."""
    part = halves.first(places(samples, axis).part, axis)
    return make_axis(net, axis, part, kind, halves.weighted(share, axis))


def _together(parts: Sequence[tuple[Tensor, Sums]]) -> tuple[Tensor, Sums]:
    """The light of several sets of rays."""
    images, sums = zip(*parts, strict=True)
    return sum(images[1:], images[0]), Sums(*map(sum, zip(*sums, strict=True)))


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few rays."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    across, up = (_rays(net, (2, 2), axis, np.ones(2), Halves(None, None), kind) for axis in (0, 1))
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


class _Passes(GridPasses):
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
            source._optics,
        )
        self._arriving = float(source._optics.arriving)
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
