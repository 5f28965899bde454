"""What a shop asks of a lens: thickness, slopes, radii of curvature, draft.

Each extreme comes twice: as attained at a place that has been looked at, and as a bound that the
lens does not pass anywhere, from the convex hulls of its polynomials. The truth is in between.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from workbench.analysis.manufacture_bounds import FaceBounds, difference_range, shape_bounds
from workbench.arrays import Array, Mask
from workbench.geometry.ball_cutter import GridFace, blocked_radius
from workbench.geometry.basis import basis_matrix
from workbench.geometry.curvature import equal_parts, local_shape
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.progress import check_given_up
from workbench.scene import Element

# Least numbers of parts along each axis that hulls are made of. Twice as many places are looked at.
_PARTS = 256
# Curvatures times the half-width that rounding of a plane may bring about.
_FLAT = 1e-9


class Extreme(NamedTuple):
    """The most or the least of something over the lens."""

    value: float  # the extreme among many places
    bound: float  # what it is not beyond anywhere
    place: tuple[float, float]  # X and y of the value, scene units

    def to_data(self) -> dict[str, Any]:
        """The numbers by name, for JSON, which has no infinity: None in its place."""
        value, bound = (None if math.isinf(n) else n for n in (self.value, self.bound))
        return {"value": value, "bound": bound, "place": list(self.place)}


class SurfaceMaps(NamedTuple):
    """A freeform face point by point; all of shape (n_y, n_x) with row 0 at +y.

    Places beside the lens, within its bounding rectangle, have no numbers (NaN).
    """

    x: Array  # (n_x,), ascending; scene units
    y: Array  # (n_y,), descending; scene units
    thickness: Array  # distance between both faces along z, scene units
    slope: Array  # angle between the face and a plane across the axis, degrees
    # Largest curvature of a hollow and of a hump there, as the face is seen from outside, 1 / scene
    # unit; negative where there is none in any direction.
    concave: Array
    convex: Array


@dataclass(frozen=True)
class FaceFigures:
    """Figures of a freeform face, in scene units and degrees."""

    sag_range: float  # height of the highest point of the face over the lowest
    steepest: Extreme  # angle between the face and a plane across the axis, degrees
    # Smallest radius of curvature of hollows and humps of the face; infinite where there is none, 0
    # at the edges that a face of degree 1 has.
    tightest_concave: Extreme
    tightest_convex: Extreme
    # Largest radius of a ball cutter that fits everywhere and cuts into no other part of the face;
    # infinite where any does, 0 at hollow edges. At the place it is tightest.
    tool_radius: Extreme

    @property
    def draft(self) -> float:
        """Least angle between the face and the axis, along which a mould opens, degrees.

        The sides are parallel to the axis and have none.
        """
        return 90 - self.steepest.value

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "sag_range": self.sag_range,
            "steepest": self.steepest.to_data(),
            "draft": self.draft,
            "tightest_concave": self.tightest_concave.to_data(),
            "tightest_convex": self.tightest_convex.to_data(),
            "tool_radius": self.tool_radius.to_data(),
        }


@dataclass(frozen=True)
class Manufacture(FaceFigures):
    """Figures of a lens: of its exit face, and of both faces together."""

    # Thickness along z.
    thinnest: Extreme
    thickest: Extreme
    entrance: FaceFigures | None = None  # those of a freeform entrance face

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON; those of a flat entrance face are left out."""
        both = {"thinnest": self.thinnest.to_data(), "thickest": self.thickest.to_data()}
        data = both | super().to_data()
        return data if self.entrance is None else data | {"entrance": self.entrance.to_data()}


def surface_maps(
    optic: Element, heights: Mapping[str, Array], count: tuple[int, int], face: str = ""
) -> SurfaceMaps:
    """Thickness, slope and curvatures on a regular grid that includes the rim.

    `heights` (n_u, n_v); `count`: numbers of points along x and y; `face`: the name of the face; by
    default the one that the task shapes.
    """
    face = face or optic.designed_face
    u, v = np.linspace(0, 1, count[0]), np.linspace(1, 0, count[1])
    nets, outward = freeform_nets(optic), optic.outwards(face)
    shape = local_shape(nets[face], outward * heights[face], u, v)
    other = _other_side(optic, heights, nets, face, u, v)
    x, y = (2 * u - 1) * optic.half_width[0], (2 * v - 1) * optic.half_width[1]
    beside = np.where(outline_of(optic).contains(x, y[:, None]), 0.0, np.nan)
    return SurfaceMaps(
        x=x,
        y=y,
        thickness=(shape.height - outward * other).T + beside,
        slope=np.degrees(np.arctan(shape.slope.T)) + beside,
        concave=shape.largest.T + beside,
        convex=-shape.smallest.T + beside,
    )


def _other_side(
    optic: Element,
    heights: Mapping[str, Array],
    nets: Mapping[str, ControlNet],
    face: str,
    u: Array,
    v: Array,
) -> Array:
    """The z of what is opposite to a face: of the other freeform face, or of the flat side."""
    others = [name for name in nets if name != face]
    if not others:
        return np.full((1, 1), optic.flat_z(heights[face]))
    return nets[others[0]].grid(u, v).evaluate(heights[others[0]])[0]


