"""Optimal transport of one image to another: the back-and-forth method.

Jacobs and Léger (2020), A fast approach to optimal transport: the back-and-forth method. The dual
problem is climbed in turns with respect to each of its two potentials, in the H¹ norm; between
the turns a c-transform makes the one potential the best for the other.

The c-transform φᶜ(y) = min_x ½ w₀ (x₀ − y₀)² + ½ w₁ (x₁ − y₁)² − φ(x), over the places of a grid
with spacing 1, splits into lower envelopes of parabolas along the lines of each axis (Felzenszwalb
and Huttenlocher 2012, Distance transforms of sampled functions). Between places of the grid φ is
taken as a parabola through three of them, so that coarse grids bring images nearer than their
cells: a portrait is 0.44 cells off after eight rounds on 624² cells without this, 0.19 after five.
"""

import math
from typing import Any

import numpy as np
import scipy

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads
from workbench.progress import check_given_up

# Light and target are first carried on grids of half as many cells along each axis, down to this.
_COARSEST = 64
# A few rounds bring most pairs of images as near as a grid allows; one bright pixel takes more.
MOST_ROUNDS = 60
# It is enough when light and target are this near to each other, in cells: a root mean square over
# both directions. What a further round brings nearer then is the rounding of maps to cells.
_NEAR = 0.35
# It is enough as well when so many rounds bring the images nearer by less than this part: on the
# coarsest grid, where rounds cost little, and on finer ones.
_PATIENCE, _COARSE_PROGRESS, _FINE_PROGRESS = 3, 0.03, 0.1
# Rows whose envelopes are written at the same time.
_BLOCK = 8
# Most parts along an axis into which a cell is cut where the map stretches it.
_MOST_PARTS = 8


