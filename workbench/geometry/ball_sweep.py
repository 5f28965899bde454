"""What balls on a grid leave of the stock that they sweep through."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.ball_kernels import LEAF_ROWS, LEAF_SPANS, Blocks, lowest_sides


@dataclass(frozen=True, eq=False)
class BallSweep:
    """Balls of one radius whose centres go along straight lines, in rows along x.

    Attributes
    ----------
    x, y : ndarray, shapes (m_x,) and (m_y,)
        Where centres are, scene units; at least two along each axis, in steps that are equal but
        for rounding.
    centre : ndarray, shape (m_x, m_y)
        Heights of the centres there; in between they go straight along x.
    radius : float
        Of all balls.
    """

    x: Array
    y: Array
    centre: Array
    radius: float

    def lowest(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Lowest side of all balls above places: every ball that can be it is compared.

        Parameters
        ----------
        x, y : ndarray, shape (m,)
            Places, scene units.

        Returns
        -------
        height : ndarray, shape (m,)
            Infinite where no ball is above.
        normal : ndarray, shape (m, 3)
            Unit vectors to the centres of these balls; 0 where there is none.
        """
        height, normal = np.empty(len(x)), np.empty((len(x), 3))
        x, y = (np.ascontiguousarray(each, dtype=np.float64) for each in (x, y))
        grid = float(self.x[0]), self._steps[0], float(self.y[0]), self._steps[1]
        centre, blocks = self._rows, self._blocks
        lowest_sides(centre, blocks, grid, float(self.radius), x, y, height, normal)
        return height, normal

    @property
    def _steps(self) -> tuple[float, float]:
        """From one centre to the next along x and y: means, as places may be rounded."""
        step_x, step_y = (float(at[-1] - at[0]) / (len(at) - 1) for at in (self.x, self.y))
        return step_x, step_y

    @cached_property
    def _rows(self) -> Array:
        """The centres, (m_y, m_x)."""
        return np.ascontiguousarray(self.centre.T)

    @cached_property
    def _blocks(self) -> Blocks:
        pieces = _pieces(self._rows, *self._steps)
        levels = [_joined(pieces, LEAF_ROWS, LEAF_SPANS)]
        while levels[-1].lowest.size > 1:
            levels.append(_joined(levels[-1], 2, 2))
        lowest, slope_x, slope_y, base = (
            np.concatenate([np.ravel(each[field]) for each in levels]) for field in range(4)
        )
        sizes = [level.lowest.size for level in levels]
        return Blocks(
            lowest,
            slope_x,
            slope_y,
            base - self.radius * np.sqrt(1 + slope_x**2 + slope_y**2),
            np.cumsum([0, *sizes[:-1]]),
            np.array([level.lowest.shape[0] for level in levels]),
            np.array([level.lowest.shape[1] for level in levels]),
        )


class _Level(NamedTuple):
    """Blocks of one size: bounds of the centres in each.

    Attributes
    ----------
    lowest, slope_x, slope_y, base : ndarray, shape (rows, columns)
        Lowest centre, and the plane base + slope_x x + slope_y y below them, with x and y from the
        grid's first point.
    width, height : float
        Sizes of a block from its first to its last point.
    step_x, step_y : float
        From one block to the next.
    """

    lowest: Array
    slope_x: Array
    slope_y: Array
    base: Array
    width: float
    height: float
    step_x: float
    step_y: float


def _pieces(rows: Array, step_x: float, step_y: float) -> _Level:
    """The straight pieces of all rows, each of which is a block."""
    middle = (rows[:, 1:] + rows[:, :-1]) / 2
    slope_x, slope_y = np.diff(rows, axis=1) / step_x, np.gradient(middle, step_y, axis=0)
    m_y, m_x = middle.shape
    x, y = (np.arange(m_x) + 0.5) * step_x, np.arange(m_y)[:, None] * step_y
    lowest = np.minimum(rows[:, 1:], rows[:, :-1])
    return _Level(
        lowest, slope_x, slope_y, middle - slope_x * x - slope_y * y, step_x, 0.0, step_x, step_y
    )


def _joined(level: _Level, rows: int, columns: int) -> _Level:
    """Blocks of so many blocks; the last ones may hold fewer."""
    lowest = _grouped(level.lowest, rows, columns, np.inf)
    count = np.isfinite(lowest).sum(axis=(1, 3), keepdims=True)
    base, means = _grouped(level.base, rows, columns, np.inf), []
    across = np.arange(lowest.shape[2] * columns).reshape(-1, columns) * level.step_x
    up = np.arange(lowest.shape[0] * rows).reshape(-1, rows)[:, :, None, None] * level.step_y
    for slope, first, size in (
        (level.slope_x, across, level.width),
        (level.slope_y, up, level.height),
    ):
        slopes = _grouped(slope, rows, columns, 0.0)
        mean = slopes.sum(axis=(1, 3), keepdims=True) / count
        # How far a plane of that slope is above one of the mean slope, at the lower end.
        base = base + np.minimum((slopes - mean) * first, (slopes - mean) * (first + size))
        means.append(mean[:, 0, :, 0])
    return _Level(
        lowest.min(axis=(1, 3)),
        means[0],
        means[1],
        base.min(axis=(1, 3)),
        level.width + (columns - 1) * level.step_x,
        level.height + (rows - 1) * level.step_y,
        columns * level.step_x,
        rows * level.step_y,
    )


def _grouped(values: Array, rows: int, columns: int, missing: float) -> Array:
    """Values in groups, shape (groups, rows, groups, columns)."""
    more = [(0, -n % k) for n, k in zip(values.shape, (rows, columns), strict=True)]
    whole = np.pad(values, more, constant_values=missing)
    return whole.reshape(whole.shape[0] // rows, rows, whole.shape[1] // columns, columns)
