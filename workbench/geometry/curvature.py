"""Height, slope and curvatures of the exit face, from the derivatives of its B-spline."""

from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.basis import sparse_basis
from workbench.geometry.surface import ControlNet, Numeric

_ORDERS = (0, 1, 2)


class LocalShape(NamedTuple):
    """The exit face point by point; all of shape (m_u, m_v).

    A curvature is positive where the face is hollow, that is, where it bends towards +z.

    Attributes
    ----------
    height : ndarray
        Height z, scene units.
    slope : ndarray
        Magnitude of the gradient of z: the tangent of the angle with the x-y plane.
    mean : ndarray
        Mean curvature, half the sum of the principal curvatures, 1 / scene unit.
    gaussian : ndarray
        Gaussian curvature, their product, 1 / scene unit².
    smallest, largest : ndarray
        The principal curvatures, 1 / scene unit.
    """

    height: Array
    slope: Array
    mean: Array
    gaussian: Array
    smallest: Array
    largest: Array


def local_shape(net: ControlNet, heights: Array, u: Array, v: Array) -> LocalShape:
    """Shape of the exit face on a tensor grid of parameters.

    Parameters
    ----------
    net : ControlNet
        The B-spline space.
    heights : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    u, v : ndarray, shapes (m_u,) and (m_v,)
        Parameters in [0, 1].

    Notes
    -----
    The principal curvatures are the eigenvalues of I⁻¹ II, with the first fundamental form I and
    the second II = H / √(1 + |∇z|²), H the second derivatives of z (do Carmo, Differential
    Geometry of Curves and Surfaces, section 3.3). A face of degree 1 has edges along its knots;
    between them, where it is evaluated, it counts as flat along that axis.
    """
    by_u = [_along_first(net, 0, heights, u, order) for order in _ORDERS]
    z, q, t = (_along_first(net, 1, by_u[0].T, v, order).T for order in _ORDERS)
    p, s = (_along_first(net, 1, by_u[1].T, v, order).T for order in _ORDERS[:2])
    r = _along_first(net, 1, by_u[2].T, v, 0).T
    mean, gaussian = mean_and_gaussian(p, q, r, s, t)
    apart = np.sqrt((mean**2 - gaussian).clip(0))  # negative by rounding alone
    return LocalShape(z, np.hypot(p, q), mean, gaussian, mean - apart, mean + apart)


def mean_and_gaussian(
    p: Numeric, q: Numeric, r: Numeric, s: Numeric, t: Numeric
) -> tuple[Numeric, Numeric]:
    """Mean and Gaussian curvature of z(x, y), of the shape of its derivatives.

    Parameters
    ----------
    p, q, r, s, t : array
        Derivatives z_x, z_y, z_xx, z_xy, z_yy.
    """
    stretch = 1 + p * p + q * q  # determinant of the first fundamental form
    mean = ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * stretch**1.5)
    return mean, (r * t - s * s) / stretch**2


def _along_first(net: ControlNet, axis: int, values: Array, at: Array, order: int) -> Array:
    """Evaluate along the first axis of values, which is this axis of the net.

    Returns
    -------
    ndarray, shape (m, n)
        A derivative with respect to x or y.
    """
    matrix = sparse_basis(net.knots[axis], net.degree[axis], at, derivative=order)
    return np.asarray(matrix @ values) / (2 * net.half_width[axis]) ** order
