"""Where the surface and its derivatives can be at most, span by span."""

import numpy as np

from workbench.arrays import Array
from workbench.geometry.knots import insertion_matrix
from workbench.geometry.surface import ControlNet


def derivative_range(
    net: ControlNet, heights: Array, order: tuple[int, int], parts: tuple[int, int] = (1, 1)
) -> tuple[Array, Array]:
    """Bounds of a derivative of the surface on equal parts of each knot span.

    Parameters
    ----------
    net : ControlNet
        The control net.
    heights : ndarray, shape (n_u, n_v)
        Control heights.
    order : tuple[int, int]
        Order of the derivative with respect to x and y; (0, 0) is the height itself.
    parts : tuple[int, int]
        Equal parts of a span along x and y. The bounds close in with the square of their number.

    Returns
    -------
    low, high : ndarray, shape (parts_x * spans_x, parts_y * spans_y)
        Values that the derivative never leaves there; attained at a corner of the part, or a
        little beyond what is attained.

    Notes
    -----
    On each part the derivative is a polynomial, and a polynomial stays within its Bernstein
    coefficients (Farin, Curves and Surfaces for CAGD, section 5.3).
    """
    coefficients = heights
    for axis in (0, 1):  # each time the axis that comes first
        into = to_bernstein(net, axis, order[axis], equal_parts(net, axis, parts[axis]))
        coefficients = np.tensordot(coefficients, into, axes=(0, 2))
    # [part along x, coefficient, part along y, coefficient]
    return coefficients.min(axis=(1, 3)), coefficients.max(axis=(1, 3))


def equal_parts(net: ControlNet, axis: int, parts: int) -> Array:
    """Where parts of the knot spans along an axis end, so many in each; from 0 to 1."""
    count = parts * (net.shape[axis] - net.degree[axis])
    return np.arange(count + 1) / count


def to_bernstein(net: ControlNet, axis: int, order: int, ends: Array) -> Array:
    """Matrices from control values to Bernstein coefficients of a derivative, along one axis.

    Parameters
    ----------
    net : ControlNet
        The control net.
    axis : int
        Its axis.
    order : int
        Order of the derivative.
    ends : ndarray, shape (m + 1,)
        Where parts end that have coefficients of their own, from 0 to 1; all knots are among them.

    Returns
    -------
    ndarray, shape (m, max(degree - order, 0) + 1, count)
    """
    knots, degree, count = net.knots[axis], net.degree[axis], net.shape[axis]
    parts = len(ends) - 1
    if order > degree:
        return np.zeros((parts, 1, count))
    matrix = np.eye(count)
    for _ in range(order):
        # The NURBS Book, eq. 3.8: a B-spline of one degree less.
        width = (knots[degree + 1 : -1] - knots[1 : -degree - 1]) * (2 * net.half_width[axis])
        matrix = np.diff(matrix, axis=0) * (degree / width)[:, None]
        knots, degree = knots[1:-1], degree - 1
    each = max(degree, 1)
    inner = np.repeat(ends[1:-1], each)
    fine = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    matrix = insertion_matrix(knots, fine, degree) @ matrix
    first = np.arange(parts) * each
    return np.asarray(matrix[first[:, None] + np.arange(degree + 1)])
