"""The light at the samples of a train in numbers, for its compiled loops."""

import math
from typing import Any

import numpy as np
import torch

from workbench.arrays import AnyArray
from workbench.optics.glass import FlatGlass
from workbench.optics.glass_face import Glass
from workbench.optics.halves import Halves
from workbench.optics.kernels.grid import Axis
from workbench.optics.path import Path
from workbench.optics.patterns import pattern_numbers
from workbench.optics.sampled import SampledTrain
from workbench.optics.samples import Places, cells, parts_inside
from workbench.optics.train.aperture import Aperture
from workbench.optics.train.free_light import FarLight, NearLight
from workbench.optics.train.numbers import (
    EVEN,
    FAR,
    LINES,
    NEAR,
    POINTS,
    SKY,
    EvenLight,
    GivenRays,
    Light,
    OutlineNumbers,
    Points,
    SampleLine,
    Sky,
)
from workbench.optics.transmittance import TransmittanceLaw

Kind = type[np.floating[Any]]
Samples = tuple[SampleLine, SampleLine, OutlineNumbers]


def sample_lines(train: SampledTrain, halves: Halves, kind: Kind) -> Samples:
    """Samples along x and y, and the outline of the faces."""
    whole = train.outline.whole
    across, up = (
        _line(Places(*(halves.first(part, axis) for part in line)), r, whole, kind)
        for axis, (line, r) in enumerate(zip(train.lines, train.half_width, strict=True))
    )
    by_x2, by_y2 = (kind(1 / r**2) for r in train.half_width)
    inside = np.ones((1, len(across.place)), kind)
    if not whole:
        inside = halves.rows(parts_inside(train.outline, *train.lines)).astype(kind)
    return across, up, OutlineNumbers(not whole, inside, by_x2, by_y2)


def incident_light(
    train: SampledTrain, path: Path, halves: Halves, even: bool, kind: Kind
) -> Light:
    """Light at the samples.

    `train`, `path`: the train; `halves`: which samples are traced; `even`: whether light along the
    axis meets no other freeform face; `kind`: float type of the loops.
    """
    origins, counts = len(train.origins.flux), [len(line.part) for line in train.lines]
    light = _no_light(len(halves.first(train.lines[1].part, 1)), origins, kind)
    shares = [halves.weighted(np.ones(count), axis) for axis, count in enumerate(counts)]
    if any(halves.mirrored):
        light = light._replace(share_x=shares[0].astype(kind), share_y=shares[1].astype(kind))
    if even:
        found = _even_light(train, path.emitter, halves, kind)
        return light._replace(kind=EVEN, even=found, share_x=_none(kind), share_y=_none(kind))
    infinite = train.origins.infinite
    if train.glass is not None:
        if infinite:
            return light._replace(kind=SKY, sky=_sky(train.glass, kind))
        return light._replace(kind=POINTS, points=_points(train.glass, kind))
    areas = np.ascontiguousarray(halves.rows(train.areas), kind)
    light = light._replace(aperture=_aperture(train, halves, kind), areas=areas)
    if infinite:
        return light._replace(kind=FAR, far=_far(train, kind))
    return light._replace(kind=NEAR, near=_near(train, kind))


def _even_light(train: SampledTrain, emitter: Any, halves: Halves, kind: Kind) -> EvenLight:
    across, up = (halves.weighted(emitter.shares(axis), axis).astype(kind) for axis in (0, 1))
    flux = 1.0 if train.glass is None else train.glass.law.at(1.0, 1.0)
    inside = np.ones((1, len(across)), kind)
    if emitter.inside is not None:
        inside = np.ascontiguousarray(halves.rows(emitter.inside), kind)
    return EvenLight(across, up, inside, kind(flux / cells(emitter.samples)))


def _sky(glass: Glass, kind: Kind) -> Sky:
    origins, law = glass.origins, glass.law
    d_x, d_y, d_z = origins.places.T
    down = np.sqrt(1 - (1 - d_z**2) * law.ratio**2)  # cosine in the glass
    flux = origins.flux * d_z * law.at(d_z, down)
    slope_x, slope_y, air_x, air_y, flux = (
        part.astype(kind)
        for part in (d_x * law.ratio / down, d_y * law.ratio / down, d_x, d_y, flux)
    )
    return Sky(slope_x, slope_y, air_x, air_y, flux, kind(2 / origins.waist**2))


def _points(glass: Glass, kind: Kind) -> Points:
    origins, distance = glass.origins, glass.distance
    x, y, _ = (part.astype(kind) for part in origins.places.T)
    return Points(
        x,
        y,
        (origins.flux / distance**2).astype(kind),
        kind(distance / glass.law.ratio),
        kind(distance**2),
        kind(origins.lambertian),
        *pattern_numbers(glass.patterns(), kind),
        0,  # as `NewtonSteps` says for each face
        glass.law.cast(kind),
    )


