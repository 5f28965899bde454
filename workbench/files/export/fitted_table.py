"""Table of intensity on planes C and angles γ, as fine as the light of a lens needs.

The values are a non-negative least-squares fit of the piecewise linear table over the solid angle.
At edges of the light its error is a third smaller than that of sampled values.

Planes or angles are refined, whichever helps more, until the error is small enough or the table as
large as programs can read.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple, Self

import numpy as np
from scipy.ndimage import binary_dilation, map_coordinates
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu

from workbench.arrays import Array, Mask
from workbench.files.export.far_light import FarLight, directions_of
from workbench.measured.photometry import IntensityTable
from workbench.measured.photometry.table import table_of

# Dark planes and angles are left out if there are as many as lit ones.
_DARK = 2
GOAL = 0.01
"""Relative L2 error of a table that is fine enough."""
MOST_VALUES = 600_000
"""Most intensities of a table: some 5 MB of text."""
# Steps of γ: 10°, halved repeatedly. Steps of C: none if all planes are equal, 30°, then as γ.
_COARSEST, _PLANES = 10.0, (360.0, 30.0)
# Relative difference of light from its mirror image up to which only one half is written.
_SYMMETRIC = GOAL / 5
# Width of samples over that of pixels; most samples.
_SAMPLE, _MOST_SAMPLES = 0.7, 1 << 22
# Iterations of the non-negative fit: each reduces the error to a ninth or less.
_ROUNDS = 12
# Pixels compared for choosing steps, and pixels compared at once.
_CHOOSING, _AT_ONCE = 1 << 16, 1 << 20
# Points in all pixels, and most points in a pixel, where the error of a table is sampled.
_POINTS, _MOST_POINTS = 1 << 21, 8
# Relative to the brightest, less counts as no light.
_NONE = 1e-6
# Steps over the light to begin with, margin in pixels, decimals of an angle.
_SEVERAL, _RIM, _DIGITS = 8, 4, 9
_NARROW = 60.0  # degrees of C: narrower light starts with finer planes
_MORE_DIAGONAL = 1e-6


class TableAxis(NamedTuple):
    """Samples of the light along C or γ."""

    lit: tuple[float, float]  # range of angles with light, degrees; samples exceed it
    # (m,), degrees, ascending, and their weights.
    samples: Array
    weight: Array
    # First and last angle of a table; None along an arc of C in a dark circle.
    ends: tuple[float, float] | None
    around: bool = False  # whether the last angle equals the first

    def nodes(self, step: float) -> Array:
        """Angles of a table: multiples of a step around the light, or everywhere if few more."""
        if step >= 360:
            return np.zeros(1)
        low, high = math.floor(self.lit[0] / step) - 1, math.ceil(self.lit[1] / step) + 1
        if self.ends is None:
            return np.asarray(step * np.arange(low, high + 1), dtype=np.float64)
        first, last = (round(end / step) for end in self.ends)
        low, high = max(low, first), min(high, last)
        if last - first <= _DARK * (high - low):
            low, high = first, last
        inner = step * np.arange(low, high + 1)
        ends = np.array(self.ends)
        return np.asarray(np.unique(np.concatenate([ends, inner])), dtype=np.float64)

    def lights(self, nodes: Array) -> Mask:
        """Mask of the angles with light between them and their neighbours."""
        if self.around or len(nodes) == 1:
            return np.ones(max(len(nodes) - self.around, 1), dtype=bool)
        before, behind = np.append(nodes[:1], nodes[:-1]), np.append(nodes[1:], nodes[-1:])
        return np.asarray((behind > self.lit[0]) & (before < self.lit[1]))

    def hats(self, nodes: Array) -> csr_array:
        """Weights of each angle in each sample, shape (angles, m)."""
        count = max(len(nodes) - self.around, 1)
        if count == 1:
            return csr_array(np.ones((1, len(self.samples))))
        low = np.clip(np.searchsorted(nodes, self.samples, side="right") - 1, 0, len(nodes) - 2)
        part = (self.samples - nodes[low]) / (nodes[low + 1] - nodes[low])
        beyond = (part < 0) | (part > 1)  # outside an arc: dark
        values = np.where(beyond, 0.0, [1 - part, part]).ravel()
        rows = np.concatenate([low, (low + 1) % count if self.around else low + 1])
        at = rows, np.tile(np.arange(len(part)), 2)
        return csr_array((values, at), shape=(count, len(part)))


class FittedTable(NamedTuple):
    """Intensity of a lens as stored in a file."""

    # (n_c,), degrees: 0 alone if all planes are equal; 0 to 90 or 0 to 180 if others are mirror
    # images; else 0 to 360, both included.
    c: Array
    intensity: Array  # (n_c, n_g), flux per solid angle
    gamma: Array  # (n_g,), degrees, from 0 to 90

    @property
    def table(self) -> IntensityTable:
        """The table for all planes."""
        return table_of(self.c, self.gamma, self.intensity)

    def times(self, factor: float) -> Self:
        """The table multiplied by a factor."""
        return self._replace(intensity=self.intensity * factor)


class TableError(NamedTuple):
    """Relative L2 error of a table over the solid angle, of means in cells and in pixels."""

    in_cells: float
    in_pixels: float


def fitted_table(light: FarLight) -> FittedTable:
    """Return a small table within the error `GOAL`, or the largest, with the light's flux."""
    samples, choosing = _Samples.of(light), _SomeCells.of(light)
    level = samples.coarsest
    best = samples.fit(level)
    error = choosing.error(best.table)
    while error > GOAL:
        candidates = []
        for finer in ((level[0] + 1, level[1]), (level[0], level[1] + 1)):
            if samples.resolve(finer) and samples.values(finer) <= MOST_VALUES:
                table = samples.fit(finer)
                left = choosing.error(table.table)
                more = math.log(table.intensity.size / best.intensity.size)
                candidates.append((math.log(left / error) / more, finer, table, left))
        if not candidates:
            break
        _, level, best, error = min(candidates, key=lambda candidate: candidate[0])
    return best.times(light.flux / best.table.lumens)


