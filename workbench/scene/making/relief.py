"""Relief that is too fine for a control net: the slopes that it adds to a face.

Places see it at its own phase there, so that rays which fill the face sample the distribution of
its slopes, and two traces of one part see the same relief. It is a few micrometres high: where
rays meet it does not change.
"""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np

from workbench.arrays import Array

_STEPS = np.arange(-6, 8)  # of a periodic profile that reach a period; smoothing is below one
_WAVES = 128  # of a random relief


class FacePlaces(NamedTuple):
    """Places of a face, seen from outside."""

    x: Array  # (m,), in the element's own coordinates, scene units
    y: Array
    slope_x: Array
    slope_y: Array


class Relief(Protocol):
    """What a process adds to a face."""

    @property
    def seen(self) -> bool:
        """Whether there is any of it."""
        return True

    def slopes(self, places: FacePlaces, smoothing: float) -> tuple[Array, Array]:
        """Slopes along x and y that it adds at m places, each (m,).

        `smoothing`: rms width of the Gaussian by which later steps average it, scene units.
        """
        ...


@dataclass(frozen=True)
class Grooves(Relief):
    """Grooves of a round tool side by side, straight or about the axis.

    The tool's sphere moves along each groove, tangent to the face. Seen along a groove its profile
    is a circle, and neighbouring circles meet in ridges, where the normal is turned by d / 2 R from
    that of the face: d is the distance of the tool's centres across the grooves. The curvature of
    the face changes the distance of the grooves on it, and not that angle.
    """

    radius: float  # of the tool, scene units
    period: float  # of the grooves, seen along z
    # Unit vector across them; None for grooves about the axis, as of a turning tool.
    across: tuple[float, float] | None = None

    def slopes(self, places: FacePlaces, smoothing: float) -> tuple[Array, Array]:
        """See `Relief.slopes`."""
        if self.across is None:
            distance = np.hypot(places.x, places.y)
            away = np.maximum(distance, np.finfo(float).tiny)
            c_x, c_y = places.x / away, places.y / away
        else:
            c_x, c_y = (np.full(places.x.shape, each) for each in self.across)
            distance = c_x * places.x + c_y * places.y
        slope = c_x * places.slope_x + c_y * places.slope_y
        feed = 1 + (c_x * places.slope_y - c_y * places.slope_x) ** 2
        steepest = self.period * np.sqrt(1 + slope**2 / feed) / (2 * self.radius)
        tilt = steepest * sawtooth(distance / self.period, smoothing / self.period)
        # The normal turns about the groove, and the slope along it stays.
        more = (slope - tilt * np.sqrt(feed)) / (1 + tilt * slope / np.sqrt(feed)) - slope
        return more * c_x, more * c_y


def sawtooth(phase: Array, smoothing: float) -> Array:
    """Return 2 (t − ½) of the fraction t of a phase, averaged by a Gaussian.

    `smoothing`: rms width of that, in periods.
    """
    part = phase % 1.0
    if smoothing == 0:
        return 2 * part - 1
    if smoothing >= 1:
        return np.zeros_like(part)
    from scipy.special import ndtr  # slow import

    steps = sum(ndtr((part - j) / smoothing) - (j <= 0) for j in _STEPS)
    return np.asarray(2 * (part - steps) - 1)


@dataclass(frozen=True)
class Terraces(Relief):
    """Steps of layers along z, averaged by a Gaussian as wide as a pixel of light."""

    layer: float  # scene units
    width: float  # rms, scene units

    def slopes(self, places: FacePlaces, smoothing: float) -> tuple[Array, Array]:
        """See `Relief.slopes`."""
        steep = np.maximum(np.hypot(places.slope_x, places.slope_y), np.finfo(float).tiny)
        # A height that is not known here is one that any phase stands for.
        phase = (places.slope_x * places.x + places.slope_y * places.y) / self.layer
        periods = np.hypot(self.width, smoothing) * steep / self.layer
        more = comb(phase, periods) - 1
        return more * places.slope_x, more * places.slope_y


def comb(phase: Array, smoothing: Array) -> Array:
    """Return equal impulses at whole phases, averaged by Gaussians; their mean is 1.

    `smoothing` (m,): rms widths of those, in periods.
    """
    part, narrow = phase % 1.0, np.clip(smoothing, 1e-9, 1.0)
    found = np.zeros_like(part)
    for j in _STEPS:
        found += np.exp(-(((part - j) / narrow) ** 2) / 2)
    return np.asarray(found / (narrow * np.sqrt(2 * np.pi)))


@dataclass(frozen=True)
class RandomRelief(Relief):
    """Random waves of an isotropic Gaussian autocorrelation, exp(−r² / l²).

    Sum of plane waves with random phases, whose wave vectors follow the power spectrum (Shinozuka
    and Deodatis, Simulation of stochastic processes by spectral representation, 1991).
    """

    slope: float  # rms of the gradient
    length: float  # l, scene units
    seed: int
    # Wave numbers of the waves that belong to it, radians per scene unit.
    band: tuple[float, float] = (0.0, math.inf)

    @property
    def waves(self) -> tuple[Array, Array, Array]:
        """Wave vectors (n, 2), phases (n,) and heights (n,) of cosine waves."""
        random = np.random.default_rng(self.seed)
        vectors = random.normal(scale=math.sqrt(2) / self.length, size=(_WAVES, 2))
        phases = random.uniform(0, 2 * math.pi, _WAVES)
        numbers = np.linalg.norm(vectors, axis=1)
        height = self.slope * math.sqrt(2 / np.square(numbers).sum())
        low, high = self.band
        belongs = (numbers >= low) & (numbers < high)
        return vectors[belongs], phases[belongs], np.full(np.count_nonzero(belongs), height)

    @property
    def seen(self) -> bool:
        """See `Relief.seen`."""
        return bool(len(self.waves[1]) and self.slope)

    def split(self, number: float) -> "tuple[RandomRelief, RandomRelief]":
        """Its long and its short waves, below a wave number and from there on."""
        return replace(self, band=(0.0, number)), replace(self, band=(number, math.inf))

    def heights(self, x: Array, y: Array, smoothing: float) -> Array:
        """Heights of the error on a grid (n_x, n_y); for the parameters see `Relief.slopes`."""
        vectors, phases, heights = self._damped(smoothing)
        along_x, along_y = np.outer(x, vectors[:, 0]) + phases, np.outer(vectors[:, 1], y)
        # The sine of a sum is a product of matrices over all waves.
        sines, cosines = heights * np.sin(along_x), heights * np.cos(along_x)
        return np.asarray(sines @ np.cos(along_y) + cosines @ np.sin(along_y))

    def _damped(self, smoothing: float) -> tuple[Array, Array, Array]:
        """Waves whose heights a Gaussian has averaged."""
        vectors, phases, heights = self.waves
        return vectors, phases, heights * np.exp(-np.square(vectors).sum(axis=1) * smoothing**2 / 2)

    def slopes(self, places: FacePlaces, smoothing: float) -> tuple[Array, Array]:
        """See `Relief.slopes`."""
        found = np.zeros((2, len(places.x)))
        for vector, phase, height in zip(*self._damped(smoothing), strict=True):
            wave = height * np.cos(vector[0] * places.x + vector[1] * places.y + phase)
            found += vector[:, None] * wave
        return found[0], found[1]
