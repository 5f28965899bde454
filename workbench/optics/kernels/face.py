"""Light of points by samples of the exit face, in one pass: `optics.face_samples`' twin.

Batches are those of `workbench.optics.kernels.rows`: neighbouring u at one v.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array, Mask
from workbench.geometry.surface import ControlNet
from workbench.optics.face_samples import FaceSamples, SampledFace
from workbench.optics.glass import FlatGlass
from workbench.optics.halves import Halves
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.face_numbers import Across, FaceOptics, Number, Up
from workbench.optics.kernels.face_trace import LOOPS
from workbench.optics.kernels.function import Passes, Sums, kind_of, trace
from workbench.optics.kernels.grid import make_axis
from workbench.optics.kernels.passes import GridLanding, GridPasses
from workbench.optics.kernels.spread import Spread, make_canvases, make_spread, pad
from workbench.optics.lattice import SampleAxis, make_lattice
from workbench.optics.light import Light, Nodes
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import places
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import BoxFilter, Filter, GaussianFilter, Screen


class FusedFaceSamples:
    """Samples of the exit face, those of `workbench.optics.face_samples.FaceSamples`.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored : tuple[bool, bool]
        Whether heights, lens and source are mirror images of themselves in x, in y: then the
        samples of one half are traced alone, if their number is even.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points whose heights stay; no use is made of that.
    """

    name = "face"

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        sampled, face = SampledFace.of(path), ExitFace.rectangular(path)
        return path.receiver.upright and sampled is not None and face is not None

    def __init__(
        self,
        path: Path,
        mirrored: tuple[bool, bool] = (False, False),
        locked: Mask | None = None,
    ) -> None:
        sampled, face = SampledFace.of(path), ExitFace.rectangular(path)
        if sampled is None or face is None:
            raise TypeError("the kernel for samples does not match this path")
        source, optic, net = sampled.emitter.source, sampled.emitter.optic, face.net
        lattice = make_lattice(source, optic, sampled.samples, sampled.entering)
        self._face = face
        self._before = {sampled.missed: lattice.missed, sampled.reflected: lattice.reflected}
        self._dtype, self._receiver = path.dtype, path.receiver
        kind = self._kind = kind_of(path.dtype)
        points = int(lattice.x.point.max()) + 1, int(lattice.y.point.max()) + 1
        halves = self._halves = Halves.of(sampled.samples, points, mirrored)
        self.mirrored, self._sampled = halves.mirrored, sampled
        across, up = (
            make_axis(net, axis, halves.first(along.t, axis), kind)
            for axis, along in enumerate((lattice.x, lattice.y))
        )
        self._bases = across, up
        m_x, m_y = (len(basis.place) for basis in self._bases)
        x, y = lattice.x, lattice.y
        bright = halves.weighted(x.width, 0) * (lattice.intensity / lattice.distance**2)
        self._across = Across(*_first(x, m_x, kind), bright.astype(kind))
        self._up = Up(*_first(y, m_y, kind), halves.weighted(y.width, 1).astype(kind))
        n, lambertian = optic.index, source.emission == "lambertian"
        self._glass = FlatGlass(lattice.distance, sampled.entering, lambertian)
        self._widest = float(np.hypot(np.abs(x.away).max(), np.abs(y.away).max()))
        apparent = n * lattice.distance
        self._level = sampled.level
        self._lift = self._level - optic.front_z
        self._optics = FaceOptics(
            kind(n),
            kind(n * n - 1),
            kind(apparent),
            kind(lattice.distance**2),
            kind(lambertian),
            kind(self._lift),
            kind(path.receiver.numbers().point[2] + path.datum - self._level),
            kind(16 * np.finfo(kind).eps),
            kind(face.absorption),
            sampled.entering.cast(kind),
            face.law.cast(kind),
            near=bool((n * n - 1) ** 0.5 * self._widest > apparent),
            rims=bool(x.rim_from_point.any() or y.rim_from_point.any()),
        )

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.Tracer`."""
        return [FaceSamples.note, *self._halves.notes]

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._halves.splits(self._sampled.splits)

    def image(self, heights: Mapping[str, Tensor], filter: Filter) -> Light:
        """Trace a lens; see `workbench.optics.light.Tracer`."""
        spread = make_spread(self._receiver, filter, self._kind)
        traced = self._traced(heights, _FacePasses(self, spread))
        return self._face.light(*traced, self._before)

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        spread = make_spread(self._receiver, BoxFilter(), self._kind)
        traced = self._traced(heights, GridLanding(_FacePasses(self, spread)))
        return Nodes(*self._face.light(*traced, self._before))

    def _traced(self, heights: Mapping[str, Tensor], passes: Passes) -> tuple[Tensor, Sums]:
        face = self._face
        return trace(heights[face.name], face.net, self._level, self._dtype, passes)

    def steps(self, heights: AnyArray) -> int:
        """Steps of Newton's method for a lens of heights above the level."""
        deepest = max(float(heights.max()) + self._lift, 0.0)
        return self._glass.steps(self._widest, deepest, self._dtype)