class Transport:
    """The map that carries one image to another with the least Σ w |x − y|².

    It is found on a coarse grid first; each finer one takes its potential and step lengths over.

    `source`, `target` (m_0, m_1): mass of the cells of equal grids with spacing 1; each sums to 1;
    `weights`: w along the two axes; `rounds`: the most on the grid itself; see `improve`;
    `coarse`: transport of about the same on a grid whose cells are 2, 4, 8 … times as large, to
    begin with; by default it is found on the coarsest one.
    """

    def __init__(
        self,
        source: Array,
        target: Array,
        weights: tuple[float, float],
        rounds: int = MOST_ROUNDS,
        coarse: "Transport | None" = None,
    ) -> None:
        self._target, self._weights = target, weights
        self._waves = _laplacian(source.shape, weights)
        # Each potential has a step of its own: that of a dim wide image may be a thousand times
        # that of a few bright pixels.
        coarsest = _COARSEST if coarse is None else coarse.cells
        if all(m % 2 == 0 and m >= 2 * coarsest for m in source.shape):
            self._progress = _FINE_PROGRESS
            if coarse is None or min(source.shape) > 2 * coarse.cells:
                coarse = Transport(halved(source), halved(target), weights, coarse=coarse)
            # The potential whose map goes to the target, in cells squared. A finer one has four
            # times the numbers, and steps as many times the length.
            self._there: Array = 4 * doubled(coarse._there)
            self._steps: tuple[float, float] = 4 * coarse._steps[0], 4 * coarse._steps[1]
        else:
            self._progress = _COARSE_PROGRESS
            self._there = np.zeros_like(source)
            self._steps = (4 / max(source.max(), target.max()),) * 2
        self.improve(source, rounds)

    @property
    def cells(self) -> int:
        """Cells of the grid along an axis, the one with the fewest."""
        return int(min(self._there.shape))

    def improve(self, source: Array, rounds: int = MOST_ROUNDS) -> None:
        """Go on for a source that has changed a little, for so many rounds or fewer."""
        target, weights = self._target, self._weights
        there, back = self._there, c_transform(self._there, *weights)
        value = _product(there, source) + _product(back, target)
        step, step_back = self._steps
        nearest, idle = math.inf, 0
        best = there
        for _ in range(rounds):
            check_given_up()
            before = step, step_back
            there, back, value, step, far = self._climb(there, back, source, target, value, step)
            back, there, value, step_back, far_back = self._climb(
                back, there, target, source, value, step_back
            )
            grows = step > before[0] or step_back > before[1]
            distance = far + far_back
            nearer = distance < (1 - self._progress) * nearest
            idle = 0 if nearer or grows else idle + 1
            if distance < nearest:
                nearest, best = distance, there  # steps may be too long for a while
            if idle == _PATIENCE or distance * math.sqrt(source.size) < _NEAR:
                step, step_back = before  # shorter ones are for what this grid cannot show
                break
        self._there, self._steps = best, (step, step_back)

    def map(self) -> tuple[Array, Array]:
        """Where the middles of the source's cells go, in cells of the target along each axis."""
        return mapped(self._there, *self._weights)

    def back(self) -> tuple[Array, Array]:
        """Where the middles of the target's cells come from, in cells of the source."""
        return mapped(c_transform(self._there, *self._weights), *self._weights)

    def _climb(
        self, mine: Array, other: Array, here: Array, there: Array, value: float, step: float
    ) -> tuple[Array, Array, float, float, float]:
        """One step of a potential, then the best of the other for it, and of it for that."""
        missing = here - push(there, *mapped(other, *self._weights))
        workers = threads.workers(missing.size)
        amplitudes = scipy.fft.dctn(missing, norm="ortho", workers=workers) / self._waves
        amplitudes[0, 0] = 0.0
        direction = scipy.fft.idctn(amplitudes, norm="ortho", workers=workers, overwrite_x=True)
        slope = _product(direction, missing)
        mine = mine + step * direction
        other = c_transform(mine, *self._weights)
        gain = _product(mine, here) + _product(other, there) - value
        # Armijo-Goldstein, as in the paper's section 3.3; a gain above what the slope promises is
        # the error of curves between places.
        gained = gain / (step * slope) if slope > 0 else 1.0
        if 0.75 < gained < 1.0:
            step *= 1.4
        elif gained < 0.25:
            step *= 0.5 if gained < 0.0 else 0.7
        mine = c_transform(other, *self._weights)
        value = _product(mine, here) + _product(other, there)
        return mine, other, value, step, math.sqrt(max(slope, 0.0))


def _product(values: Array, others: Array) -> float:
    """Sum of the products of two images, without an image of these."""
    return float(np.vdot(values, others))


def _laplacian(shape: tuple[int, ...], weights: tuple[float, float]) -> Array:
    """Eigenvalues of −∇·(1/w ∇) for cosine waves; the constant's is set to 1."""
    along_0, along_1 = (
        (2 - 2 * np.cos(np.pi * np.arange(m) / m)) / w for m, w in zip(shape, weights, strict=True)
    )
    waves: Array = along_0[:, None] + along_1[None, :]
    waves[0, 0] = 1.0
    return waves


def halved(mass: Array) -> Array:
    """Mass in cells twice as large."""
    return np.asarray(mass[::2, ::2] + mass[1::2, ::2] + mass[::2, 1::2] + mass[1::2, 1::2])


def doubled(values: Array) -> Array:
    """Smooth values at the middles of cells half as large."""
    for _ in range(2):  # along one axis, then along the other
        ends = 2 * values[[0, -1]] - values[[1, -2]]
        wide = np.concatenate([ends[:1], values, ends[1:]])
        finer = np.empty((2 * len(values), values.shape[1]))
        finer[::2] = 0.75 * wide[1:-1] + 0.25 * wide[:-2]
        finer[1::2] = 0.75 * wide[1:-1] + 0.25 * wide[2:]
        values = finer.T
    return np.ascontiguousarray(values)


