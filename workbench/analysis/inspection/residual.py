"""Residual of a measured face: what is resolved above the noise, as a B-spline, and its figures.

The residual is fitted by nets from coarse to fine. Each half of the measurement predicts the other
half; the coarsest net whose prediction is as good as the best one is taken. So noise is left out,
which would otherwise scatter light as slopes do that no part has.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array, diags_array, kron
from scipy.sparse.linalg import splu

from workbench.analysis.inspection.placement import DesignedFace, Placement
from workbench.arrays import Array, Index
from workbench.errors import Refused
from workbench.geometry.approximation import project
from workbench.geometry.basis import local_basis
from workbench.geometry.surface import ControlNet, even_counts
from workbench.messages import Message

_DEGREE = (3, 3)
_CELLS = 512  # along the longer side; the points of a cell are averaged
_MAP = 256  # cells of the map for pictures along the longer side
_COVER = 32  # cells along the longer side for the covered part of the face
_LEAST_COVERED = 0.5
_SPANS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128)
_PATIENCE = 3  # nets without a better prediction before the search ends
_STIFFNESS = 1e-9  # of second differences, which closes holes
_SPIKE = 12 * 1.4826  # deviations from the median of the neighbourhood that are dust


@dataclass(frozen=True, eq=False)
class Residual:
    """Residual of a part: measured less designed height, in scene units."""

    face: DesignedFace
    points: Array  # (n, 3), x, y and residual along z, within the outline and without spikes
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
        there = np.bincount(self._cells(self.points, counts), minlength=counts[0] * counts[1]) > 0
        face = np.bincount(self._cells(self.face.samples, counts), minlength=len(there)) > 0
        return float((there & face).sum() / face.sum())

    def map(self) -> tuple[Array, Array]:
        """Residual of the points and resolved residual, (n_y, n_x); NaN where there is none."""
        counts = even_counts(self.net.half_width, _MAP)
        cells = self._cells(self.points, counts)
        number = np.bincount(cells, minlength=counts[0] * counts[1])
        total = np.bincount(cells, self.points[:, 2], minlength=len(number))
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


def residual_of(
    points: Array, placement: Placement, face: DesignedFace, file: str, needed: bool = True
) -> Residual:
    """Return the residual of measured points (n, 3) of a face.

    Raise Refused, with ``file``, if they cover too little of the face.
    """
    there = placement.applied(points)
    found = face.offsets(there)
    offset = np.column_stack([there[found.inside, :2], found.height])
    kept = ~_spikes(offset, face.net.half_width)
    offset, distance = offset[kept], found.distance[kept]
    places, weights, halves = _averaged(offset, face.net.half_width)
    net, noise = _best_net(places, weights, halves, face.net.half_width)
    control = _fitted(net, places, weights)
    result = Residual(face, offset, distance, int((~kept).sum()), net, control, noise)
    if needed and result.covered < _LEAST_COVERED:
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


def cells_of(points: Array, half_width: tuple[float, float], counts: tuple[int, int]) -> Index:
    """Number (n,) of the cell of each point, of a raster over the face."""
    i, j = (
        ((points[:, axis] / r + 1) / 2 * count).astype(np.intp).clip(0, count - 1)
        for axis, (r, count) in enumerate(zip(half_width, counts, strict=True))
    )
    return i * counts[1] + j


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


def _averaged(points: Array, half_width: tuple[float, float]) -> tuple[Array, Array, Index]:
    """Mean points of small cells, their numbers of points, and the half to which each belongs."""
    counts = even_counts(half_width, _CELLS)
    cells = cells_of(points, half_width, counts)
    number = np.bincount(cells, minlength=counts[0] * counts[1])
    there = np.flatnonzero(number)
    sums = [np.bincount(cells, column, minlength=len(number))[there] for column in points.T]
    means = np.stack(sums, axis=1) / number[there, None]
    halves = np.random.default_rng(2).integers(0, 2, len(there))
    return means, number[there].astype(np.float64), halves


def _best_net(
    places: Array, weights: Array, halves: Index, half_width: tuple[float, float]
) -> tuple[ControlNet, float]:
    found: list[tuple[float, ControlNet]] = []
    for longer in _SPANS:
        spans = [max(round(longer * r / max(half_width)), 1) for r in half_width]
        net = ControlNet((spans[0] + 3, spans[1] + 3), _DEGREE, half_width)
        if 8 * net.shape[0] * net.shape[1] > len(places) and found:
            break
        found.append((_prediction_error(net, places, weights, halves), net))
        errors = [error for error, _ in found]
        if len(errors) - np.argmin(errors) > _PATIENCE:
            break
    least = min(error for error, _ in found)
    # Scatter of an estimated variance of so many values.
    enough = least * (1 + 2 * (2 / len(places)) ** 0.5)
    error, net = next(each for each in found if each[0] <= enough)
    return net, float(np.sqrt(error))


def _prediction_error(net: ControlNet, places: Array, weights: Array, halves: Index) -> float:
    """Mean square of what a fit of one half leaves of the other half, for one point."""
    total = 0.0
    for half in (0, 1):
        own = halves == half
        control = _fitted(net, places[own], weights[own])
        x, y, z = places[~own].T
        total += float((weights[~own] * (z - net.at(x, y, control)[0]) ** 2).sum())
    return total / len(places)


def _fitted(net: ControlNet, places: Array, weights: Array) -> Array:
    """Control heights (n_u, n_v) of the least squares fit to points (n, 3)."""
    basis = _basis(net, places)
    weighted = basis.T.multiply(weights).tocsr()
    stiffness = _bending(net.shape) * (_STIFFNESS * float(weights.sum()))
    normal = (weighted @ basis + stiffness).tocsc()
    solver = splu(normal, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
    return np.asarray(solver.solve(weighted @ places[:, 2]).reshape(net.shape))


def _basis(net: ControlNet, places: Array) -> csr_array:
    parts = [
        local_basis(knots, degree, ((place / r + 1) / 2).clip(0, 1))
        for knots, degree, r, place in zip(
            net.knots, net.degree, net.half_width, places.T[:2], strict=True
        )
    ]
    (first_x, along_x), (first_y, along_y) = parts
    index_x, index_y = (first[:, None] + np.arange(4) for first in (first_x, first_y))
    columns = index_x[:, :, None] * net.shape[1] + index_y[:, None, :]
    values = along_x[:, :, None] * along_y[:, None, :]
    begins = np.arange(0, values.size + 1, 16)
    shape = (len(places), net.shape[0] * net.shape[1])
    return csr_array((values.ravel(), columns.ravel(), begins), shape=shape)


def _bending(shape: tuple[int, int]) -> csr_array:
    """Sum of the squares of second differences along u and v, and of mixed ones, as a matrix."""
    eyes = [csr_array(diags_array(np.ones(n))) for n in shape]
    ones, twos = ([np.diff(np.eye(n), k, axis=0) for n in shape] for k in (1, 2))
    bent = [
        kron(csr_array(twos[0]), eyes[1]),
        kron(eyes[0], csr_array(twos[1])),
        kron(csr_array(ones[0]), csr_array(ones[1])),
    ]
    return sum((csr_array(each).T @ csr_array(each) for each in bent[1:]), bent[0].T @ bent[0])
