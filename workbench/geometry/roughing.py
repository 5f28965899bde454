"""Roughing of a face by lines at levels of z, with a flat or a ball cutter.

Heights of the cutter are bounds: the face between the samples of a grid is at most its largest
slope times the distance above them. So the cutter keeps the allowance at each of its points, and
on the straight moves between the points.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.ndimage import grey_dilation

from workbench.arrays import Array
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.curvature import derivative_range

_FINE = 12  # samples along the cutter's radius
_LINES = 6  # samples between lines: half of the radius
_PARTS = 4  # of the moves between two points, where the remaining material is computed


@dataclass(frozen=True)
class Cutter:
    """A cutter with a ball or a flat end; its radius in scene units."""

    radius: float
    ball: bool

    def side(self, distance: Array) -> Array:
        """Height of its surface above its tip at distances from its axis, up to the radius."""
        if not self.ball:
            return np.zeros_like(distance)
        return np.asarray(self.radius - np.sqrt((self.radius**2 - distance**2).clip(0)))


class Roughing(NamedTuple):
    """Lowest tips (m_x, m_y) of a cutter on a grid of x (m_x,) and lines y (m_y,), scene units."""

    cutter: Cutter
    x: Array
    y: Array
    tip: Array

    def lines(self, top: float, step_down: float) -> Iterator[Array]:
        """Cuts (n, 3) from the top of the stock down, level by level, as points x, y, z.

        A cut has at least two points. Where the level before has reached the lowest tip, there is
        none.
        """
        above, lowest = top, float(self.tip.min())
        while above > lowest:
            level = max(above - step_down, lowest)
            for number, y in enumerate(self.y):
                tip = self.tip[:, number]
                for run in _runs(tip < above):
                    x, z = self.x[run], np.maximum(tip[run], level)
                    kept = _bends(z)
                    yield np.column_stack([x[kept], np.full(kept.sum(), y), z[kept]])
            above = level

    def left(self, x: Array, y: Array, z: Array) -> tuple[float, float]:
        """Return the least and the most material above points (m,) of a face, along z."""
        lowest = np.full(len(x), np.inf)
        step = (self.x[-1] - self.x[0]) / (len(self.x) - 1) / _PARTS
        along = np.linspace(self.x[0], self.x[-1], _PARTS * (len(self.x) - 1) + 1)
        middle = np.round((x - along[0]) / step).astype(int)
        most = math.ceil(self.cutter.radius / step)
        for number, line in enumerate(self.y):
            tip = np.interp(along, self.x, self.tip[:, number])
            close = np.flatnonzero(abs(y - line) <= self.cutter.radius)
            for offset in range(-most, most + 1):
                at = (middle[close] + offset).clip(0, len(along) - 1)
                distance = np.hypot(along[at] - x[close], line - y[close])
                side = tip[at] + self.cutter.side(distance)
                side[distance > self.cutter.radius] = np.inf
                lowest[close] = np.minimum(lowest[close], side)
        above = lowest - z
        return float(above.min()), float(above.max())


def plan_roughing(
    face: CutFace, cutter: Cutter, allowance: float, reach: tuple[float, float], step: float
) -> Roughing:
    """Find the lowest tips that leave the allowance everywhere on the face.

    ``reach``: how far the axis of the cutter goes along x and y; x and y are multiples of ``step``.
    """
    apart = 2 * step * max(math.floor(cutter.radius / _FINE / (2 * step)), 1)
    beyond = cutter.radius + allowance + apart
    margin = math.ceil(beyond / apart)
    counts = [math.ceil(end / apart) for end in reach]
    x, y = (np.asarray(apart * np.arange(-n - margin, n + margin + 1)) for n in counts)
    offsets = apart * np.arange(-margin, margin + 1)
    distance = np.hypot(offsets[:, None], offsets)
    # A point of the face is at most this far from a sample, and the allowance is kept sideways too.
    aside = apart / math.sqrt(2)
    near = (distance - allowance - aside).clip(0)
    inside = near <= cutter.radius
    side = np.where(inside, cutter.side(near.clip(0, cutter.radius)), 0)
    slope = _steepest(face)
    tip = grey_dilation(face.extended(x, y), footprint=inside, structure=-side, mode="nearest")
    tip = tip + allowance + slope * (aside + apart / 2)
    inner = slice(margin, -margin)
    lines = np.unique([*range(0, 2 * counts[1] + 1, _LINES), 2 * counts[1]])
    return Roughing(cutter, x[inner], y[inner][lines], tip[inner, inner][:, lines])


def _steepest(face: CutFace) -> float:
    ends = (derivative_range(face.net, face.heights, order) for order in ((1, 0), (0, 1)))
    return math.hypot(*(max(-float(low.min()), float(high.max())) for low, high in ends))


def _runs(cut: npt.NDArray[np.bool_]) -> Iterator[slice]:
    """Runs of at least two neighbouring points, each with the point before and behind it."""
    changes = np.flatnonzero(np.diff(np.concatenate([[False], cut, [False]])))
    for first, last in changes.reshape(-1, 2).tolist():
        yield slice(max(first - 1, 0), min(last + 1, len(cut)))


def _bends(z: Array) -> Array:
    """Which points are not in the middle of a level stretch."""
    kept = np.ones(len(z), dtype=bool)
    kept[1:-1] = (z[1:-1] != z[:-2]) | (z[1:-1] != z[2:])
    return kept