class NewtonSteps:
    """Steps of Newton's method by which light of points behind glass is found at all samples.

    `glass`: the entrance face; `dtype`: float type of the loops.
    """

    def __init__(self, glass: Glass, dtype: torch.dtype) -> None:
        self._flat, self._dtype = FlatGlass(glass.distance, glass.law, lambertian=False), dtype
        self._lift = glass.level - glass.z
        self._widest = max(
            float(np.hypot(*(np.abs(place[:2]) + glass.net.half_width)))
            for place in glass.origins.places
        )

    @classmethod
    def of(cls, train: SampledTrain, dtype: torch.dtype) -> "NewtonSteps | None":
        """Those of a train; None where there is nothing to be found."""
        if train.glass is None or train.origins.infinite:
            return None
        return cls(train.glass, dtype)

    def steps(self, heights: AnyArray) -> int:
        """How many there are for heights above the level of the face."""
        deepest = max(float(heights.max()) + self._lift, 0.0)
        return self._flat.steps(self._widest, deepest, self._dtype)


def _far(train: SampledTrain, kind: Kind) -> FarLight:
    origins = train.origins
    x, y, z = origins.places.T
    x, y, z, flux = (part.astype(kind) for part in (x, y, z, origins.flux * z))
    front = kind(train.front_z - train.level)
    return FarLight(x, y, z, flux, kind(2 / origins.waist**2), front)


def _near(train: SampledTrain, kind: Kind) -> NearLight:
    origins = train.origins
    x, y, z = origins.places.T
    x, y, below, ahead, flux = (
        part.astype(kind) for part in (x, y, train.level - z, train.front_z - z, origins.flux)
    )
    patterns = pattern_numbers(train.patterns(), kind)
    return NearLight(x, y, below, ahead, flux, kind(origins.lambertian), *patterns)


def _aperture(train: SampledTrain, halves: Halves, kind: Kind) -> Aperture:
    origins, curved = train.origins, not train.outline.whole
    straight = origins.infinite and not origins.places[:, :2].any()
    low_x, high_x, low_y, high_y = (
        np.ascontiguousarray((2 * halves.first(end, axis) - 1) * r, kind)
        for axis, (line, r) in enumerate(zip(train.lines, train.half_width, strict=True))
        for end in (line.low, line.high)
    )
    (r_x, r_y), ends = train.half_width, (low_x, high_x, low_y, high_y)
    size = kind(r_x), kind(r_y), curved, kind(1 / r_x**2), kind(1 / r_y**2)
    return Aperture(straight, kind(train.front_z - train.level), *size, *ends)


def _line(line: Places, half_width: float, whole: bool, kind: Kind) -> SampleLine:
    place, low, high = (((2 * part - 1) * half_width).astype(kind) for part in line)
    return SampleLine(place, low, high, kind(half_width if whole else math.inf))


def _none(kind: Kind) -> AnyArray:
    return np.zeros(0, kind)


def given_light(values: AnyArray, rims: AnyArray) -> Light:
    """Light of rays that were followed up to the first freeform face; see `GivenRays`."""
    light = _no_light(values.shape[1], 1, values.dtype.type)
    return light._replace(kind=LINES, given=GivenRays(values, rims))


def no_samples(kind: Kind) -> tuple[AnyArray, tuple[Axis, Axis], Samples]:
    """Heights, basis and samples of a first face where none is sampled."""
    none, square = _none(kind), np.zeros((0, 0), kind)
    axis = Axis(np.zeros(0), np.zeros(0, np.uintp), square, square, none)
    line = SampleLine(none, none, none, kind(0))
    return square, (axis, axis), (line, line, OutlineNumbers(False, square, kind(0), kind(0)))


def _no_light(rows: int, origins: int, kind: Kind) -> Light:
    none, zero, law = _none(kind), kind(0), TransmittanceLaw.constant(1.0, 0.0).cast(kind)
    table, square = pattern_numbers(None, kind), np.zeros((0, 0), kind)
    return Light(
        EVEN,
        EvenLight(none, none, square, zero),
        Sky(none, none, none, none, none, zero),
        Points(none, none, none, zero, zero, zero, *table, 0, law),
        FarLight(none, none, none, none, zero, zero),
        NearLight(none, none, none, none, none, zero, *table),
        GivenRays(np.zeros((6, 0, 0), kind), square),
        Aperture(True, zero, zero, zero, False, zero, zero, none, none, none, none),
        square,
        none,
        none,
        rows,
        origins,
    )