def error_of(table: IntensityTable, light: FarLight) -> TableError:
    """Return the error of a table for a source of flux 1.

    The table is read at random points of each pixel: at middles of pixels a fit is better.
    """
    read = np.empty_like(light.intensity)
    rows, generator = max(_AT_ONCE // len(light.h), 1), np.random.default_rng(1)
    places = int(np.clip(_POINTS // read.size, 1, _MOST_POINTS))
    pixel = light.h[1] - light.h[0], light.v[1] - light.v[0]
    for first in range(0, len(light.v), rows):
        some = slice(first, first + rows)
        h, v = np.meshgrid(light.h, light.v[some])
        read[some] = 0.0
        for _ in range(places):
            beside = generator.uniform(-0.5, 0.5, (2, *h.shape))
            there = directions_of(h + pixel[0] * beside[0], v + pixel[1] * beside[1])
            read[some] += table.at(there) / places
    off = read - light.intensity
    root = np.sqrt(light.row_measure)[:, None]
    cells, pixels = (
        float(np.linalg.norm(wrong) / np.linalg.norm(known))
        for wrong, known in (
            (light.in_cells(off), light.in_cells(light.intensity)),
            (root * off, root * light.intensity),
        )
    )
    return TableError(*(math.hypot(error, light.uncertainty) for error in (cells, pixels)))


class _Samples(NamedTuple):
    """Light on a fine grid of C and γ, to which tables are fitted; intensity (m_c, m_g)."""

    c: TableAxis
    gamma: TableAxis
    intensity: Array

    @classmethod
    def of(cls, light: FarLight) -> Self:
        x, y, z = light.directions()[light.intensity > _NONE * light.intensity.max()].T
        gamma = np.degrees(np.arctan2(np.hypot(x, y), z))
        pixel = light.cell / light.finer
        rim = _RIM * pixel
        lit = max(gamma.min() - rim, 0.0), min(gamma.max() + rim, 90.0)
        more = (lit[1] - lit[0]) / 4
        along = max(lit[0] - more, 0.0), min(lit[1] + more, 90.0)
        arc, ends = _planes_of(light, np.degrees(np.arctan2(-y, x)), rim / max(gamma.min(), pixel))
        more = (arc[1] - arc[0]) / 4
        first, last = ends or (-math.inf, math.inf)
        around = max(arc[0] - more, first), min(arc[1] + more, last)
        wide = (around[1] - around[0]) * math.sin(math.radians(lit[1]))
        high = along[1] - along[0]
        step = _SAMPLE * pixel
        step *= max(1.0, math.sqrt(high * wide / step**2 / _MOST_SAMPLES))
        c, of_c = _middles(around, wide / step)
        gamma, of_gamma = _middles(along, high / step)
        of_gamma *= np.sin(np.radians(gamma))
        return cls(
            TableAxis(arc, c, of_c, ends, around=ends == (0.0, 360.0)),
            TableAxis(lit, gamma, of_gamma, (0.0, 90.0)),
            _sampled(light, c, gamma),
        )

    @property
    def coarsest(self) -> tuple[int, int]:
        arc, wide = (axis.lit[1] - axis.lit[0] for axis in (self.c, self.gamma))
        return len(_PLANES) + _halvings(arc) if arc < _NARROW else 0, _halvings(wide)

    def values(self, level: tuple[int, int]) -> int:
        return math.prod(len(axis.nodes(step)) for axis, step in self._steps(level))

    def resolve(self, level: tuple[int, int]) -> bool:
        return all(step > axis.samples[1] - axis.samples[0] for axis, step in self._steps(level))

    def fit(self, level: tuple[int, int]) -> FittedTable:
        nodes = [axis.nodes(step) for axis, step in self._steps(level)]
        hats = [axis.hats(each) for axis, each in zip((self.c, self.gamma), nodes, strict=True)]
        weighed = [
            hat @ diags_array(axis.weight)
            for axis, hat in zip((self.c, self.gamma), hats, strict=True)
        ]
        wanted = (weighed[1] @ (weighed[0] @ self.intensity).T).T
        c, gamma = (csr_array(some @ hat.T) for some, hat in zip(weighed, hats, strict=True))
        lit = [axis.lights(each) for axis, each in zip((self.c, self.gamma), nodes, strict=True)]
        values = _fit_non_negative(c, gamma, wanted, lit)
        if nodes[1][0] == 0 and gamma[0, 0] > 0:  # γ = 0 is one direction in all planes
            beside = (c @ values[:, 1]).sum() * gamma[0, 1]
            values[:, 0] = max((wanted[:, 0].sum() - beside) / (c.sum() * gamma[0, 0]), 0.0)
        return FittedTable(*_closed(nodes[0], values, self.c), nodes[1])

    def _steps(self, level: tuple[int, int]) -> tuple[tuple[TableAxis, float], ...]:
        number = level[0] - len(_PLANES)
        step = _PLANES[level[0]] if number < 0 else _COARSEST / 2**number
        return (self.c, step), (self.gamma, _COARSEST / 2 ** level[1])


# Projected Richardson iteration from the solution of the unconstrained fit. Unlit angles stay 0.
def _fit_non_negative(c: csr_array, gamma: csr_array, wanted: Array, lit: Sequence[Mask]) -> Array:
    inner = np.ix_(*lit)
    # Regularisation: at a rim few samples may not separate neighbours.
    c, gamma = (
        csr_array(each + _MORE_DIAGONAL * diags_array(each.diagonal() + _NONE * each.max()))
        for each in (each[some][:, some] for each, some in zip((c, gamma), lit, strict=True))
    )
    wanted_inner = wanted[inner]
    found = splu(c.tocsc()).solve(splu(gamma.tocsc()).solve(wanted_inner.T).T)
    share = c.sum(axis=1)[:, None] * gamma.sum(axis=1)
    found = found.clip(0)
    for _ in range(_ROUNDS):
        rest = wanted_inner - (gamma @ (c @ found).T).T
        found = (found + rest / share).clip(0)
    values = np.zeros(wanted.shape)
    values[inner] = found
    return values


class _SomeCells(NamedTuple):
    """Cells of the light that are compared while steps are chosen.

    Unit vectors (k, pixels, 3) of their pixels, solid angle up to a factor and intensity (k,
    pixels).
    """

    directions: Array
    measure: Array
    intensity: Array

    @classmethod
    def of(cls, light: FarLight) -> Self:
        size = light.finer
        lit = binary_dilation(light.in_cells(light.intensity) > 0, iterations=2)
        row, column = np.nonzero(lit)
        most = max(_CHOOSING // size**2, 1)
        if len(row) > most:
            some = np.random.default_rng(1).choice(len(row), most, replace=False)
            row, column = row[some], column[some]
        along = np.arange(size)
        v = (size * row[:, None, None] + along[:, None]) + 0 * along
        h = (size * column[:, None, None] + along) + 0 * along[:, None]
        v, h = v.reshape(len(row), -1), h.reshape(len(row), -1)
        beside = np.random.default_rng(1).uniform(-0.5, 0.5, (2, *v.shape))
        directions = directions_of(
            light.h[h] + beside[0] * (light.h[1] - light.h[0]),
            light.v[v] + beside[1] * (light.v[1] - light.v[0]),
        )
        return cls(directions, light.row_measure[v], light.intensity[v, h])

    def error(self, table: IntensityTable) -> float:
        wrong, known = (
            (values * self.measure).sum(axis=1) / np.sqrt(self.measure.sum(axis=1))
            for values in (table.at(self.directions) - self.intensity, self.intensity)
        )
        return float(np.linalg.norm(wrong) / np.linalg.norm(known))


def _planes_of(
    light: FarLight, c: Array, rim: float
) -> tuple[tuple[float, float], tuple[float, float] | None]:
    cells = light.in_cells(light.intensity)
    most = 2 * _SYMMETRIC * np.linalg.norm(cells)
    in_c0, in_c90 = (
        bool(np.linalg.norm(cells - np.flip(cells, axis)) <= most and middle)
        for axis, middle in (
            (0, abs(light.v[0] + light.v[-1]) < _NONE),
            (1, abs(light.h[0] + light.h[-1]) < _NONE),
        )
    )
    beside = math.degrees(rim)
    if in_c0:
        last = 90.0 if in_c90 else 180.0
        folded = last - np.abs(np.abs(c) - last) if in_c90 else np.abs(c)
        low, high = float(folded.min()) - beside, float(folded.max()) + beside
        return (max(low, 0.0), min(high, last)), (0.0, last)
    c = np.sort(c)
    gaps = np.diff(c, append=c[0] + 360)
    widest = int(gaps.argmax())
    begin, end = float(c[(widest + 1) % len(c)]) - beside, float(c[widest]) + beside
    end += 360.0 * (end < begin)
    if end - begin > 180:
        return (0.0, 360.0), (0.0, 360.0)
    return (begin, end), None


def _closed(c: Array, values: Array, axis: TableAxis) -> tuple[Array, Array]:
    if axis.around and len(c) > 1:
        return c, np.vstack([values, values[:1]])
    if axis.ends is not None or len(c) == 1:
        return c, values
    # Multiples of a step coincide again after a full circle.
    turned = np.round(c % 360, _DIGITS) % 360
    order = np.argsort(turned)
    turned, values = turned[order], values[order]
    if turned[0] > 0:
        turned, values = np.append(0.0, turned), np.vstack([0 * values[:1], values])
    return np.append(turned, 360.0), np.vstack([values, values[:1]])


def _middles(ends: tuple[float, float], count: float) -> tuple[Array, Array]:
    parts = max(math.ceil(count), 2)
    width = (ends[1] - ends[0]) / parts
    return np.asarray(ends[0] + width * (np.arange(parts) + 0.5)), np.full(
        parts, math.radians(width)
    )


def _sampled(light: FarLight, c: Array, gamma: Array) -> Array:
    found = np.empty((len(c), len(gamma)))
    rows = max(_AT_ONCE // len(gamma), 1)
    sin, cos = np.sin(np.radians(gamma)), np.cos(np.radians(gamma))
    for first in range(0, len(c), rows):
        turn = np.radians(c[first : first + rows])[:, None]
        h = np.degrees(np.arctan2(sin * np.cos(turn), cos))
        v = np.degrees(np.arcsin(-sin * np.sin(turn)))
        at = [
            (angle - along[0]) / (along[1] - along[0])
            for angle, along in ((v, light.v), (h, light.h))
        ]
        found[first : first + rows] = map_coordinates(light.intensity, at, order=1, cval=0.0)
    return found


def _halvings(width: float) -> int:
    return max(math.ceil(math.log2(_SEVERAL * _COARSEST / width)), 0)
