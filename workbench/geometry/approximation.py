"""Approximation of a surface on another control net, and its deviation."""

from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array
from workbench.geometry.basis import sparse_basis

if TYPE_CHECKING:
    from workbench.geometry.surface import ControlNet


def project(net: "ControlNet", heights: Array, other: "ControlNet") -> Array:
    """Return the control heights of ``other`` whose surface is nearest in the L2 sense.

    ``heights`` are (n_u, n_v). The integrals over the face are exact: Gauss-Legendre between all
    knots of both nets. A surface of the other net's space is reproduced. Projections onto tensor
    products are products of projections along u and along v.
    """
    for axis in (0, 1):
        along = _project(
            heights if axis == 0 else heights.T,
            (net.knots[axis], net.degree[axis]),
            (other.knots[axis], other.degree[axis]),
        )
        heights = along if axis == 0 else along.T
    return heights


def deviation(net: "ControlNet", heights: Array, other: "ControlNet", others: Array) -> float:
    """Return the largest difference in z of the surfaces of two nets, scene units.

    It is sampled at the knots of both nets and midway between them.
    """
    u, v = (_with_midpoints(*knots) for knots in zip(net.knots, other.knots, strict=True))
    here = _values(net, heights, u, v)
    return float(np.abs(here - _values(other, others, u, v)).max())


def _project(values: Array, spline: tuple[Array, int], other: tuple[Array, int]) -> Array:
    from scipy.linalg import solveh_banded  # slow import

    (knots, degree), (others, other_degree) = spline, other
    places, weights = np.polynomial.legendre.leggauss(max(degree, other_degree) + 1)
    ends = np.union1d(knots, others)
    half = np.diff(ends)[:, None] / 2
    t = (ends[:-1, None] + half * (1 + places)).ravel()
    here, there = sparse_basis(knots, degree, t), sparse_basis(others, other_degree, t)
    weighted = there.T.multiply((half * weights).ravel()).tocsr()
    gram = weighted @ there
    bands = np.zeros((other_degree + 1, gram.shape[0]))
    for k in range(other_degree + 1):  # lower bands, for the solver
        bands[k, : gram.shape[0] - k] = gram.diagonal(-k)
    return np.asarray(solveh_banded(bands, weighted @ (here @ values), lower=True))


def _values(net: "ControlNet", heights: Array, u: Array, v: Array) -> Array:
    along_u, along_v = (
        sparse_basis(knots, degree, t)
        for knots, degree, t in zip(net.knots, net.degree, (u, v), strict=True)
    )
    return np.asarray((along_v @ (along_u @ heights).T).T)


def _with_midpoints(knots: Array, others: Array) -> Array:
    ends = np.union1d(knots, others)
    return np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))


def nearest_finer(net: "ControlNet", wanted: tuple[int, int], most: int) -> tuple[int, int]:
    """Return the size nearest to ``wanted`` of a net that contains all surfaces of this one.

    Each span is divided into equal parts, up to ``most`` control points along an axis.
    """
    sizes = []
    for count, degree, goal in zip(net.shape, net.degree, wanted, strict=True):
        spans = count - degree
        parts = min(round((goal - degree) / spans), (most - degree) // spans)
        sizes.append(max(parts, 1) * spans + degree)
    return sizes[0], sizes[1]
