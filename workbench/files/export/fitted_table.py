"""A table of intensity on planes of C and angles γ, as fine as the light of a lens needs.

The values are the best fit: of all tables on the same angles without a value below 0, theirs is
nearest to the light in the square over the solid angle, linear between the angles. At edges of the
light that table is closer by a third than one of the light's own values at the angles.

Planes and angles get closer, whichever of both helps more, until the table is close enough or as
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
from workbench.files.export.table_axis import TableAxis
from workbench.measured.photometry import IntensityTable
from workbench.measured.photometry.table import table_of

GOAL = 0.01
"""Relative L2 error at which a table is fine enough."""
MOST_VALUES = 600_000
"""Most intensities of a table: some 5 MB of text."""

# Steps of γ: 10° and halves of it. Steps of C: none where all planes are alike, 30°, and the same.
_COARSEST, _PLANES = 10.0, (360.0, 30.0)
# Light may differ by such a part from its mirror image, of which one half is written then.
_ALIKE = GOAL / 5
# Width of samples of the light over that of its pixels, and most samples.
_SAMPLE, _MOST_SAMPLES = 0.7, 1 << 22
# Steps towards the best values that are not negative: each has a ninth of the way left at most.
_ROUNDS = 12
# Pixels by which steps are chosen, and pixels compared at once.
_CHOOSING, _AT_ONCE = 1 << 16, 1 << 20
# Places in all pixels, and in each of them, where a table is read to tell its error.
_PLACES, _MOST_PLACES = 1 << 21, 8
# No light is less than such a part of the brightest.
_NONE = 1e-6
# Steps of the light with which to begin, pixels beside it that are lit, decimals of an angle.
_SEVERAL, _RIM, _DIGITS = 8, 4, 9
_NARROW = 60.0  # degrees of C within which light is on few planes
_MORE_DIAGONAL = 1e-6


class FittedTable(NamedTuple):
    """Intensity of a lens as a file holds it.

    Attributes
    ----------
    c : ndarray, shape (n_c,)
        Degrees: 0 alone where all planes are alike; 0 to 90 or 0 to 180 where others are mirror
        images of these; else 0 to 360, both included.
    intensity : ndarray, shape (n_c, n_g)
        Flux per solid angle.
    gamma : ndarray, shape (n_g,)
        Degrees, from 0 to 90.
    """

    c: Array
    intensity: Array
    gamma: Array

    @property
    def table(self) -> IntensityTable:
        """The same all around."""
        return table_of(self.c, self.gamma, self.intensity)

    def times(self, factor: float) -> Self:
        """The same light, so many times as much."""
        return self._replace(intensity=self.intensity * factor)


class TableError(NamedTuple):
    """Relative L2 distance of a table from the light of a lens, over the solid angle.

    Attributes
    ----------
    in_cells : float
        Of the means in cells; see `FarLight`.
    in_pixels : float
        Of the means in pixels, which are narrower.
    """

    in_cells: float
    in_pixels: float


def fitted_table(light: FarLight) -> FittedTable:
    """Return a small table that is close enough to the light of a lens, or the largest one.

    Its flux is that of the light.
    """
    samples, choosing = _Samples.of(light), _SomeCells.of(light)
    level = samples.coarsest
    best = samples.fit(level)
    error = choosing.error(best.table)
    while error > GOAL:
        ways = []
        for finer in ((level[0] + 1, level[1]), (level[0], level[1] + 1)):
            if samples.resolve(finer) and samples.values(finer) <= MOST_VALUES:
                table = samples.fit(finer)
                left = choosing.error(table.table)
                more = math.log(table.intensity.size / best.intensity.size)
                ways.append((math.log(left / error) / more, finer, table, left))
        if not ways:
            break
        _, level, best, error = min(ways, key=lambda way: way[0])
    return best.times(light.flux / best.table.lumens)


def error_of(table: IntensityTable, light: FarLight) -> TableError:
    """Return how far a table is from the light of a lens, both of a source of flux 1.

    The table is read at random places of each pixel: a fit is closer in the middles of pixels.
    """
    read = np.empty_like(light.intensity)
    rows, generator = max(_AT_ONCE // len(light.h), 1), np.random.default_rng(1)
    places = int(np.clip(_PLACES // read.size, 1, _MOST_PLACES))
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
    """The light on a fine grid of C and γ, to which tables are fitted.

    Attributes
    ----------
    c, gamma : TableAxis
        The axes.
    intensity : ndarray, shape (m_c, m_g)
        Flux per solid angle.
    """

    c: TableAxis
    gamma: TableAxis
    intensity: Array

    @classmethod
    def of(cls, light: FarLight) -> Self:
        """Sample the light of a lens."""
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
        """Numbers of the steps of C and γ with which to begin."""
        arc, wide = (axis.lit[1] - axis.lit[0] for axis in (self.c, self.gamma))
        return len(_PLANES) + _halvings(arc) if arc < _NARROW else 0, _halvings(wide)

    def values(self, level: tuple[int, int]) -> int:
        """How many intensities a table with steps of these numbers has."""
        return math.prod(len(axis.nodes(step)) for axis, step in self._steps(level))

    def resolve(self, level: tuple[int, int]) -> bool:
        """Whether steps of these numbers are wider than those from sample to sample."""
        return all(step > axis.samples[1] - axis.samples[0] for axis, step in self._steps(level))

    def fit(self, level: tuple[int, int]) -> FittedTable:
        """Return the best table with steps of these numbers."""
        nodes = [axis.nodes(step) for axis, step in self._steps(level)]
        hats = [axis.hats(each) for axis, each in zip((self.c, self.gamma), nodes, strict=True)]
        weighed = [
            hat @ diags_array(axis.weight)
            for axis, hat in zip((self.c, self.gamma), hats, strict=True)
        ]
        wanted = (weighed[1] @ (weighed[0] @ self.intensity).T).T
        c, gamma = (csr_array(some @ hat.T) for some, hat in zip(weighed, hats, strict=True))
        lit = [axis.lights(each) for axis, each in zip((self.c, self.gamma), nodes, strict=True)]
        values = _without_negative(c, gamma, wanted, lit)
        if nodes[1][0] == 0 and gamma[0, 0] > 0:  # one direction in all planes
            beside = (c @ values[:, 1]).sum() * gamma[0, 1]
            values[:, 0] = max((wanted[:, 0].sum() - beside) / (c.sum() * gamma[0, 0]), 0.0)
        return FittedTable(*_closed(nodes[0], values, self.c), nodes[1])

    def _steps(self, level: tuple[int, int]) -> tuple[tuple[TableAxis, float], ...]:
        number = level[0] - len(_PLANES)
        step = _PLANES[level[0]] if number < 0 else _COARSEST / 2**number
        return (self.c, step), (self.gamma, _COARSEST / 2 ** level[1])


def _without_negative(c: csr_array, gamma: csr_array, wanted: Array, lit: Sequence[Mask]) -> Array:
    """Values without a negative one for which C · values · Γ is nearest to what is wanted.

    Projected steps of Richardson's method, from the solution that may be negative. Angles that are
    not lit stay dark.
    """
    inner = np.ix_(*lit)
    # A bit more on the diagonal: at a rim, few samples may not tell neighbours apart.
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
    """Cells of the light by which tables are compared while their steps are chosen.

    Attributes
    ----------
    directions : ndarray, shape (k, pixels, 3)
        Of their pixels.
    measure, intensity : ndarray, shape (k, pixels)
        Solid angle up to a factor, and flux per solid angle.
    """

    directions: Array
    measure: Array
    intensity: Array

    @classmethod
    def of(cls, light: FarLight) -> Self:
        """Choose among the cells in and beside the light."""
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
        """Relative L2 distance of the means in cells."""
        wrong, known = (
            (values * self.measure).sum(axis=1) / np.sqrt(self.measure.sum(axis=1))
            for values in (table.at(self.directions) - self.intensity, self.intensity)
        )
        return float(np.linalg.norm(wrong) / np.linalg.norm(known))


def _planes_of(
    light: FarLight, c: Array, rim: float
) -> tuple[tuple[float, float], tuple[float, float] | None]:
    """Between which planes light is, and with which planes a table begins and ends.

    Parameters
    ----------
    light : FarLight
        The light.
    c : ndarray
        Planes of its pixels, degrees.
    rim : float
        How far light may be beside these, as seen from the nadir, radians.
    """
    cells = light.in_cells(light.intensity)
    most = 2 * _ALIKE * np.linalg.norm(cells)
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
    """Planes and their values as a file has them: from 0 to 360 where no others are alike."""
    if axis.around and len(c) > 1:
        return c, np.vstack([values, values[:1]])
    if axis.ends is not None or len(c) == 1:
        return c, values
    # Angles that are multiples of a step come together again beyond the circle.
    turned = np.round(c % 360, _DIGITS) % 360
    order = np.argsort(turned)
    turned, values = turned[order], values[order]
    if turned[0] > 0:
        turned, values = np.append(0.0, turned), np.vstack([0 * values[:1], values])
    return np.append(turned, 360.0), np.vstack([values, values[:1]])


def _middles(ends: tuple[float, float], count: float) -> tuple[Array, Array]:
    """Middles of so many equal parts between two angles in degrees, and their width in radians."""
    parts = max(math.ceil(count), 2)
    width = (ends[1] - ends[0]) / parts
    return np.asarray(ends[0] + width * (np.arange(parts) + 0.5)), np.full(
        parts, math.radians(width)
    )


def _sampled(light: FarLight, c: Array, gamma: Array) -> Array:
    """Intensity in directions, linear between the middles of pixels; shape (m_c, m_g)."""
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
    """How often 10° is halved so that a width has several steps."""
    return max(math.ceil(math.log2(_SEVERAL * _COARSEST / width)), 0)
