"""Light through two freeform faces, by samples of the first: `optics.front_samples`' twin.

Each sample's light is refracted at the entrance face, searches for the exit face from where it met
that of the last lens, and leaves. All in one pass, and nothing is kept for the way back but depths.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.front_samples import FrontGrid, FrontSamples
from workbench.optics.intersection import RIM
from workbench.optics.kernels import threads
from workbench.optics.kernels.aperture import Aperture
from workbench.optics.kernels.exit_face import ExitFace
from workbench.optics.kernels.front_light import FarLight, NearLight
from workbench.optics.kernels.function import kind_of, trace_two
from workbench.optics.kernels.grid import Axis, make_axis
from workbench.optics.kernels.origin_receive import Landing, landing_of
from workbench.optics.kernels.origins import halved, notes_of
from workbench.optics.kernels.point_face import Face, heights_cotangent, make_table
from workbench.optics.kernels.two_face_loops import FROM_FAR, FROM_NEAR
from workbench.optics.kernels.two_face_trace import (
    ABSORBED,
    ENTERED,
    LEFT_LENS,
    MET_EXIT,
    MET_FRONT,
    PASSED,
    STEEP_X,
    SUMS,
    Body,
)
from workbench.optics.light import Nodes
from workbench.optics.path import Path
from workbench.optics.patterns import pattern_numbers
from workbench.optics.samples import Corners, places
from workbench.optics.transmittance import TransmittanceLaw

Kind = type[np.floating[Any]]

# No slope of light in the glass is larger.
_STEEPEST = 1e9


class FusedTwoFaces:
    """Samples of the entrance face, those of `workbench.optics.front_samples.FrontSamples`.

    Parameters
    ----------
    path : Path
        One that `matches`.
    mirrored : tuple[bool, bool]
        Whether heights, lens and source are mirror images of themselves in x, in y: then of origins
        that are mirror images of each other one is traced.
    """

    name = "two faces"

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        return FrontGrid.of(path) is not None

    def __init__(self, path: Path, mirrored: tuple[bool, bool] = (False, False)) -> None:
        front = FrontGrid.of(path)
        if front is None:
            raise TypeError("the kernel for two faces does not match this path")
        kept, self.mirrored = halved(front.origins, mirrored)
        self._count, self._front = len(front.origins.flux), front._replace(origins=kept)
        self._dtype = path.dtype
        self._given = _Given(self._front, path, self.mirrored)

    @property
    def notes(self) -> list[str]:
        """See `workbench.optics.light.BeamTracer`."""
        return notes_of(self._front.origins, self._count, FrontSamples.note)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`."""
        return self._front.splits

    def nodes(self, heights: Mapping[str, Tensor]) -> Nodes:
        """Trace the corners of cells of light; see `workbench.optics.light.BeamTracer`."""
        given = self._given
        first, second = (heights[face.name] for face in given.faces)
        return trace_two(
            (first, second), given.nets, given.levels, self._dtype, _TwoFacePasses(given)
        )


class _Given:
    """What stays from lens to lens, and where the rays met the last one."""

    def __init__(self, front: FrontGrid, path: Path, mirrored: tuple[bool, bool]) -> None:
        kind = kind_of(path.dtype)
        self.faces = _faces(front)
        entrance, leaving = self.faces
        self.front, self.kind = front, kind
        self.nets = entrance.net, leaving.net
        self.levels = entrance.level, leaving.level
        self.mirrored = [axis for axis in (0, 1) if mirrored[axis]]
        self.bases = tuple(
            _axis(front.net, axis, line.part, kind) for axis, line in enumerate(front.lines)
        )
        self.face = Face(leaving.net, path.dtype)
        by_x2, by_y2 = (kind(1 / r**2) for r in front.half_width)
        self.body = Body(
            _aperture(front, kind),
            np.ascontiguousarray(front.areas.T, kind),
            kind(entrance.level - leaving.level),
            kind(16 * np.finfo(kind).eps),
            kind(leaving.absorption),
            not front.outline.whole,
            by_x2,
            by_y2,
            kind(RIM),
            entrance.law.cast(kind),
            leaving.law.cast(kind),
        )
        self.landing = landing_of(path.receiver, leaving.level - path.datum, kind)
        self.light = _light(front, kind)
        columns, rows = (len(basis.place) for basis in self.bases)
        self.shape = len(front.origins.flux) * rows, columns
        self.bounds = threads.split(columns, self.shape[0] * columns)
        self.parts = len(self.bounds) - 1
        self.depths = np.full(self.shape, np.inf, kind)
        self.steepest = np.full(2, _STEEPEST, kind)  # as long as they are not known