def c_transform(potential: Array, weight_0: float, weight_1: float) -> Array:
    """The c-transform φᶜ of φ (m_0, m_1) for weights of the squared distances along both axes."""
    rows = np.ascontiguousarray(-potential)  # other layouts would be compiled anew
    return _lowest_along_rows(_lowest_along_rows(rows, weight_1), weight_0)


def _lowest_along_rows(values: Array, weight: float) -> Array:
    """min_j ½ w (k − j)² + values[a, j], transposed: shape (m_1, m_0)."""
    lowest = np.empty(values.shape[::-1])

    def work(begin: int, end: int) -> None:
        _envelopes(values, weight, begin, end, lowest)

    threads.run_lines(work, len(values), values.size)
    return lowest


@jit()
def _envelopes(values, weight, begin, end, lowest):  # type: ignore[no-untyped-def]
    """The rows from number ``begin`` to ``end``; see `_lowest_along_rows`."""
    count = values.shape[1]
    vertex, border = np.empty(count, np.int64), np.empty(count + 1)
    per_distance, envelopes = np.zeros(count), np.empty((_BLOCK, count))
    for distance in range(1, count):
        per_distance[distance] = 1 / (weight * distance)
    for first in range(begin, end, _BLOCK):
        last = min(first + _BLOCK, end)
        for a in range(first, last):
            _envelope(values[a], weight, per_distance, vertex, border, envelopes[a - first])
        for k in range(count):  # columns of the result lie side by side in a cache
            for a in range(first, last):
                lowest[k, a] = envelopes[a - first, k]


@jit()
def _envelope(values, weight, per_distance, vertex, border, envelope) -> Any:  # type: ignore[no-untyped-def]
    """min_j ½ w (k − j)² + values[j] for each k.

    ``vertex`` lists the parabolas of the envelope from left to right, and ``border`` where each
    of them begins to be the lowest.
    """
    count = len(values)
    top, i, begins = 0, 0, -np.inf  # the last parabola of the envelope
    vertex[0], border[0] = i, begins
    for j in range(1, count):
        crossing = 0.5 * (i + j) + (values[j] - values[i]) * per_distance[j - i]
        while crossing <= begins:
            top -= 1
            i, begins = vertex[top], border[top]
            crossing = 0.5 * (i + j) + (values[j] - values[i]) * per_distance[j - i]
        top, i, begins = top + 1, j, crossing
        vertex[top], border[top] = i, begins
    border[top + 1] = np.inf
    lowest = 0
    for k in range(count):
        while border[lowest + 1] < k:
            lowest += 1
        j = vertex[lowest]
        here = 0.5 * weight * (k - j) ** 2 + values[j]
        envelope[k] = here
        if 0 < j < count - 1:
            before = 0.5 * weight * (k - j + 1) ** 2 + values[j - 1]
            after = 0.5 * weight * (k - j - 1) ** 2 + values[j + 1]
            bend = before - 2 * here + after
            if bend > 0.0:
                envelope[k] = here - min((after - before) ** 2 / (8 * bend), weight)


def mapped(potential: Array, weight_0: float, weight_1: float) -> tuple[Array, Array]:
    """Where the map y = x − ∇φ(x) / w brings the places of a grid with spacing 1.

    Coordinates (m_0, m_1) along the two axes, within the cells of the grid.
    """
    to_0, to_1 = np.empty_like(potential), np.empty_like(potential)

    def work(begin: int, end: int) -> None:
        _mapped(potential, weight_0, weight_1, begin, end, to_0, to_1)

    threads.run_lines(work, len(potential), potential.size)
    return to_0, to_1


