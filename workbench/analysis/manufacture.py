"""What a shop asks of a lens: thickness, slopes, radii of curvature, draft.

Each extreme comes twice: as attained at a place that has been looked at, and as a bound that the
face does not pass anywhere, from the convex hulls of its polynomials. The truth is in between.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.geometry.basis import basis_matrix
from workbench.geometry.bounds import derivative_range
from workbench.geometry.surface import ControlNet
from workbench.scene import Lens

Array = npt.NDArray[np.float64]

# Least numbers of parts along each axis that hulls are made of. Twice as many places are looked at.
_PARTS = 256
# Curvatures times the half-width that rounding of a plane may bring about.
_FLAT = 1e-9


class Extreme(NamedTuple):
    """The most or the least of something over the exit face.

    Attributes
    ----------
    value : float
        The extreme among many places.
    bound : float
        What it is not beyond anywhere.
    place : tuple[float, float]
        X and y of the value, scene units.
    """

    value: float
    bound: float
    place: tuple[float, float]


class SurfaceMaps(NamedTuple):
    """The exit face point by point; all of shape (n_y, n_x) with row 0 at +y.

    Attributes
    ----------
    x : ndarray, shape (n_x,)
        Ascending; scene units.
    y : ndarray, shape (n_y,)
        Descending; scene units.
    thickness : ndarray
        Height over the entrance face, scene units.
    slope : ndarray
        Angle between the face and the plane of the entrance face, degrees.
    concave, convex : ndarray
        Largest curvature of a hollow and of a hump there, 1 / scene unit; negative where there is
        none in any direction.
    """

    x: Array
    y: Array
    thickness: Array
    slope: Array
    concave: Array
    convex: Array


@dataclass(frozen=True)
class Manufacture:
    """Figures of a lens, in scene units and degrees.

    Attributes
    ----------
    thinnest, thickest : Extreme
        Thickness along z.
    sag_range : float
        Height of the highest point of the exit face over the lowest.
    steepest : Extreme
        Angle between the exit face and the plane of the entrance face, degrees.
    tightest_concave, tightest_convex : Extreme
        Smallest radius of curvature of hollows and humps of the exit face; infinite where there
        is none, 0 at the edges that a face of degree 1 has.
    """

    thinnest: Extreme
    thickest: Extreme
    sag_range: float
    steepest: Extreme
    tightest_concave: Extreme
    tightest_convex: Extreme

    @property
    def draft(self) -> float:
        """Least angle between the exit face and the axis, along which a mould opens, degrees.

        The four sides are parallel to the axis and have none.
        """
        return 90 - self.steepest.value


def surface_maps(lens: Lens, control_points: Array, count: tuple[int, int]) -> SurfaceMaps:
    """Thickness, slope and curvatures on a regular grid that includes the rim.

    Parameters
    ----------
    lens : Lens
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    count : tuple[int, int]
        Numbers of points along x and y.

    Notes
    -----
    The principal curvatures are the eigenvalues of I⁻¹ II, with the first fundamental form I and
    the second II = H / √(1 + |∇z|²), H the second derivatives of the height z.
    """
    net = ControlNet.of(lens)
    u, v = np.linspace(0, 1, count[0]), np.linspace(1, 0, count[1])
    z, p, q, r, s, t = (
        _derivative(net, control_points, u, v, order)
        for order in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    )
    squared = p**2 + q**2
    stretch = 1 + squared  # determinant of I
    mean = ((1 + q**2) * r - 2 * p * q * s + (1 + p**2) * t) / (2 * stretch**1.5)
    gauss = (r * t - s**2) / stretch**2
    apart = np.sqrt((mean**2 - gauss).clip(0))  # negative by rounding alone
    return SurfaceMaps(
        x=(2 * u - 1) * lens.half_width[0],
        y=(2 * v - 1) * lens.half_width[1],
        thickness=z - lens.entrance_z,
        slope=np.degrees(np.arctan(np.sqrt(squared))),
        concave=mean + apart,
        convex=apart - mean,
    )


def manufacture(lens: Lens, control_points: Array) -> Manufacture:
    """Figures of a lens.

    Parameters
    ----------
    lens : Lens
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    """
    net = ControlNet.of(lens)
    parts_x, parts_y = (
        math.ceil(_PARTS / (n - p)) for n, p in zip(net.shape, net.degree, strict=True)
    )
    count = tuple(
        2 * parts * (n - p) + 1
        for parts, n, p in zip((parts_x, parts_y), net.shape, net.degree, strict=True)
    )
    maps = surface_maps(lens, control_points, (count[0], count[1]))

    def hull(*order: int) -> tuple[Array, Array]:
        return derivative_range(net, control_points, (order[0], order[1]), (parts_x, parts_y))

    low, high = (z - lens.entrance_z for z in hull(0, 0))
    (least_x, most_x), (least_y, most_y) = (_magnitudes(*hull(*o)) for o in ((1, 0), (0, 1)))
    twist = _magnitudes(*hull(1, 1))[1]
    (valley_x, peak_x), (valley_y, peak_y) = hull(2, 0), hull(0, 2)
    stretch = np.sqrt(1 + least_x**2 + least_y**2)
    hollow = _steepest_bend(peak_x, peak_y, twist) / stretch
    hump = _steepest_bend(-valley_x, -valley_y, twist) / stretch

    steepest = math.degrees(math.atan(float(np.sqrt(most_x**2 + most_y**2).max())))
    thinnest = _most(maps, -maps.thickness, -float(low.min()))
    thinnest = Extreme(-thinnest.value, -thinnest.bound, thinnest.place)
    thickest = _most(maps, maps.thickness, float(high.max()))
    rises, falls = _edges(net, control_points)
    flat = _FLAT / max(lens.half_width)
    return Manufacture(
        thinnest=thinnest,
        thickest=thickest,
        sag_range=thickest.value - thinnest.value,
        steepest=_most(maps, maps.slope, steepest),
        tightest_concave=_radius(_most(maps, maps.concave, float(hollow.max())), flat, rises),
        tightest_convex=_radius(_most(maps, maps.convex, float(hump.max())), flat, falls),
    )


def _derivative(
    net: ControlNet, heights: Array, u: Array, v: Array, order: tuple[int, int]
) -> Array:
    """A derivative with respect to x and y on the grid of parameters, shape (m_v, m_u)."""
    along_x, along_y = (
        basis_matrix(knots, degree, t, derivative=m) / (2 * r) ** m
        for knots, degree, t, m, r in zip(
            net.knots, net.degree, (u, v), order, net.half_width, strict=True
        )
    )
    return np.asarray(along_y @ heights.T @ along_x.T)


def _magnitudes(low: Array, high: Array) -> tuple[Array, Array]:
    """The least and the most that magnitudes can be between two bounds."""
    inside = (low < 0) & (high > 0)
    least = np.where(inside, 0.0, np.minimum(np.abs(low), np.abs(high)))
    return least, np.maximum(np.abs(low), np.abs(high))


def _steepest_bend(r: Array, t: Array, s: Array) -> Array:
    """Largest eigenvalue, at least 0, of second derivatives with z_xx ≤ r, z_yy ≤ t, |z_xy| ≤ s.

    It grows with each of them. Over √(1 + |∇z|²) it bounds the curvature, since I is not less
    than the identity.
    """
    return np.asarray(((r + t) / 2 + np.hypot((r - t) / 2, s)).clip(0))


def _most(maps: SurfaceMaps, values: Array, bound: float) -> Extreme:
    row, column = np.unravel_index(values.argmax(), values.shape)
    place = float(maps.x[column]), float(maps.y[row])
    value = float(values[row, column])
    return Extreme(value, max(value, bound), place)  # rounding may put them in the wrong order


def _radius(curvature: Extreme, flat: float, has_edge: bool) -> Extreme:
    """The extreme of radii from that of curvatures; what is less than ``flat`` counts as none."""
    if has_edge:
        return Extreme(0.0, 0.0, curvature.place)
    value, bound = (1 / c if c > flat else math.inf for c in (curvature.value, curvature.bound))
    return Extreme(value, bound, curvature.place)


def _edges(net: ControlNet, heights: Array) -> tuple[bool, bool]:
    """Whether the slope jumps up somewhere, and down, as it may at the knots of degree 1."""
    jumps = [np.zeros(1)]
    for axis, values in ((0, heights), (1, heights.T)):
        if net.degree[axis] == 1:
            other = 1 - axis
            along = np.linspace(0, 1, 2 * _PARTS + 1)
            basis = basis_matrix(net.knots[other], net.degree[other], along)
            jumps.append(np.diff(values, n=2, axis=0) @ basis.T)
    rounding = _FLAT * float(np.ptp(heights))
    return any((j > rounding).any() for j in jumps), any((j < -rounding).any() for j in jumps)
