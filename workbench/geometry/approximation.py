"""A surface on another control net: as near as that net allows, and how far off it is."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from workbench.geometry.basis import basis_matrix

if TYPE_CHECKING:
    from workbench.geometry.surface import ControlNet

Array = npt.NDArray[np.float64]


def project(net: "ControlNet", heights: Array, other: "ControlNet") -> Array:
    """Heights for another net whose surface is nearest in the least-squares sense.

    Parameters
    ----------
    net : ControlNet
        The net that the surface is on.
    heights : ndarray, shape (n_u, n_v)
        Its control heights.
    other : ControlNet
        Any net, of any degree; its half-widths play no part.

    Returns
    -------
    ndarray, shape of ``other``
        They minimise the integral of the squared difference over the whole face. A surface that
        the other net can hold comes out as it is.

    Notes
    -----
    Projections onto tensor products are products of projections along u and along v. The
    integrals are exact: Gauss-Legendre between all knots of both nets.
    """
    along_u, along_v = (
        _projection(knots, degree, others, other_degree)
        for knots, degree, others, other_degree in zip(
            net.knots, net.degree, other.knots, other.degree, strict=True
        )
    )
    return np.asarray(along_u @ heights @ along_v.T)


def deviation(net: "ControlNet", heights: Array, other: "ControlNet", others: Array) -> float:
    """Largest distance in z between the surfaces of two nets.

    Parameters
    ----------
    net, other : ControlNet
        Nets over the same aperture.
    heights, others : ndarray
        Their control heights, scene units.

    Returns
    -------
    float
        Scene units; taken at the knots of both nets and midway between them.
    """
    u, v = (_with_midpoints(*knots) for knots in zip(net.knots, other.knots, strict=True))
    here = _values(net, heights, u, v)
    return float(np.abs(here - _values(other, others, u, v)).max())


def _projection(knots: Array, degree: int, others: Array, other_degree: int) -> Array:
    places, weights = np.polynomial.legendre.leggauss(max(degree, other_degree) + 1)
    ends = np.union1d(knots, others)
    half = np.diff(ends)[:, None] / 2
    t = (ends[:-1, None] + half * (1 + places)).ravel()
    weight = (half * weights).reshape(-1, 1)
    here, there = basis_matrix(knots, degree, t), basis_matrix(others, other_degree, t)
    return np.asarray(np.linalg.solve(there.T @ (weight * there), there.T @ (weight * here)))


def _values(net: "ControlNet", heights: Array, u: Array, v: Array) -> Array:
    along_u, along_v = (
        basis_matrix(knots, degree, t)
        for knots, degree, t in zip(net.knots, net.degree, (u, v), strict=True)
    )
    return np.asarray(along_u @ heights @ along_v.T)


def _with_midpoints(knots: Array, others: Array) -> Array:
    ends = np.union1d(knots, others)
    return np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))


def nearest_finer(net: "ControlNet", wished: tuple[int, int], most: int) -> tuple[int, int]:
    """The size nearest to a wished one, of a net that holds all surfaces of this one exactly.

    Parameters
    ----------
    net : ControlNet
        Each of its spans is divided into as many parts.
    wished : tuple[int, int]
        Numbers of control points along x and y.
    most : int
        Control points along an axis at most; not fewer than this net has.
    """
    sizes = []
    for count, degree, goal in zip(net.shape, net.degree, wished, strict=True):
        spans = count - degree
        parts = min(round((goal - degree) / spans), (most - degree) // spans)
        sizes.append(max(parts, 1) * spans + degree)
    return sizes[0], sizes[1]
