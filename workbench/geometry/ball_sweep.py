"""Material that balls on a grid leave of the stock."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.ball_kernels import LEAF_ROWS, LEAF_SPANS, Blocks, lowest_sides
from workbench.progress import check_given_up


@dataclass(frozen=True, eq=False)
class BallSweep:
    """Balls of one radius whose centres move along straight lines, in rows along x."""

    # Positions of centres, scene units; at least two along each axis, in equal steps up to
    # rounding.
    x: Array
    y: Array
    centre: Array  # (m_x, m_y), heights of the centres; linear along x in between
    radius: float  # radius of all balls

    def lowest(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return height (m,) and normal (m, 3) of the lowest ball surface above points (m,).

        The height is infinite and the normal, which points to the ball's centre, 0 where no ball is
        above.
        """
        height, normal = np.empty(len(x)), np.empty((len(x), 3))
        x, y = (np.ascontiguousarray(each, dtype=np.float64) for each in (x, y))
        grid = float(self.x[0]), self._steps[0], float(self.y[0]), self._steps[1]
        centre, blocks = self._rows, self._blocks
        lowest_sides(centre, blocks, grid, float(self.radius), x, y, height, normal)
        return height, normal

    @property
    def _steps(self) -> tuple[float, float]:
        step_x, step_y = (float(at[-1] - at[0]) / (len(at) - 1) for at in (self.x, self.y))
        return step_x, step_y

    @cached_property
    def _rows(self) -> Array:
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
    lowest: Array
    slope_x: Array
    slope_y: Array
    base: Array
    width: float
    height: float
    step_x: float
    step_y: float


def _pieces(rows: Array, step_x: float, step_y: float) -> _Level:
    middle = (rows[:, 1:] + rows[:, :-1]) / 2
    slope_x, slope_y = np.diff(rows, axis=1) / step_x, np.gradient(middle, step_y, axis=0)
    m_y, m_x = middle.shape
    x, y = (np.arange(m_x) + 0.5) * step_x, np.arange(m_y)[:, None] * step_y
    lowest = np.minimum(rows[:, 1:], rows[:, :-1])
    return _Level(
        lowest, slope_x, slope_y, middle - slope_x * x - slope_y * y, step_x, 0.0, step_x, step_y
    )


def _joined(level: _Level, rows: int, columns: int) -> _Level:
    lowest = _grouped(level.lowest, rows, columns, np.inf)
    count = np.isfinite(lowest).sum(axis=(1, 3), keepdims=True)
    base, means = _grouped(level.base, rows, columns, np.inf), []
    across = np.arange(lowest.shape[2] * columns).reshape(-1, columns) * level.step_x
    up = np.arange(lowest.shape[0] * rows).reshape(-1, rows)[:, :, None, None] * level.step_y
    for slope, first, size in (
        (level.slope_x, across, level.width),
        (level.slope_y, up, level.height),
    ):
        check_given_up()  # large sweeps take seconds
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
    more = [(0, -n % k) for n, k in zip(values.shape, (rows, columns), strict=True)]
    whole = np.pad(values, more, constant_values=missing)
    return whole.reshape(whole.shape[0] // rows, rows, whole.shape[1] // columns, columns)