class _TwoFacePasses:
    """The trace of one lens, and its adjoint; see `function.PassesOfTwo`."""

    def __init__(self, given: _Given) -> None:
        self._given = given

    def forward(
        self, first: AnyArray, second: AnyArray
    ) -> tuple[tuple[AnyArray, AnyArray], Account]:
        """Nodes (3, origins × samples along v, samples along u), rooms, and where light went."""
        given = self._given
        size = max(given.front.half_width) / 4
        face = given.face
        bounds = face.bounds(second, given.steepest, size)
        self._exit = face.net, bounds, make_table(second, face.powers)
        self._depths = given.depths.copy()
        nodes, room = np.empty((3, *given.shape), given.kind), np.empty(given.shape, given.kind)
        sums = np.zeros((given.parts, SUMS))
        self._run("land", first, lambda part: (nodes, room, sums[part]))
        given.depths, given.steepest = self._depths, sums[:, STEEP_X:].max(axis=0)
        return (nodes, room), self._account(2 ** len(given.mirrored) * sums.sum(axis=0))

    def backward(
        self, first: AnyArray, second: AnyArray, *cotangents: AnyArray
    ) -> tuple[AnyArray, AnyArray]:
        """Cotangents of the heights from those of nodes and rooms of one of the mirror images."""
        given, table = self._given, self._exit[2]
        gradients = np.zeros((given.parts, *first.shape))
        d_tables = np.zeros((given.parts, *table.shape))
        self._run("back", first, lambda part: (cotangents, (gradients[part], d_tables[part])))
        entrance = gradients.sum(axis=0)
        leaving = heights_cotangent(d_tables, second.shape, given.face.powers)
        for axis in given.mirrored:  # the other origins would have given the mirror image of this
            entrance = (entrance + np.flip(entrance, axis)) / 2
            leaving = (leaving + np.flip(leaving, axis)) / 2
        return entrance, leaving

    def _run(self, name: str, first: AnyArray, results: Any) -> None:
        given = self._given
        loops = FROM_FAR if given.front.origins.infinite else FROM_NEAR
        kernel = getattr(loops, name)
        known = first, given.bases, self._exit, given.light, given.body, given.landing, self._depths

        def work(part: int) -> None:
            kernel(*known, given.bounds[part], given.bounds[part + 1], *results(part))

        threads.run(work, given.parts)

    def _account(self, sums: AnyArray) -> Account:
        met, entered, absorbed, arrived, passed, left = sums[
            [MET_FRONT, ENTERED, ABSORBED, MET_EXIT, PASSED, LEFT_LENS]
        ].tolist()
        entrance, leaving = self._given.faces
        lost = {
            entrance.missed: 1 - met,
            entrance.reflected: met - entered,
            "total_reflection": arrived - passed,
            leaving.missed: entered - absorbed - arrived,
            leaving.reflected: passed - left,
        }
        return Account(left, lost | ({"absorbed": absorbed} if leaving.absorption > 0 else {}))


def _faces(front: FrontGrid) -> tuple[ExitFace, ExitFace]:
    entrance, leaving = ExitFace.at(front.entrance), ExitFace.at(front.exit)
    if entrance is None or leaving is None:
        raise TypeError("the kernel for two faces takes B-splines that refract")
    return entrance, leaving


def _aperture(front: FrontGrid, kind: Kind) -> Aperture:
    origins, curved = front.origins, not front.outline.whole
    straight = origins.infinite and not origins.places[:, :2].any()
    low_x, high_x, low_y, high_y = (
        np.ascontiguousarray((2 * end - 1) * r, kind)
        for line, r in zip(front.lines, front.half_width, strict=True)
        for end in (line.low, line.high)
    )
    (r_x, r_y), ends = front.half_width, (low_x, high_x, low_y, high_y)
    size = kind(r_x), kind(r_y), curved, kind(1 / r_x**2), kind(1 / r_y**2)
    return Aperture(straight, kind(front.front_z - front.level), *size, *ends)


def _axis(net: ControlNet, axis: int, part: Array, kind: Kind) -> Axis:
    found = make_axis(net, axis, part, kind)
    return found._replace(place=found.place.astype(kind))


def _light(front: FrontGrid, kind: Kind) -> FarLight | NearLight:
    origins = front.origins
    x, y, z = origins.places.T
    if origins.infinite:
        x, y, z, flux = (part.astype(kind) for part in (x, y, z, origins.flux * z))
        return FarLight(
            x, y, z, flux, kind(2 / origins.waist**2), kind(front.front_z - front.level)
        )
    x, y, below, ahead, flux = (
        part.astype(kind) for part in (x, y, front.level - z, front.front_z - z, origins.flux)
    )
    patterns = pattern_numbers(front.patterns(), kind)
    return NearLight(x, y, below, ahead, flux, kind(origins.lambertian), *patterns)


def compile_for(dtype: torch.dtype) -> None:
    """Compile the kernels for a float type by tracing a few samples."""
    kind = kind_of(dtype)
    net = ControlNet((2, 2), (1, 1), (1.0, 1.0))
    bases = tuple(_axis(net, axis, places(Corners(1, 1), axis).part, kind) for axis in (0, 1))
    face, heights, one = Face(net, dtype), np.zeros(net.shape, kind), kind(1)
    exit_face = face.net, face.bounds(heights, np.ones(2)), make_table(heights, face.powers)
    pair, axes = np.ones(2, kind), (one, one, one)
    laws = (TransmittanceLaw.fresnel(ratio).cast(kind) for ratio in (1 / 1.5, 1.5))
    aperture = Aperture(False, one, one, one, False, one, one, pair, pair, pair, pair)
    body = Body(aperture, np.ones((2, 2), kind), -one, kind(1e-6), one, False, one, one, one, *laws)
    landing = Landing(False, axes, one, axes, axes, one, one)
    table = np.ones((2, 2, 2), kind), one, one, one, one
    near = NearLight(pair, pair, pair, pair, pair, one, *table)
    for loops, light in ((FROM_FAR, FarLight(pair, pair, pair, pair, one, one)), (FROM_NEAR, near)):
        nodes, gradients = np.zeros((3, 4, 2), kind), (np.zeros((2, 2)), np.zeros((1, 2, 2)))
        given = heights, bases, exit_face, light, body, landing, np.zeros((4, 2), kind), 0, 2
        loops.land(*given, nodes, nodes[0], np.zeros(SUMS))
        loops.back(*given, (nodes, nodes[0]), gradients)
