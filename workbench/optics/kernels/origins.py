"""Light of many origins by samples of the exit face, in one pass: `optics.shared_grid`'s twin.

With 64 directions of the sun and 256 × 256 samples a trace takes some 20 ms on two cores, and its
adjoint as much: 9 ns for a ray and a core.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.geometry.surface import ControlNet
from workbench.optics.glass import FlatGlass
from workbench.optics.kernels import threads
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.function import Sums, kind_of, trace
from workbench.optics.kernels.grid import make_axis
from workbench.optics.kernels.origin_loops import FROM_POINTS, FROM_SKY
from workbench.optics.kernels.origin_numbers import Medium, OutlineNumbers, Points, SampleLine, Sky
from workbench.optics.kernels.origin_receive import Landing, landing_of
from workbench.optics.light import Nodes
from workbench.optics.path import Path
from workbench.optics.patterns import pattern_numbers
from workbench.optics.samples import Corners, Places, places
from workbench.optics.shared_grid import SharedGrid, SharedSamples
from workbench.optics.sources.origins import Origins
from workbench.optics.transmittance import TransmittanceLaw
from workbench.said import Said

Kind = type[np.floating[Any]]

# Origins nearer to each other's mirror image than this part of their extent count as a pair.
_SAME = 1e-9


class FusedOrigins:
    """Samples of the exit face, those of `workbench.optics.shared_grid.SharedSamples`.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored : tuple[bool, bool]
        Whether heights, lens and source are mirror images of themselves in x, in y: then of origins
        that are mirror images of each other one is traced.
    """

    name = "origins"

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        return SharedGrid.of(path) is not None and ExitFace.of(path) is not None

    def __init__(self, path: Path, mirrored: tuple[bool, bool] = (False, False)) -> None:
        shared, face = SharedGrid.of(path), ExitFace.of(path)
        if shared is None or face is None:
            raise TypeError("the kernel for origins does not match this path")
        self._face, self._level, self._dtype = face, shared.level, path.dtype
        self._before = shared.before()
        self._count = len(shared.origins.flux)
        kept, self.mirrored = halved(shared.origins, mirrored)
        self._shared = shared._replace(origins=kept)
        entered = 1 - sum(self._before.values())
        self._passes = _OriginPasses(self._shared, face, path, entered, self.mirrored)

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.BeamTracer`."""
        return notes_of(self._shared.origins, self._count, SharedSamples.note)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._shared.splits

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        face = self._face
        traced = trace(heights[face.name], face.net, self._level, self._dtype, self._passes)
        return Nodes(*face.light(*traced, self._before))


