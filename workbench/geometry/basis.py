"""Values and derivatives of B-spline basis functions."""

from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array, Index

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def local_basis(knots: Array, degree: int, u: Array, derivative: int = 0) -> tuple[Index, Array]:
    """The ``degree + 1`` basis functions that do not vanish at each u.

    Parameters
    ----------
    knots : ndarray, shape (count + degree + 1,)
        Clamped knot vector on [0, 1].
    degree : int
        Polynomial degree p.
    u : ndarray, shape (m,)
        Parameters in [0, 1]; u = 1 belongs to the last span.
    derivative : int
        Order of the derivative with respect to u.

    Returns
    -------
    first : ndarray of int, shape (m,)
        Index of the first of these functions.
    values : ndarray, shape (m, degree + 1)
        Their values, or those of their derivatives.

    Notes
    -----
    Cox-de Boor (The NURBS Book, eq. 2.5) and its derivative (eq. 2.7); 0/0 counts as 0.
    """
    count = len(knots) - degree - 1
    span = degree + np.searchsorted(knots[degree + 1 : count], u, side="right")
    return span - degree, _nonzero(knots, degree, u, span, derivative)


def _nonzero(knots: Array, degree: int, u: Array, span: Index, derivative: int) -> Array:
    """Functions ``span - degree`` to ``span`` of the given degree, at each u."""
    if derivative > degree:
        return np.zeros((len(u), degree + 1))
    if degree == 0:
        return np.ones((len(u), 1))
    lower = _nonzero(knots, degree - 1, u, span, max(derivative - 1, 0))
    # Function i of degree p has the support [knots[i], knots[i + p + 1]] and comes from the
    # functions i and i + 1 of degree p - 1, whose supports end at knots[i + p] and begin at
    # knots[i + 1]. Of these only span - p + 1 ... span are not zero.
    index = span[:, None] - degree + 1 + np.arange(degree)
    left, right = knots[index], knots[index + degree]
    width = right - left  # never 0: the span lies within each support
    values = np.zeros((len(u), degree + 1))
    if derivative > 0:
        values[:, 1:] += degree * lower / width
        values[:, :-1] -= degree * lower / width
    else:
        # A ratio first, so that the ends of the domain come out as exactly 1.
        values[:, 1:] += (u[:, None] - left) / width * lower
        values[:, :-1] += (right - u[:, None]) / width * lower
    return values


def basis_matrix(knots: Array, degree: int, u: Array, derivative: int = 0) -> Array:
    """All basis functions at each u, as a matrix that turns control values into spline values.

    Parameters
    ----------
    knots, degree, u, derivative
        As for `local_basis`.

    Returns
    -------
    ndarray, shape (m, count)
    """
    first, values = local_basis(knots, degree, u, derivative)
    matrix = np.zeros((len(u), len(knots) - degree - 1))
    np.put_along_axis(matrix, first[:, None] + np.arange(degree + 1), values, axis=1)
    return matrix


def sparse_basis(knots: Array, degree: int, u: Array, derivative: int = 0) -> "csr_array":
    """`basis_matrix` without its zeros: few control points matter at any one place.

    Products with it are fast on the core of the caller and leave the others alone.
    """
    from scipy.sparse import csr_array  # late: it takes long to import

    first, values = local_basis(knots, degree, u, derivative)
    columns = first[:, None] + np.arange(degree + 1)
    begins = np.arange(0, columns.size + 1, degree + 1)
    shape = (len(u), len(knots) - degree - 1)
    return csr_array((values.ravel(), columns.ravel(), begins), shape=shape)
