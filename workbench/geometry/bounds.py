"""Where the surface and its derivatives can be at most, span by span."""

import numpy as np
import numpy.typing as npt

from workbench.geometry.knots import insertion_matrix
from workbench.geometry.surface import ControlNet

Array = npt.NDArray[np.float64]


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
        into = to_bernstein(net, axis, order[axis], parts[axis])
        coefficients = np.tensordot(coefficients, into, axes=(0, 2))
    # [part along x, coefficient, part along y, coefficient]
    return coefficients.min(axis=(1, 3)), coefficients.max(axis=(1, 3))


def to_bernstein(net: ControlNet, axis: int, order: int, parts: int) -> Array:
    """Matrices from control values to Bernstein coefficients of a derivative, along one axis.

    Parameters
    ----------
    net : ControlNet
        The control net.
    axis : int
        Its axis.
    order : int
        Order of the derivative.
    parts : int
        Equal parts of a knot span, each with its own coefficients.

    Returns
    -------
    ndarray, shape (parts * spans, max(degree - order, 0) + 1, count)
    """
    knots, degree, count = net.knots[axis], net.degree[axis], net.shape[axis]
    spans = count - degree
    if order > degree:
        return np.zeros((parts * spans, 1, count))
    matrix = np.eye(count)
    for _ in range(order):
        # The NURBS Book, eq. 3.8: a B-spline of one degree less.
        width = (knots[degree + 1 : -1] - knots[1 : -degree - 1]) * (2 * net.half_width[axis])
        matrix = np.diff(matrix, axis=0) * (degree / width)[:, None]
        knots, degree = knots[1:-1], degree - 1
    inner = np.arange(1, parts * spans) / (parts * spans)
    each = max(degree, 1)
    fine = np.concatenate([np.zeros(degree + 1), np.repeat(inner, each), np.ones(degree + 1)])
    matrix = insertion_matrix(knots, fine, degree) @ matrix
    first = np.arange(parts * spans) * each
    return np.asarray(matrix[first[:, None] + np.arange(degree + 1)])