class _OriginPasses:
    """The trace of one grid of samples, and its adjoint; see `function.Passes`."""

    def __init__(
        self,
        shared: SharedGrid,
        face: ExitFace,
        path: Path,
        entered: float,
        mirrored: tuple[bool, bool],
    ) -> None:
        kind, n = kind_of(path.dtype), face.law.ratio
        lift = shared.level - shared.entrance_z
        self._shared, self._kind, self._dtype = shared, kind, path.dtype
        self._mirrored = [axis for axis in (0, 1) if mirrored[axis]]
        self._bases = tuple(
            make_axis(face.net, axis, line.part, kind) for axis, line in enumerate(shared.lines)
        )
        self._lines = tuple(
            _line(places, r, shared.outline.whole, kind)
            for places, r in zip(shared.lines, shared.half_width, strict=True)
        )
        by_x2, by_y2 = (kind(1 / r**2) for r in shared.half_width)
        inside = np.ascontiguousarray(shared.inside.T, kind)
        self._outline = OutlineNumbers(not shared.outline.whole, inside, by_x2, by_y2)
        critical = kind(16 * np.finfo(kind).eps)
        absorption, law = kind(face.absorption), face.law.cast(kind)
        self._medium = Medium(kind(n), kind(n * n - 1), kind(lift), critical, absorption, law)
        self._landing = landing_of(path.receiver, shared.level - path.datum, kind)
        self._entered, self._lift = entered, lift
        self._patterns = pattern_numbers(shared.patterns(), kind)
        self._glass = FlatGlass(shared.distance, shared.law, lambertian=False)
        columns, rows = (len(line.place) for line in self._lines)
        self._shape = len(shared.origins.flux) * rows, columns
        self._bounds = threads.split(columns, self._shape[0] * columns)
        self._parts = len(self._bounds) - 1

    def forward(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        """Nodes (3, origins × samples along v, samples along u), and what became of the light."""
        nodes = np.empty((3, *self._shape), heights.dtype)
        sums = np.zeros((self._parts, 4))
        loops, given = self._given(heights)
        threads.run(lambda k: loops.land(*given, *self._span(k), nodes, sums[k]), self._parts)
        copies = 2 ** len(self._mirrored)
        absorbed, met, passed, left = (copies * sums.sum(axis=0)).tolist()
        return nodes, Sums(
            on_screen=left,
            off_screen=0.0,
            total_reflection=met - passed,
            reflected=passed - left,
            missed=self._entered - met - absorbed,
            absorbed=absorbed,
        )

    def backward(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        """Cotangent of the heights from that of the nodes, to which mirror images were added."""
        gradients = np.zeros((self._parts, *heights.shape))
        loops, given = self._given(heights)
        threads.run(
            lambda k: loops.back(*given, *self._span(k), cotangent, gradients[k]), self._parts
        )
        gradient = gradients.sum(axis=0)
        for axis in self._mirrored:  # the other origins would have given the mirror image of this
            gradient = (gradient + np.flip(gradient, axis)) / 2
        return np.asarray(gradient)

    def _span(self, part: int) -> tuple[int, int]:
        return self._bounds[part], self._bounds[part + 1]

    def _given(self, heights: AnyArray) -> tuple[Any, tuple[Any, ...]]:
        """Kernels and what they take."""
        infinite = self._shared.origins.infinite
        origins = self._sky() if infinite else self._points(heights)
        grid = self._bases, (*self._lines, self._outline)
        given = heights, *grid, origins, self._medium, self._landing
        return (FROM_SKY if infinite else FROM_POINTS), given

    def _sky(self) -> Sky:
        shared, kind = self._shared, self._kind
        origins, law = shared.origins, shared.law
        d_x, d_y, d_z = origins.places.T
        down = np.sqrt(1 - (1 - d_z**2) * law.ratio**2)  # cosine in the glass
        flux = origins.flux * d_z * law.at(d_z, down)
        slope_x, slope_y, air_x, air_y, flux = (
            part.astype(kind)
            for part in (d_x * law.ratio / down, d_y * law.ratio / down, d_x, d_y, flux)
        )
        return Sky(slope_x, slope_y, air_x, air_y, flux, kind(2 / origins.waist**2))

    def _points(self, heights: AnyArray) -> Points:
        shared, kind, distance = self._shared, self._kind, self._shared.distance
        x, y, _ = (part.astype(kind) for part in shared.origins.places.T)
        widest = max(
            float(np.hypot(*(np.abs(place[:2]) + shared.half_width)))
            for place in shared.origins.places
        )
        deepest = max(float(heights.max()) + self._lift, 0.0)
        return Points(
            x,
            y,
            (shared.origins.flux / distance**2).astype(kind),
            kind(distance / shared.law.ratio),
            kind(distance**2),
            kind(shared.origins.lambertian),
            *self._patterns,
            self._glass.steps(widest, deepest, self._dtype),
            shared.law.cast(kind),
        )


def _line(places: Places, half_width: float, whole: bool, kind: Kind) -> SampleLine:
    place, low, high = (((2 * part - 1) * half_width).astype(kind) for part in places)
    return SampleLine(place, low, high, kind(half_width if whole else math.inf))


def halved(origins: Origins, wanted: tuple[bool, bool]) -> tuple[Origins, tuple[bool, bool]]:
    """Origins of which mirror images give all, and along which axes they do.

    Parameters
    ----------
    origins : Origins
        All of them.
    wanted : tuple[bool, bool]
        Along which axes to leave mirror images out, if there are any.
    """
    kept, done = origins, [False, False]
    for axis in (0, 1):
        side = kept.places[:, axis]
        if wanted[axis] and (side != 0).any() and _paired(kept, axis):
            share = np.where(side == 0, 0.5, 1.0)
            some = side >= 0
            kept = kept._replace(places=kept.places[some], flux=(kept.flux * share)[some])
            done[axis] = True
    return kept, (done[0], done[1])


def notes_of(traced: Origins, count: int, note: str) -> list[str]:
    """What is special about a trace of some origins, of so many in all, in words."""
    if traced.infinite:
        one, more = Said("1 direction of light"), Said("{count} directions of light", count=count)
    else:
        one, more = Said("1 point of light"), Said("{count} points of light", count=count)
    notes = [more if count > 1 else one, note]
    if (some := len(traced.flux)) < count:
        notes.append(Said("mirror symmetry: {some} of them are traced", some=some))
    return notes


def _paired(origins: Origins, axis: int) -> bool:
    """Whether each origin has a mirror image of the same flux."""
    flipped = origins.places.copy()
    flipped[:, axis] *= -1
    size = np.ptp(origins.places, axis=0).max()
    orders = (np.lexsort(np.round(p / (_SAME * size)).T) for p in (origins.places, flipped))
    one, other = orders
    same = np.abs(origins.places[one] - flipped[other]).max() <= 2 * _SAME * size
    return bool(same) and np.allclose(origins.flux[one], origins.flux[other], rtol=1e-9)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few samples."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    corners = Corners(1, 1)
    bases = tuple(make_axis(net, axis, places(corners, axis).part, kind) for axis in (0, 1))
    pair, one = np.ones(2, kind), kind(1)
    line, outline = (
        SampleLine(pair, pair, pair, one),
        OutlineNumbers(True, np.ones((2, 2), kind), one, one),
    )
    law = TransmittanceLaw.schlick(1.5).cast(kind)
    medium = Medium(kind(1.5), kind(1.25), one, kind(1e-6), one, law)
    axes = (one, one, one)
    landing = Landing(False, axes, one, axes, axes, one, one)
    heights, gradient, nodes = (
        np.zeros(net.shape, kind),
        np.zeros(net.shape),
        np.zeros((3, 4, 2), kind),
    )
    table = np.ones((2, 2, 2), kind), one, one, one, one
    for loops, origins in (
        (FROM_SKY, Sky(pair, pair, pair, pair, pair, one)),
        (
            FROM_POINTS,
            Points(pair, pair, pair, one, one, one, *table, 1, law),
        ),
    ):
        given = heights, bases, (line, line, outline), origins, medium, landing, 0, 2
        loops.land(*given, nodes, np.zeros(4))
        loops.back(*given, nodes, gradient)