@jit(allocates=False)
def _mapped(potential, weight_0, weight_1, begin, end, to_0, to_1):  # type: ignore[no-untyped-def]
    """The lines from number ``begin`` to ``end``; see `mapped`."""
    m_0, m_1 = potential.shape
    for a in range(begin, end):
        below, above = max(a - 1, 0), min(a + 1, m_0 - 1)
        for b in range(m_1):
            left, right = max(b - 1, 0), min(b + 1, m_1 - 1)
            rise_0 = (potential[above, b] - potential[below, b]) / (above - below)
            rise_1 = (potential[a, right] - potential[a, left]) / (right - left)
            to_0[a, b] = min(max(a - rise_0 / weight_0, -0.5), m_0 - 0.5)
            to_1[a, b] = min(max(b - rise_1 / weight_1, -0.5), m_1 - 0.5)


def push(mass: Array, to_0: Array, to_1: Array, fewest: int = 1) -> Array:
    """Mass (m_0, m_1) after each cell went where the map brings it; see `mapped`.

    A cell is cut where the map stretches it, so that it leaves no holes, and into ``fewest`` parts
    along an axis at least; each part is spread over the four nearest places. Uncut cells 0.9 apart
    make waves of 2 % in an even light.
    """
    bounds = threads.split(len(mass), mass.size)
    parts = np.zeros((len(bounds) - 1, *mass.shape))
    lines = [(0, 0)] * len(parts)  # of each part that have light

    def work(part: int) -> None:
        begin, end = bounds[part], bounds[part + 1]
        lines[part] = _push(mass, to_0, to_1, fewest, begin, end, parts[part])

    threads.run(work, len(parts))
    pushed = np.zeros_like(mass)
    for part, (first, last) in zip(parts, lines, strict=True):
        pushed[first:last] += part[first:last]
    return pushed


@jit()
def _push(mass, to_0, to_1, fewest, begin, end, pushed):  # type: ignore[no-untyped-def]
    """Add the mass of the cells from line ``begin`` to ``end``; see `push`.

    Returns the first line that has got some, and the one behind the last.
    """
    m_0, m_1 = mass.shape
    first, last = m_0, 0
    for a in range(begin, end):
        below, above = max(a - 1, 0), min(a + 1, m_0 - 1)
        for b in range(m_1):
            if mass[a, b] == 0.0:
                continue
            left, right = max(b - 1, 0), min(b + 1, m_1 - 1)
            stretch_00 = (to_0[above, b] - to_0[below, b]) / (above - below)
            stretch_10 = (to_1[above, b] - to_1[below, b]) / (above - below)
            stretch_01 = (to_0[a, right] - to_0[a, left]) / (right - left)
            stretch_11 = (to_1[a, right] - to_1[a, left]) / (right - left)
            parts_0 = max(_parts(max(abs(stretch_00), abs(stretch_10))), fewest)
            parts_1 = max(_parts(max(abs(stretch_01), abs(stretch_11))), fewest)
            share = mass[a, b] / (parts_0 * parts_1)
            for i in range(parts_0):
                s = (i + 0.5) / parts_0 - 0.5
                for j in range(parts_1):
                    t = (j + 0.5) / parts_1 - 0.5
                    place_0 = to_0[a, b] + stretch_00 * s + stretch_01 * t
                    place_1 = to_1[a, b] + stretch_10 * s + stretch_11 * t
                    place_0 = min(max(place_0, 0.0), m_0 - 1.0)
                    place_1 = min(max(place_1, 0.0), m_1 - 1.0)
                    near_0, near_1 = min(int(place_0), m_0 - 2), min(int(place_1), m_1 - 2)
                    first, last = min(first, near_0), max(last, near_0 + 2)
                    f, g = place_0 - near_0, place_1 - near_1
                    pushed[near_0, near_1] += share * (1 - f) * (1 - g)
                    pushed[near_0 + 1, near_1] += share * f * (1 - g)
                    pushed[near_0, near_1 + 1] += share * (1 - f) * g
                    pushed[near_0 + 1, near_1 + 1] += share * f * g
    return min(first, last), last


@jit()
def _parts(stretch):  # type: ignore[no-untyped-def]
    return int(min(max(math.ceil(stretch), 1), _MOST_PARTS))
