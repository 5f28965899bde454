"""Residual of a measured face: what is resolved above the noise, as a B-spline, and its figures.

The residual is fitted by nets from coarse to fine. Each half of the measurement predicts the other
half; the coarsest net whose prediction is as good as the best one is taken. So noise is left out,
which would otherwise scatter light as slopes do that no part has.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from workbench.analysis.inspection.fit import Cells, Fit, cells_of
from workbench.analysis.inspection.placement import DesignedFace, Placement
from workbench.arrays import Array, Index
from workbench.errors import Refused
from workbench.geometry.approximation import project
from workbench.geometry.surface import ControlNet, even_counts
from workbench.messages import Message

_DEGREE = (3, 3)
_MAP = 256  # cells of the map for pictures along the longer side
_COVER = 32  # cells along the longer side for the covered part of the face
_LEAST_COVERED = 0.5
_SPANS = (1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 64, 80, 96)
_LEAST_CELLS = 8  # for each control point
_PATIENCE = 2  # nets without a better prediction before the search ends
_SPIKE = 12 * 1.4826  # deviations from the median of the neighbourhood that are dust


@dataclass(frozen=True, eq=False)
class Residual:
    """Residual of a part: measured less designed height, in scene units."""

    face: DesignedFace
    offsets: Array  # (n, 3), x, y and residual along z, within the outline and without spikes
    distance: Array  # (n,), residual along the normal
    spikes: int  # points that were left out as dust
    net: ControlNet  # the net that resolves what is above the noise
    control: Array  # its control heights
    noise: float  # RMS of what it leaves

    @cached_property
    def on_design(self) -> Array:
        """The resolved residual as control heights (n_u, n_v) of the designed net."""
        return project(self.net, self.control, self.face.net)

    @property
    def rms(self) -> float:
        """RMS of the residual along the normal."""
        return float(np.sqrt(np.mean(self.distance**2)))

    @property
    def peak_to_valley(self) -> float:
        """Largest less least residual along the normal."""
        return float(np.ptp(self.distance))

    @cached_property
    def _resolved(self) -> tuple[Array, Array, Array]:
        x, y, _ = self.face.samples.T
        return self.net.at(x, y, self.control)

    @property
    def resolved_rms(self) -> float:
        """RMS of the resolved residual."""
        return float(np.sqrt(np.mean(self._resolved[0] ** 2)))

    @property
    def slope_rms(self) -> float:
        """RMS of the slope of the resolved residual, radians."""
        _, slope_x, slope_y = self._resolved
        return float(np.sqrt(np.mean(slope_x**2 + slope_y**2)))

    @property
    def covered(self) -> float:
        """Part of the face that has points."""
        counts = even_counts(self.net.half_width, _COVER)
        there = np.bincount(self._cells(self.offsets, counts), minlength=counts[0] * counts[1]) > 0
        face = np.bincount(self._cells(self.face.samples, counts), minlength=len(there)) > 0
        return float((there & face).sum() / face.sum())

    def map(self) -> tuple[Array, Array]:
        """Residual of the points and resolved residual, (n_y, n_x); NaN where there is none."""
        counts = even_counts(self.net.half_width, _MAP)
        cells = self._cells(self.offsets, counts)
        number = np.bincount(cells, minlength=counts[0] * counts[1])
        total = np.bincount(cells, self.offsets[:, 2], minlength=len(number))
        with np.errstate(invalid="ignore"):
            mean = (total / number).reshape(counts)
        u, v = ((np.arange(count) + 0.5) / count for count in counts)
        r_x, r_y = self.net.half_width
        outside = ~self.face.outline.contains((2 * u[:, None] - 1) * r_x, (2 * v - 1) * r_y)
        smooth = self.net.grid(u, v).evaluate(self.control)[0]
        smooth[outside] = np.nan
        return mean[:, ::-1].T, smooth[:, ::-1].T

    def _cells(self, points: Array, counts: tuple[int, int]) -> Index:
        return cells_of(points, self.net.half_width, counts)


class OnFace(NamedTuple):
    """Measured points of a face, without spikes."""

    offsets: Array  # (n, 3), x, y and height above the designed face
    distance: Array  # (n,), along its normal
    spikes: int


def points_on(face: DesignedFace, placement: Placement, points: Array) -> OnFace:
    """Return the points (n, 3) of a measurement that are within the outline of a face."""
    there = placement.applied(points)
    found = face.offsets(there)
    offsets = np.column_stack([there[found.inside, :2], found.height])
    kept = ~_spikes(offsets, face.net.half_width)
    return OnFace(offsets[kept], found.distance[kept], int((~kept).sum()))


def residual_of(
    face: DesignedFace,
    placement: Placement,
    points: Array,
    file: str,
    finest: ControlNet | None = None,
) -> Residual:
    """Return the residual of measured points (n, 3) of a face, by a net up to ``finest``.

    Raise Refused, with ``file``, if they cover too little of the face.
    """
    found = points_on(face, placement, points)
    cells = Cells.of(found.offsets, face.net.half_width)
    net, noise = _best_net(cells, face.net.half_width, _spans_up_to(finest))
    control = Fit(net, cells).control(cells.points[:, 2])
    result = Residual(face, *found, net, control, noise)
    if result.covered < _LEAST_COVERED:
        raise Refused(
            file,
            Message(
                "it covers {covered:.0f} % of {face}; at least {least:.0f} % are needed",
                covered=100 * result.covered,
                face=face.name,
                least=100 * _LEAST_COVERED,
            ),
        )
    return result


def _spikes(points: Array, half_width: tuple[float, float]) -> np.typing.NDArray[np.bool_]:
    """Mask of points far off the median of their cell of some thirty points."""
    counts = even_counts(half_width, max(round((len(points) / 30) ** 0.5), 2))
    cells = cells_of(points, half_width, counts)
    order = np.lexsort((points[:, 2], cells))
    number = np.bincount(cells, minlength=counts[0] * counts[1])
    middle = np.cumsum(number) - number + number // 2
    medians = points[order[middle.clip(0, len(order) - 1)], 2]
    off = np.abs(points[:, 2] - medians[cells])
    return np.asarray(off > _SPIKE * np.median(off))


def _spans_up_to(net: ControlNet | None) -> tuple[int, ...]:
    if net is None:
        return _SPANS
    own = _SPANS.index(max(n - p for n, p in zip(net.shape, net.degree, strict=True)))
    return _SPANS[: own + 1]


def _best_net(
    cells: Cells, half_width: tuple[float, float], choice: tuple[int, ...]
) -> tuple[ControlNet, float]:
    """The coarsest net whose fit of each half predicts the other half as well as any; the noise.

    As well is: within one standard error of the difference, cell by cell.
    """
    half = np.random.default_rng(2).integers(0, 2, len(cells.points)).astype(np.float64)
    nets: list[ControlNet] = []
    squares: list[Array] = []
    for longer in choice:
        spans = [max(round(longer * r / max(half_width)), 1) for r in half_width]
        net = ControlNet((spans[0] + _DEGREE[0], spans[1] + _DEGREE[1]), _DEGREE, half_width)
        if _LEAST_CELLS * net.shape[0] * net.shape[1] > len(cells.points) and nets:
            break
        nets.append(net)
        squares.append(_prediction_errors(Fit(net, cells), cells, half))
        if len(nets) - np.argmin([each.mean() for each in squares]) > _PATIENCE:
            break
    best = min(squares, key=np.mean)
    net, error = next(
        (net, each)
        for net, each in zip(nets, squares, strict=True)
        if (each - best).mean() <= (each - best).std() / len(best) ** 0.5
    )
    return net, float(np.sqrt(error.mean()))


def _prediction_errors(fit: Fit, cells: Cells, half: Array) -> Array:
    """Squares (m,) of what a fit of the other half leaves of each cell, for one point."""
    heights = cells.points[:, 2:]
    others = [fit.basis @ fit.solved(heights, own * cells.weights) for own in (1 - half, half)]
    predicted = np.where(half[:, None] > 0, *others)
    return np.asarray(cells.weights * (heights - predicted)[:, 0] ** 2)
