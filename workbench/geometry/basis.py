"""B-spline basis, clamped knot vectors, and exact knot insertion."""

from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array, Index

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def clamped_knots(count: int, degree: int) -> Array:
    """Return the clamped, equispaced knot vector (count + degree + 1,) on [0, 1].

    Piegl & Tiller, The NURBS Book, eq. 2.13; de Koning et al. (2023), eq. 5. Raise ValueError for
    fewer than ``degree + 1`` control points.
    """
    if count < degree + 1:
        raise ValueError(f"{count} control points are too few for degree {degree}")
    spans = count - degree
    # A division, not linspace: equal fractions give equal knots, so that nets nest exactly.
    inner = np.arange(spans + 1) / spans
    return np.concatenate([np.zeros(degree), inner, np.ones(degree)])


def greville(knots: Array, degree: int) -> Array:
    """Return the Greville abscissae (count,): the coefficients of the identity.

    They are means of p consecutive knots (Farin, Curves and Surfaces for CAGD, section 8.6).
    """
    means = np.lib.stride_tricks.sliding_window_view(knots[1:-1], degree).mean(axis=1)
    return np.asarray(means)


def insertion_matrix(coarse: Array, fine: Array, degree: int) -> Array:
    """Return the matrix (fine count, coarse count) of knot insertion.

    Oslo algorithm of Cohen, Lyche and Riesenfeld (1980): row j holds the discrete B-splines
    α_{i,p}(j), which obey the Cox-de Boor recursion with ``fine[j + p]`` in place of u. Raise
    ValueError if a knot of ``coarse`` is missing in ``fine``.
    """
    rows = len(fine) - degree - 1
    fine_knots, fine_counts = np.unique(fine, return_counts=True)
    for knot, multiplicity in zip(*np.unique(coarse, return_counts=True), strict=True):
        if multiplicity > fine_counts[fine_knots == knot].sum():
            raise ValueError(f"knot {knot:g} of the coarse knot vector is missing in the fine one")

    spans = np.searchsorted(coarse, fine[:rows], side="right") - 1
    spans = np.minimum(spans, len(coarse) - degree - 2)
    alpha = np.zeros((rows, len(coarse) - 1))
    alpha[np.arange(rows), spans] = 1.0
    for p in range(1, degree + 1):
        u = fine[p : rows + p, None]
        width = coarse[p:] - coarse[:-p]
        ratio = np.divide(1.0, width, out=np.zeros_like(width), where=width > 0)
        rising = (u - coarse[: -p - 1]) * ratio[:-1]
        falling = (coarse[p + 1 :] - u) * ratio[1:]
        alpha = rising * alpha[:, :-1] + falling * alpha[:, 1:]
    return alpha


def local_basis(knots: Array, degree: int, u: Array, derivative: int = 0) -> tuple[Index, Array]:
    """Return the ``degree + 1`` basis functions that do not vanish at each u (m,).

    `knots` (count + degree + 1,): clamped knot vector on [0, 1]; `degree`: polynomial degree p; `u`
    (m,): parameters in [0, 1]; u = 1 belongs to the last span; `derivative`: order of the
    derivative with respect to u. Returns `first` (m,): index of the first of these functions;
    `values` (m, degree + 1): their values, or those of their derivatives.

    Notes
    -----
    Cox-de Boor (The NURBS Book, eq. 2.5) and its derivative (eq. 2.7); 0/0 counts as 0.
    """
    count = len(knots) - degree - 1
    span = degree + np.searchsorted(knots[degree + 1 : count], u, side="right")
    return span - degree, _nonzero(knots, degree, u, span, derivative)


def _nonzero(knots: Array, degree: int, u: Array, span: Index, derivative: int) -> Array:
    if derivative > degree:
        return np.zeros((len(u), degree + 1))
    # Function by function, each for all u: numpy is slow along axes of a few numbers.
    around = {j: knots[span + j] for j in range(1 - degree, degree + 1)}
    values = np.ones((1, len(u)))
    for p in range(1, degree + 1):
        lower, values = values, np.zeros((p + 1, len(u)))
        # Function i of degree p has the support [knots[i], knots[i + p + 1]] and comes from the
        # functions i and i + 1 of degree p - 1, whose supports end at knots[i + p] and begin at
        # knots[i + 1]. Of these only span - p + 1 ... span are not zero.
        for k, each in enumerate(lower):
            left, right = around[k - p + 1], around[k + 1]
            width = right - left  # never 0: the span lies within each support
            if derivative > degree - p:
                values[k + 1] += p * each / width
                values[k] -= p * each / width
            else:
                # A ratio first, so that the ends of the domain come out as exactly 1.
                values[k + 1] += (u - left) / width * each
                values[k] += (right - u) / width * each
    return np.ascontiguousarray(values.T)


def basis_matrix(knots: Array, degree: int, u: Array, derivative: int = 0) -> Array:
    """Return all basis functions at each u, (m, count); parameters as for `local_basis`."""
    first, values = local_basis(knots, degree, u, derivative)
    matrix = np.zeros((len(u), len(knots) - degree - 1))
    np.put_along_axis(matrix, first[:, None] + np.arange(degree + 1), values, axis=1)
    return matrix


def sparse_basis(knots: Array, degree: int, u: Array, derivative: int = 0) -> "csr_array":
    """Return `basis_matrix` as a sparse matrix.

    Products with it are fast and use one core only.
    """
    from scipy.sparse import csr_array  # slow import

    first, values = local_basis(knots, degree, u, derivative)
    columns = first[:, None] + np.arange(degree + 1)
    begins = np.arange(0, columns.size + 1, degree + 1)
    shape = (len(u), len(knots) - degree - 1)
    return csr_array((values.ravel(), columns.ravel(), begins), shape=shape)
