"""Least squares fits of B-splines to scattered points, on cells over which points are averaged."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.sparse import csr_array, diags_array, kron
from scipy.sparse.linalg import splu

from workbench.arrays import Array, Index
from workbench.geometry.basis import local_basis
from workbench.geometry.surface import ControlNet, even_counts

_CELLS = 256  # along the longer side
_STIFFNESS = 1e-9  # of second differences, which closes holes


def cells_of(points: Array, half_width: tuple[float, float], counts: tuple[int, int]) -> Index:
    """Number (n,) of the cell of each point, of a raster over the face."""
    i, j = (
        ((points[:, axis] / r + 1) / 2 * count).astype(np.intp).clip(0, count - 1)
        for axis, (r, count) in enumerate(zip(half_width, counts, strict=True))
    )
    return np.asarray(i * counts[1] + j)


@dataclass(frozen=True, eq=False)
class Cells:
    """Mean points (m, 3) of small cells of a face, and their numbers of points (m,)."""

    points: Array
    weights: Array

    @classmethod
    def of(cls, points: Array, half_width: tuple[float, float]) -> Self:
        """Average points (n, 3) over cells."""
        counts = even_counts(half_width, _CELLS)
        cells = cells_of(points, half_width, counts)
        number = np.bincount(cells, minlength=counts[0] * counts[1])
        there = np.flatnonzero(number)
        sums = [np.bincount(cells, column, minlength=len(number))[there] for column in points.T]
        return cls(np.stack(sums, axis=1) / number[there, None], number[there].astype(np.float64))


class Fit:
    """Least squares fits of values at points to a net."""

    def __init__(self, net: ControlNet, cells: Cells) -> None:
        self._net, self._weights = net, cells.weights
        self.basis = _basis(net, cells.points)
        self._bending = _bending(net.shape) * (_STIFFNESS * float(cells.weights.sum()))

    def control(self, values: Array, some: Array | None = None) -> Array:
        """Control heights (n_u, n_v) of values (m,), with weights ``some`` (m,) of the points."""
        return self.solved(values[:, None], some)[:, 0].reshape(self._net.shape)

    def solved(self, values: Array, some: Array | None = None) -> Array:
        """Coefficients (n, k) of columns of values (m, k)."""
        weighted = self.basis.T.multiply(self._weights if some is None else some).tocsr()
        normal = (weighted @ self.basis + self._bending).tocsc()
        solver = splu(normal, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        return np.asarray(solver.solve(weighted @ values))

    def rest(self, values: Array) -> Array:
        """Return what the fit leaves of columns of values (m, k)."""
        return np.asarray(values - self.basis @ self.solved(values))


def _basis(net: ControlNet, places: Array) -> csr_array:
    parts = [
        local_basis(knots, degree, ((place / r + 1) / 2).clip(0, 1))
        for knots, degree, r, place in zip(
            net.knots, net.degree, net.half_width, places.T[:2], strict=True
        )
    ]
    (first_x, along_x), (first_y, along_y) = parts
    index_x, index_y = (
        first[:, None] + np.arange(degree + 1)
        for first, degree in zip((first_x, first_y), net.degree, strict=True)
    )
    columns = index_x[:, :, None] * net.shape[1] + index_y[:, None, :]
    values = along_x[:, :, None] * along_y[:, None, :]
    begins = np.arange(0, values.size + 1, values[0].size)
    shape = (len(places), net.shape[0] * net.shape[1])
    return csr_array((values.ravel(), columns.ravel(), begins), shape=shape)


def _bending(shape: tuple[int, int]) -> csr_array:
    """Sum of the squares of second differences along u and v, and of mixed ones, as a matrix."""
    eyes = [csr_array(diags_array(np.ones(n))) for n in shape]
    ones, twos = ([csr_array(np.diff(np.eye(n), k, axis=0)) for n in shape] for k in (1, 2))
    bent = (kron(twos[0], eyes[1]), kron(eyes[0], twos[1]), kron(ones[0], ones[1]))
    first, second, mixed = (csr_array(each.T @ each) for each in bent)
    return first + second + mixed
