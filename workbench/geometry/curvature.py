"""Local shape of a face (height, slope, curvatures) and bounds of its derivatives."""

from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.basis import insertion_matrix, sparse_basis
from workbench.geometry.surface import ControlNet, Numeric

_ORDERS = (0, 1, 2)


class LocalShape(NamedTuple):
    """Shape of a face at a grid of points; all arrays are (m_u, m_v).

    A curvature is positive where the face is concave towards +z. Lengths are in scene units.
    ``slope_x`` and ``slope_y`` are derivatives of z, ``mean`` and ``gaussian`` the mean and the
    Gaussian curvature, ``smallest`` and ``largest`` the principal curvatures.
    """

    height: Array
    slope_x: Array
    slope_y: Array
    mean: Array
    gaussian: Array
    smallest: Array
    largest: Array

    @property
    def slope(self) -> Array:
        """Magnitude of the gradient of z."""
        return np.hypot(self.slope_x, self.slope_y)


def local_shape(net: ControlNet, heights: Array, u: Array, v: Array) -> LocalShape:
    """Return the shape of a face at a tensor grid of parameters u (m_u,), v (m_v,) in [0, 1].

    The principal curvatures are the eigenvalues of I⁻¹ II, with the first fundamental form I and
    the second II = H / √(1 + |∇z|²), H the second derivatives of z (do Carmo, Differential Geometry
    of Curves and Surfaces, section 3.3). A face of degree 1 has edges along its knots; between
    them, where it is evaluated, it counts as flat along that axis.
    """
    by_u = [_along_first(net, 0, heights, u, order) for order in _ORDERS]
    z, q, t = (_along_first(net, 1, by_u[0].T, v, order).T for order in _ORDERS)
    p, s = (_along_first(net, 1, by_u[1].T, v, order).T for order in _ORDERS[:2])
    r = _along_first(net, 1, by_u[2].T, v, 0).T
    mean, gaussian = mean_and_gaussian(p, q, r, s, t)
    apart = np.sqrt((mean**2 - gaussian).clip(0))  # negative by rounding alone
    return LocalShape(z, p, q, mean, gaussian, mean - apart, mean + apart)


def mean_and_gaussian(
    p: Numeric, q: Numeric, r: Numeric, s: Numeric, t: Numeric
) -> tuple[Numeric, Numeric]:
    """Mean and Gaussian curvature of z(x, y) from z_x, z_y, z_xx, z_xy, z_yy."""
    stretch = 1 + p * p + q * q  # determinant of the first fundamental form
    mean = ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * stretch**1.5)
    return mean, (r * t - s * s) / stretch**2


def _along_first(net: ControlNet, axis: int, values: Array, at: Array, order: int) -> Array:
    matrix = sparse_basis(net.knots[axis], net.degree[axis], at, derivative=order)
    return np.asarray(matrix @ values) / (2 * net.half_width[axis]) ** order


def derivative_range(
    net: ControlNet, heights: Array, order: tuple[int, int], parts: tuple[int, int] = (1, 1)
) -> tuple[Array, Array]:
    """Bound a derivative of the surface on equal parts of each knot span.

    `net`: the control net; `heights` (n_u, n_v): control heights; `order`: order of the derivative
    with respect to x and y; (0, 0) is the height itself; `parts`: equal parts of a span along x and
    y; the bounds converge with the square of their number. Returns `low, high` (parts_x * spans_x,
    parts_y * spans_y): bounds, attained at a corner of the part or slightly too wide.

    Notes
    -----
    On each part the derivative is a polynomial, and a polynomial stays within its Bernstein
    coefficients (Farin, Curves and Surfaces for CAGD, section 5.3).
    """
    coefficients = heights
    for axis in (0, 1):  # in turn the first axis
        into = to_bernstein(net, axis, order[axis], equal_parts(net, axis, parts[axis]))
        coefficients = np.tensordot(coefficients, into, axes=(0, 2))
    # [part along x, coefficient, part along y, coefficient]
    return coefficients.min(axis=(1, 3)), coefficients.max(axis=(1, 3))


def equal_parts(net: ControlNet, axis: int, parts: int) -> Array:
    """Ends, from 0 to 1, of equal parts of the knot spans along an axis."""
    count = parts * (net.shape[axis] - net.degree[axis])
    return np.arange(count + 1) / count


def to_bernstein(net: ControlNet, axis: int, order: int, ends: Array) -> Array:
    """Return matrices from control values to Bernstein coefficients of a derivative.

    They have the shape (m, max(degree - order, 0) + 1, count) and act along one axis. ``ends`` (m +
    1,), from 0 to 1, divide the axis into parts with their own coefficients; all knots are among
    them.
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
