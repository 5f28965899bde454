"""The light at the samples of a train in numbers, for its compiled loops; halves of mirror images.

Of light that is its own mirror image along x or y one half is traced. Diagonals of cells are mirror
images of each other too, where an even number of cells lies side by side.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import torch

from workbench.arrays import AnyArray, Array
from workbench.messages import Message
from workbench.optics.glass import FlatGlass
from workbench.optics.glass_face import Glass
from workbench.optics.interfaces import TransmittanceLaw
from workbench.optics.kernels.grid import Axis
from workbench.optics.path import Path
from workbench.optics.sampled import SampledTrain
from workbench.optics.samples import Corners, Places, Samples, cells, counts, parts_inside
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.patterns import pattern_numbers
from workbench.optics.train.free_light import Aperture, FarLight, NearLight
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

# Origins nearer to each other's mirror image than this part of their extent count as a pair.
_SAME = 1e-9


class Halves(NamedTuple):
    """Parts of the first rays along x and y that belong to the half that is traced."""

    # (m,), 1 for most rays, 0.5 for one in the middle; and 0 for one behind it, which shows how the
    # light bends there. None where all rays are traced.
    x: Array | None
    y: Array | None

    @classmethod
    def of(cls, samples: Samples, wanted: tuple[bool, bool]) -> "Halves":
        """Halves of the rays along x and y, where wanted; none of an odd number of cells."""
        x, y = (_half(samples, axis) if wanted[axis] else None for axis in (0, 1))
        return cls(x, y)

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Whether half of the rays are traced along x, along y."""
        return self.x is not None, self.y is not None

    @property
    def notes(self) -> list[str]:
        """What is left out, in words."""
        if not any(self.mirrored):
            return []
        if all(self.mirrored):
            return [Message("mirror symmetry: a quarter of the rays")]
        return [Message("mirror symmetry: half of the rays")]

    def first(self, values: Array, axis: int) -> Array:
        """What there is for all rays along an axis, for those that are traced."""
        half = self[axis]
        return values if half is None else values[: len(half)]

    def rows(self, values: Array) -> Array:
        """Values (m_x, m_y) of all samples for those that are traced, shape (m_y, m_x)."""
        rows = np.ascontiguousarray(self.first(values, 0).T)
        return np.ascontiguousarray(self.first(rows, 1))

    def weighted(self, flux: Array, axis: int) -> Array:
        """The flux of rays along an axis that belongs to the traced half."""
        half = self[axis]
        return flux if half is None else flux[: len(half)] * half

    def splits(self, whole: tuple[Array, Array]) -> tuple[Array, Array]:
        """Of `beam_image`; the flux of the middle ray is all before it."""
        x, y = (self.first(split, axis).copy() for axis, split in enumerate(whole))
        for split, half in ((x, self.x), (y, self.y)):
            if half is not None:
                split[half < 1, :2] = 1.0, 0.0
        return x, y


def _half(samples: Samples, axis: int) -> Array | None:
    count = counts(samples)[axis]
    if count % 2:
        return None
    half = np.ones(count // 2)
    return np.append(half, [0.5, 0.0]) if isinstance(samples, Corners) else half


def halved(origins: Origins, wanted: tuple[bool, bool]) -> tuple[Origins, tuple[bool, bool]]:
    """Origins of which mirror images give all, and along which axes they do.

    `origins`: all of them; `wanted`: along which axes to leave mirror images out, if there are any.
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


def _paired(origins: Origins, axis: int) -> bool:
    """Whether each origin has a mirror image of the same flux."""
    flipped = origins.places.copy()
    flipped[:, axis] *= -1
    size = np.ptp(origins.places, axis=0).max()
    orders = (np.lexsort(np.round(p / (_SAME * size)).T) for p in (origins.places, flipped))
    one, other = orders
    same = np.abs(origins.places[one] - flipped[other]).max() <= 2 * _SAME * size
    return bool(same) and np.allclose(origins.flux[one], origins.flux[other], rtol=1e-9)


def is_on_axis(origins: Origins) -> bool:
    """Whether there is one origin, on the axis, whose light is its own mirror image."""
    return len(origins.flux) == 1 and not origins.places[0, :2].any() and origins.pattern is None


Kind = type[np.floating[Any]]
FaceSamples = tuple[SampleLine, SampleLine, OutlineNumbers]


def sample_lines(train: SampledTrain, halves: Halves, kind: Kind) -> FaceSamples:
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


def no_samples(kind: Kind) -> tuple[AnyArray, tuple[Axis, Axis], FaceSamples]:
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
