"""What a shop asks of a lens: thickness, slopes, radii of curvature, draft.

Each extreme comes twice: as attained at a place that has been looked at, and as a bound that the
face does not pass anywhere, from the convex hulls of its polynomials. The truth is in between.
"""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.manufacture_bounds import shape_bounds
from workbench.geometry.basis import basis_matrix
from workbench.geometry.bounds import derivative_range
from workbench.geometry.curvature import local_shape
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, check_one_face
from workbench.scene import Optic

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

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

    def to_data(self) -> dict[str, Any]:
        """The numbers by name, for JSON, which has no infinity: None in its place."""
        value, bound = (None if math.isinf(n) else n for n in (self.value, self.bound))
        return {"value": value, "bound": bound, "place": list(self.place)}


class SurfaceMaps(NamedTuple):
    """The exit face point by point; all of shape (n_y, n_x) with row 0 at +y.

    Places beside the lens, within its bounding rectangle, have no numbers (NaN).

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

        The sides are parallel to the axis and have none.
        """
        return 90 - self.steepest.value

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "thinnest": self.thinnest.to_data(),
            "thickest": self.thickest.to_data(),
            "sag_range": self.sag_range,
            "steepest": self.steepest.to_data(),
            "draft": self.draft,
            "tightest_concave": self.tightest_concave.to_data(),
            "tightest_convex": self.tightest_convex.to_data(),
        }


def surface_maps(optic: Optic, control_points: Array, count: tuple[int, int]) -> SurfaceMaps:
    """Thickness, slope and curvatures on a regular grid that includes the rim.

    Parameters
    ----------
    optic : Optic
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.
    count : tuple[int, int]
        Numbers of points along x and y.

    Raises
    ------
    Refused
        If the lens has two freeform faces.
    """
    check_one_face(optic, "figures of manufacture")
    u, v = np.linspace(0, 1, count[0]), np.linspace(1, 0, count[1])
    shape = local_shape(ControlNet.of(optic), control_points, u, v)
    x, y = (2 * u - 1) * optic.half_width[0], (2 * v - 1) * optic.half_width[1]
    beside = np.where(outline_of(optic).contains(x, y[:, None]), 0.0, np.nan)
    return SurfaceMaps(
        x=x,
        y=y,
        thickness=optic.onwards * (shape.height.T - optic.flat_z(control_points)) + beside,
        slope=np.degrees(np.arctan(shape.slope.T)) + beside,
        concave=shape.largest.T + beside,
        convex=-shape.smallest.T + beside,
    )


def manufacture(optic: Optic, control_points: Array) -> Manufacture:
    """Figures of a lens.

    Parameters
    ----------
    optic : Optic
        The lens.
    control_points : ndarray, shape (n_u, n_v)
        Control heights, scene units.

    Raises
    ------
    Refused
        If the lens has two freeform faces.

    Examples
    --------
    >>> import numpy as np
    >>> from workbench.scene import Lens
    >>> lens = Lens(half_width=(1, 1), refractive_index=1.5, control_points=(8, 8))
    >>> wedge = np.linspace(0.5, 0.7, 8)[:, None] * np.ones(8)
    >>> found = manufacture(lens, wedge)
    >>> round(found.thinnest.value, 12), round(found.thickest.value, 12)
    (0.5, 0.7)
    """
    check_one_face(optic, "figures of manufacture")
    net = ControlNet.of(optic)
    parts_x, parts_y = (
        math.ceil(_PARTS / (n - p)) for n, p in zip(net.shape, net.degree, strict=True)
    )
    count = tuple(
        2 * parts * (n - p) + 1
        for parts, n, p in zip((parts_x, parts_y), net.shape, net.degree, strict=True)
    )
    maps = surface_maps(optic, control_points, (count[0], count[1]))

    low, high = derivative_range(net, control_points, (0, 0), (parts_x, parts_y))
    glass = _with_glass(optic, low.shape)
    bounds = shape_bounds(net, control_points, (parts_x, parts_y), glass)
    lowest, highest = sorted(
        optic.onwards * (float(end) - optic.flat_z(control_points))
        for end in (low[glass].min(), high[glass].max())
    )
    thinnest = _most(maps, -maps.thickness, -lowest)
    thinnest = Extreme(-thinnest.value, -thinnest.bound, thinnest.place)
    thickest = _most(maps, maps.thickness, highest)
    rises, falls = _edges(net, control_points)
    flat = _FLAT / max(optic.half_width)
    return Manufacture(
        thinnest=thinnest,
        thickest=thickest,
        sag_range=thickest.value - thinnest.value,
        steepest=_most(maps, maps.slope, math.degrees(math.atan(bounds.slope))),
        tightest_concave=_radius(_most(maps, maps.concave, bounds.hollow), flat, rises),
        tightest_convex=_radius(_most(maps, maps.convex, bounds.hump), flat, falls),
    )


def _with_glass(optic: Optic, parts: tuple[int, ...]) -> Mask:
    """Which of so many equal parts of the aperture along x and y the lens has a share of."""
    x, y = (np.linspace(-r, r, n + 1) for r, n in zip(optic.half_width, parts, strict=True))
    return outline_of(optic).area_inside((x[:-1, None], x[1:, None]), (y[:-1], y[1:])) > 0


def _most(maps: SurfaceMaps, values: Array, bound: float) -> Extreme:
    row, column = np.unravel_index(np.nanargmax(values), values.shape)
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