def _first(
    along: SampleAxis, samples: int, kind: type[Number]
) -> tuple[AnyArray, AnyArray, AnyArray, AnyArray, Number]:
    """What `Across` and `Up` have in common, of the first samples; places are in scene units."""
    numbers = along.away, along.rim_from_point, along.rim_from_place
    away, rim_from_point, rim_from_place = (each[:samples].astype(kind) for each in numbers)
    return along.place[:samples], away, rim_from_point, rim_from_place, kind(1 / along.cell)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few samples."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    bases = tuple(make_axis(net, axis, places((2, 2), axis).part, kind) for axis in (0, 1))
    pair, one = np.ones(2, kind), kind(1)
    across = Across(pair, pair, pair, pair, one, pair)
    up = Up(pair, pair, pair, pair, one, pair)
    laws = TransmittanceLaw.fresnel(1 / 1.5).cast(kind), TransmittanceLaw.fresnel(1.5).cast(kind)
    optics = FaceOptics._make([*(kind(1.5) for _ in FaceOptics._fields[:-4]), *laws, False, False])
    screen = Screen(z=1.0, half_width=(1.0, 1.0), pixels=(2, 2))
    spread = make_spread(PlaneReceiver(screen, 0.0), GaussianFilter(), kind)
    canvas = make_canvases(spread, 1)[0]
    heights, gradient = np.zeros(net.shape, kind), np.zeros(net.shape)
    given = heights, bases, (across, up, optics, 1), spread, 0, 2
    LOOPS.trace(*given, canvas, np.zeros(5))
    LOOPS.trace_back(*given, pad(spread, np.zeros((2, 2), kind)), gradient)
    nodes = np.zeros((3, 2, 2), kind)
    LOOPS.land(*given, nodes, np.zeros(5))
    LOOPS.land_back(*given, nodes, gradient)


class _FacePasses(GridPasses):
    """The trace of one set of samples onto one screen, and its adjoint."""

    def __init__(self, samples: FusedFaceSamples, spread: Spread) -> None:
        super().__init__(LOOPS, samples._bases, spread, samples.mirrored, sums=5)
        self._samples = samples
        kind, across, up = samples._kind, samples._across, samples._up
        columns = (spread.column_0 + spread.per_x * across.place).astype(kind)
        rows = (spread.row_0 + spread.per_y * up.place).astype(kind)
        self._across, self._up = across._replace(place=columns), up._replace(place=rows)

    def light(self, heights: AnyArray) -> tuple[Any, ...]:
        """See `GridPasses`."""
        return self._across, self._up, self._samples._optics, self._samples.steps(heights)

    def account(self, sums: list[float]) -> Sums:
        """See `GridPasses`."""
        on_screen, beside, met, passed, absorbed = sums
        entered = 1 - sum(self._samples._before.values())
        return Sums(
            on_screen,
            off_screen=beside,
            total_reflection=met - passed,
            reflected=passed - on_screen - beside,
            missed=entered - met - absorbed,
            absorbed=absorbed,
        )
