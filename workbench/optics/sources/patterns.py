"""Intensities of origins by where their light crosses a plane, in tables.

The reference and its compiled twins interpolate between the same values. Of narrow light, a value
is the mean over what a sample there stands for: the sum over samples is then the integral.
"""

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray, Array
from workbench.optics.samples import Places
from workbench.optics.sources.origins import Origins, Pattern, bulk_of

# Places along an axis at which patterns are looked up: of all origins together, and of each at
# least and at most.
_ALL, _FEWEST, _MOST = 2048, 65, 513
# The table of one point right before the plane reaches so many times its distance: to 88 degrees
# from the axis, beyond which 1e-3 of Lambertian light goes. It has so many places along an axis. By
# a table of the whole face, light of a wide lamp 1e-3 half-widths before a lens was 9 % too much.
_STEEPEST, _OF_NEAR = 32.0, 2049
# Of the light of a table, so much may be beyond the rectangle that is tabulated, on each side.
_BEYOND = 1e-7


class Patterns(NamedTuple):
    """Tables of intensities on a rectangle; linear between values, and constant beyond it."""

    # (origins, n, n), from the least to the largest x, and from the least to the largest y in the
    # last axis.
    values: Array
    # Of the rectangle, scene units.
    middle: tuple[float, float]
    half_width: tuple[float, float]

    @property
    def steps(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Steps between values for each length, along x and y; and the step at x = 0, y = 0."""
        last = self.values.shape[1] - 1
        per_x, per_y = (last / (2 * r) for r in self.half_width)
        m_x, m_y = self.middle
        return (per_x, per_y), (last / 2 - m_x * per_x, last / 2 - m_y * per_y)

    def as_tensor(self, dtype: torch.dtype, device: torch.device | str) -> "PatternTensor":
        """The values as a tensor."""
        values = torch.as_tensor(self.values, dtype=dtype, device=device).contiguous()
        return PatternTensor(values, *self.steps)


class PatternTensor(NamedTuple):
    """`Patterns` in the float type and on the device of a trace."""

    values: Tensor
    per_length: tuple[float, float]
    first: tuple[float, float]


def pattern_numbers(
    patterns: Patterns | None, kind: type[np.floating[Any]]
) -> tuple[AnyArray, Any, Any, Any, Any]:
    """Values, steps for each length and first steps, for kernels; no values of None."""
    if patterns is None:
        return np.zeros((0, 2, 2), kind), kind(0), kind(0), kind(0), kind(0)
    (per_x, per_y), (first_x, first_y) = patterns.steps
    values = np.ascontiguousarray(patterns.values, kind)
    return values, kind(per_x), kind(per_y), kind(first_x), kind(first_y)


def tabulated(
    origins: Origins,
    half_width: tuple[float, float],
    z: float,
    samples: tuple[Places, Places] | None,
) -> Patterns | None:
    """Intensities of each origin towards places of a rectangle across the axis, over its flux.

    `origins`: points before the rectangle; `half_width`: of the rectangle, scene units; `z`: where
    it is; `samples`: where light of samples crosses the rectangle along x and y, scene units. None
    of even samples, of which many are within all that the light has: values are those at places
    then. Returns None where no pattern was given.
    """
    if origins.pattern is None:
        return None
    count = len(origins.flux)
    n = min(max(int(_ALL / math.sqrt(count)), _FEWEST), _MOST)
    middle, half = (0.0, 0.0), half_width
    if samples is not None:
        middle, half = _lit(origins, half_width, z, samples)
    elif count == 1 and (reach := _STEEPEST * (z - origins.places[0, 2])) < max(half_width):
        n, (middle, half) = _OF_NEAR, _around(origins.places[0], half_width, reach)
    if samples is None:
        places = tuple(map(tuple, origins.places.tolist()))
        return Patterns(_known(origins.pattern, places, middle, half, z, n), middle, half)
    across, up = (m + r * np.linspace(-1, 1, n) for m, r in zip(middle, half, strict=True))
    values, distance = _seen(origins.pattern, origins.places, across, up, z)
    # Flux per area is the intensity times this.
    spread = distance**-3
    values = values * spread
    for axis, at in ((1, across), (2, up)):
        part, *ends = samples[axis - 1]
        low, high = (np.interp(at, part, end) for end in ends)
        values = _mean_between(values, at, low, high, axis)
    return Patterns(values / spread, middle, half)


# Asked for by each plan of a run: a table of one near point takes half a second.
@lru_cache(maxsize=2)
def _known(
    pattern: Pattern,
    places: tuple[tuple[float, ...], ...],
    middle: tuple[float, float],
    half: tuple[float, float],
    z: float,
    n: int,
) -> Array:
    """Intensities towards n × n even places of a rectangle."""
    across, up = (m + r * np.linspace(-1, 1, n) for m, r in zip(middle, half, strict=True))
    return _seen(pattern, np.array(places), across, up, z)[0]


def _seen(
    pattern: Pattern, places: Array, across: Array, up: Array, z: float
) -> tuple[Array, Array]:
    """Intensities towards places of a rectangle, and distances of these."""
    place = places[:, None, None]
    x, y = across[:, None] - place[..., 0], up - place[..., 1]
    away = np.broadcast_arrays(x, y, z - place[..., 2])
    distance = np.sqrt(np.square(away).sum(axis=0))
    direction = (away[0] / distance, away[1] / distance, away[2] / distance)
    return pattern.at(np.arange(len(places))[:, None, None], direction), distance


def _around(
    place: Array, half_width: tuple[float, float], reach: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Middle and half-widths of the part of a rectangle within a reach of a point."""
    sides = []
    for foot, r in zip(place[:2].tolist(), half_width, strict=True):
        low, high = max(foot - reach, -r), min(foot + reach, r)
        sides.append((low, high) if low < high else (-r, r))
    (x_0, x_1), (y_0, y_1) = sides
    return ((x_0 + x_1) / 2, (y_0 + y_1) / 2), ((x_1 - x_0) / 2, (y_1 - y_0) / 2)


def _lit(
    origins: Origins,
    half_width: tuple[float, float],
    z: float,
    samples: tuple[Places, Places],
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Middle and half-widths of the part of a rectangle where light is."""
    if origins.emitted is None:
        return (0.0, 0.0), half_width
    light, *places = origins.emitted.onto(z - origins.places[0, 2])
    places = [place + foot for place, foot in zip(places, origins.places[0], strict=False)]
    within = np.all([np.abs(p) <= r for p, r in zip(places, half_width, strict=True)], axis=0)
    if not within.any():
        return (0.0, 0.0), half_width
    sides = []
    for place, r, (_, begins, ends) in zip(places, half_width, samples, strict=True):
        low, high = bulk_of(place[within], light.flux[within], _BEYOND)
        # A value is the mean over a sample, most of which may be beside the light.
        first, last = int(np.searchsorted(begins, low)) - 2, int(np.searchsorted(ends, high)) + 2
        low, high = float(begins[max(first, 0)]), float(ends[min(last, len(ends) - 1)])
        sides.append((max(low, -r), min(high, r)))
    (x_0, x_1), (y_0, y_1) = sides
    return ((x_0 + x_1) / 2, (y_0 + y_1) / 2), ((x_1 - x_0) / 2, (y_1 - y_0) / 2)


def _mean_between(values: Array, at: Array, low: Array, high: Array, axis: int) -> Array:
    """Means of values at even places between two ends each; constant beyond all places."""
    step, last = at[1] - at[0], len(at) - 1
    values = np.moveaxis(values, axis, -1)
    between = (values[..., 1:] + values[..., :-1]) / 2
    sums = np.concatenate([np.zeros_like(values[..., :1]), np.cumsum(between, axis=-1)], axis=-1)

    def up_to(end: Array) -> Array:
        """Integral from the first place, in steps."""
        index = (end - at[0]) / step
        i = np.clip(np.floor(index), 0, last - 1).astype(np.intp)
        first, second = values[..., i], values[..., i + 1]
        inner = np.clip(index - i, 0.0, 1.0)
        outer = np.where(index < 0, first, second) * (index - i - inner)
        return np.asarray(sums[..., i] + first * inner + (second - first) * inner**2 / 2 + outer)

    mean = (up_to(high) - up_to(low)) * step / (high - low)
    return np.ascontiguousarray(np.moveaxis(mean, -1, axis))


def interpolated(patterns: PatternTensor, place: tuple[Tensor, Tensor]) -> Tensor:
    """Values of tables at places; bilinear, and constant beyond the rectangle.

    `patterns`: what `tabulated` gives; `place` (samples along x, origins, samples along y): x and y
    of the places.
    """
    values, last = patterns.values, patterns.values.shape[1] - 1
    origin = torch.arange(len(values), device=values.device).reshape(1, -1, 1)
    (i, u), (j, v) = (
        _cell(along * per_length + first, last)
        for along, per_length, first in zip(place, patterns.per_length, patterns.first, strict=True)
    )
    low = values[origin, i, j] * (1 - v) + values[origin, i, j + 1] * v
    high = values[origin, i + 1, j] * (1 - v) + values[origin, i + 1, j + 1] * v
    return low * (1 - u) + high * u


def _cell(place: Tensor, last: int) -> tuple[Tensor, Tensor]:
    """Number of the cell of a place, and which part of the cell is before it."""
    place = place.clamp(0, last)
    cell = place.detach().floor().clamp(0, last - 1)
    return cell.long(), place - cell