def manufacture(optic: Element, heights: Mapping[str, Array]) -> Manufacture:
    """Figures of a lens.

    `heights` (n_u, n_v).

    Examples
    --------
    >>> import numpy as np
    >>> from workbench.scene import Lens
    >>> plane, freeform = {"shape": "plane"}, {"shape": "bspline", "control_points": (8, 8)}
    >>> lens = Lens(
    ...     kind="lens", name="lens", half_width=(1, 1), material="PMMA", thickness=0.5,
    ...     faces=(plane, freeform),
    ... )
    >>> wedge = np.linspace(0.5, 0.7, 8)[:, None] * np.ones(8)
    >>> found = manufacture(lens, {"lens.back": wedge})
    >>> round(found.thinnest.value, 12), round(found.thickest.value, 12)
    (0.5, 0.7)
    """
    maps, own = _figures(optic, heights, optic.designed_face)
    lowest, highest = _thicknesses(optic, heights)
    thinnest = _most(maps, -maps.thickness, -lowest)
    return Manufacture(
        **vars(own),
        thinnest=Extreme(-thinnest.value, -thinnest.bound, thinnest.place),
        thickest=_most(maps, maps.thickness, highest),
        entrance=_figures(optic, heights, optic.designed_front)[1]
        if optic.designed_front
        else None,
    )


def _figures(
    optic: Element, heights: Mapping[str, Array], face: str
) -> tuple[SurfaceMaps, FaceFigures]:
    """A face at many places, and its figures."""
    net, outward = freeform_nets(optic)[face], optic.outwards(face) * heights[face]
    spans = [n - p for n, p in zip(net.shape, net.degree, strict=True)]
    parts_x, parts_y = (math.ceil(_PARTS / n) for n in spans)
    count = 2 * parts_x * spans[0] + 1, 2 * parts_y * spans[1] + 1
    check_given_up()
    maps = surface_maps(optic, heights, count, face)
    ends = equal_parts(net, 0, parts_x), equal_parts(net, 1, parts_y)
    bounds = shape_bounds(net, outward, (parts_x, parts_y), _with_glass(optic, ends))
    places = net.grid(np.linspace(0, 1, count[0]), np.linspace(1, 0, count[1]))
    glass = np.isfinite(maps.slope.T)
    height, *slopes = (np.where(glass, each, np.nan) for each in places.evaluate(outward))
    rises, falls = _edges(net, outward)
    flat = _FLAT / max(optic.half_width)
    concave = _radius(_most(maps, maps.concave, bounds.hollow), flat, rises)
    return maps, FaceFigures(
        sag_range=float(np.ptp(height[glass])),
        steepest=_most(maps, maps.slope, math.degrees(math.atan(bounds.slope))),
        tightest_concave=concave,
        tightest_convex=_radius(_most(maps, maps.convex, bounds.hump), flat, falls),
        tool_radius=_tool_radius(GridFace(maps.x, maps.y, height, *slopes), concave, bounds),
    )


def _tool_radius(face: GridFace, concave: Extreme, bounds: FaceBounds) -> Extreme:
    """What curvature allows, or less where another part of the face is in the way.

    A second derivative of z along any line is at most the curvature times (1 + slope²)^1.5. If none
    is above 1 / R, the face lies below each parabola of that second derivative that touches it, and
    a ball of radius R lies above these: it fits, so far away as the face goes.
    """
    if math.isinf(concave.value) or concave.value == 0:
        return concave
    # Closer pairs are those that curvature tells of.
    value, place = blocked_radius(face.coarser(), concave.value) or (concave.value, concave.place)
    surely = concave.bound / (1 + bounds.slope**2) ** 1.5
    return Extreme(value, min(surely, value), place)


def _thicknesses(optic: Element, heights: Mapping[str, Array]) -> tuple[float, float]:
    """The least and the most that a lens can be thick anywhere."""
    nets = freeform_nets(optic)
    faces = [
        (nets[face], heights[face])
        for face in (optic.designed_face, *(nets.keys() - {optic.designed_face}))
    ]
    if len(faces) == 1:
        flat = np.full((2, 2), optic.flat_z(heights[optic.designed_face]))
        faces.append((ControlNet((2, 2), (1, 1), optic.half_width), flat))
    check_given_up()
    low, high, ends = difference_range(faces[0], faces[1], _PARTS)
    glass = _with_glass(optic, ends)
    lowest, highest = sorted(
        optic.onwards * float(z) for z in (low[glass].min(), high[glass].max())
    )
    return lowest, highest


def _with_glass(optic: Element, ends: tuple[Array, Array]) -> Mask:
    """Which parts of the aperture, between such ends in [0, 1], the lens has a share of."""
    x, y = ((2 * end - 1) * r for end, r in zip(ends, optic.half_width, strict=True))
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
