"""B-spline faces for kernels: the table of their patches, with its adjoint, and their bounds."""

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import torch

from workbench.arrays import AnyArray, Array
from workbench.compiled import jit
from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels import kind_of, threads
from workbench.optics.kernels.intersection import FALLS_BY
from workbench.optics.kernels.patches import make_net
from workbench.optics.kernels.taps import FAST


class Bounds(NamedTuple):
    """What the convex-hull property says of a face; numbers in the trace's float type.

    `slope_x`, `slope_y`, `bend_xx`, `bend_xy`, `bend_yy`: the most that the derivatives can be
    anywhere.
    """

    # Depths between which all roots are, wider than the hull by more than the rounding of f.
    low: np.floating[Any]
    high: np.floating[Any]
    lowest: np.floating[Any]  # height of the lowest control point
    tolerance: np.floating[Any]  # A step as small as this is rounding
    slope_x: np.floating[Any]
    slope_y: np.floating[Any]
    curvature_xx: np.floating[Any]
    curvature_xy: np.floating[Any]
    curvature_yy: np.floating[Any]


class Face:
    """Faces of one control net.

    `net`: the control net; `dtype`: float type of the trace.
    """

    def __init__(self, net: ControlNet, dtype: torch.dtype) -> None:
        kind = kind_of(dtype)
        self.net = make_net(net, kind)
        self._patches = Patches(net, dtype)
        self._distances = [np.diff(part).astype(kind) for part in net.positions]
        along_x, along_y = (part.permute(1, 2, 0) for part in self._patches.to_powers)
        self.powers = along_x.contiguous().numpy(), along_y.contiguous().numpy()

    def bounds(self, heights: AnyArray, steepest: AnyArray, size: float = 0.0) -> Bounds:
        """Bounds of a face.

        `heights` (n_u, n_v): control heights above the level from which the depths of rays count;
        `steepest` (2,): the most that the slopes of the rays are along x and y; `size`: A length
        whose rounding counts, too, where heights alone are smaller.
        """
        kind = heights.dtype.type
        lowest, highest, *slopes = _hull(heights, *self._distances)
        tolerance = 4 * np.finfo(kind).eps * max(abs(lowest), abs(highest), size)
        curvatures = math.inf, math.inf, math.inf
        if np.dot(slopes, steepest) >= 1 - FALLS_BY:  # some rays walk
            curvatures = self._patches.curvature_bounds(torch.from_numpy(heights))
        ends = lowest - 8 * tolerance, highest + 8 * tolerance
        numbers = *ends, lowest, tolerance, *slopes, *curvatures
        return Bounds(*(kind(number) for number in numbers))


def make_table(heights: AnyArray, powers: tuple[AnyArray, AnyArray]) -> AnyArray:
    """Coefficients of s^a t^b of every patch, shape (patches, p + 1, q + 1).

    `heights` (n_u, n_v): control heights; `powers` (p + 1, p + 1, spans): power coefficients along
    each axis, by basis function, power and span; see `Patches`.
    """
    (p, _, across), (q, _, up) = (part.shape for part in powers)
    table = np.empty((across * up, p, q), heights.dtype)
    threads.run_lines(lambda *span: _table(heights, *powers, *span, table), across, across * up)
    return table


def heights_cotangent(
    d_tables: AnyArray,
    touched: npt.NDArray[np.int64],
    shape: tuple[int, int],
    powers: tuple[AnyArray, AnyArray],
) -> Array:
    """Cotangent of the control heights from those of tables, the adjoint of `make_table`.

    `d_tables` (parts, patches, p + 1, q + 1): cotangents that are to be added up; `touched` (parts,
    2): first and last patch of each part whose cotangents are not 0; `shape`: numbers of control
    points.
    """
    across, up = (part.shape[2] for part in powers)
    parts = threads.parts(across * up)
    ends = threads.bounds(across, parts)
    shares = np.zeros((parts, *shape))
    known = d_tables, touched, *powers
    threads.run(lambda k: _adjoint(*known, ends[k], ends[k + 1], shares[k]), parts)
    return np.asarray(shares.sum(axis=0))


@jit(fastmath=FAST)
def _table(heights, powers_x, powers_y, first, last, table):  # type: ignore[no-untyped-def]
    (n_b, _, up), n_a = powers_y.shape, len(powers_x)
    row, total = np.empty(heights.shape[1], heights.dtype), np.empty(up, heights.dtype)
    for k in range(first, last):
        for a in range(n_a):
            row[:] = 0
            for i in range(n_a):
                _add(row, powers_x[i, a, k], heights[k + i])
            for b in range(n_b):
                total[:] = 0
                for j in range(n_b):
                    _add_products(total, powers_y[j, b], row[j:])
                for m in range(up):
                    table[k * up + m, a, b] = total[m]


@jit(fastmath=FAST)
def _adjoint(d_tables, touched, powers_x, powers_y, first, last, d_heights):  # type: ignore[no-untyped-def]
    (n_b, _, up), n_a = powers_y.shape, len(powers_x)
    terms = n_a * n_b
    row, patches, column = np.empty(d_heights.shape[1]), np.empty(up * terms), np.empty((terms, up))
    lines = d_tables.reshape(len(d_tables), -1, up * terms)
    for k in range(first, last):
        patches[:] = 0
        for part in range(len(lines)):
            if touched[part, 0] < (k + 1) * up and touched[part, 1] >= k * up:
                _add(patches, 1.0, lines[part, k])
        for m in range(up):  # columns of a term are summed up faster than terms of a patch
            for term in range(terms):
                column[term, m] = patches[m * terms + term]
        for a in range(n_a):
            row[:] = 0
            for b in range(n_b):
                for j in range(n_b):
                    _add_products(row[j:], powers_y[j, b], column[a * n_b + b])
            for i in range(n_a):
                _add(d_heights[k + i], powers_x[i, a, k], row)


@jit(fastmath=FAST)
def _add(total, factor, values):  # type: ignore[no-untyped-def]
    for m in range(len(values)):
        total[m] += factor * values[m]


@jit(fastmath=FAST)
def _add_products(total, factors, values):  # type: ignore[no-untyped-def]
    for m in range(len(factors)):
        total[m] += factors[m] * values[m]


@jit(fastmath=FAST, error_model="numpy")
def _hull(heights, distance_x, distance_y):  # type: ignore[no-untyped-def]
    """Lowest and highest control height, and the most that the slopes can be anywhere."""
    lowest = highest = heights[0, 0]
    slope_x = slope_y = heights.dtype.type(0)
    for i in range(heights.shape[0]):
        row = heights[i]
        for j in range(len(row)):
            lowest, highest = min(lowest, row[j]), max(highest, row[j])
        for j in range(len(row) - 1):
            slope_y = max(slope_y, abs(row[j + 1] - row[j]) / distance_y[j])
        if i > 0:
            before = heights[i - 1]
            for j in range(len(row)):
                slope_x = max(slope_x, abs(row[j] - before[j]) / distance_x[i - 1])
    return lowest, highest, slope_x, slope_y
