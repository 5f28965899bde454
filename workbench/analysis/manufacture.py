"""Figures of a lens for manufacture: thickness, slopes, radii of curvature, draft; their limits.

Each extreme has two values: the extreme of many samples, and a bound for all points from the convex
hulls of the polynomials.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, NamedTuple

import numpy as np

from workbench.analysis.manufacture_bounds import FaceBounds, difference_range, shape_bounds
from workbench.analysis.shop_limits import Limits
from workbench.arrays import Array, Mask
from workbench.geometry.ball_cutter import GridFace, blocked_places, blocked_radius
from workbench.geometry.basis import basis_matrix
from workbench.geometry.curvature import equal_parts, local_shape
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.progress import Steps, check_given_up, finished, of_equal, within
from workbench.scene import Element

_PARTS = 256  # least parts along each axis for hulls; samples are twice as many
# Fractions of the time of `_figures`: of 1.5 s on a net of 480 × 480, maps took 0.15, bounds 0.95.
_WITH_MAPS, _WITH_BOUNDS = 0.1, 0.7
_FLAT = 1e-9  # curvature of a plane by rounding, times the half-width
_ROUNDING = 1e-9  # relative, of a figure on its limit

State = Literal["met", "open", "broken"]


class Extreme(NamedTuple):
    """Maximum or minimum of a quantity over the lens."""

    value: float  # extreme of the samples
    bound: float  # of all points
    place: tuple[float, float]  # x and y of the value, scene units

    def to_data(self) -> dict[str, Any]:
        """The numbers by name, for JSON; None for infinity."""
        value, bound = (None if math.isinf(n) else n for n in (self.value, self.bound))
        return {"value": value, "bound": bound, "place": list(self.place)}


class SurfaceMaps(NamedTuple):
    """Maps (n_y, n_x) of a freeform face, row 0 at +y; NaN beside the outline of the lens."""

    x: Array  # (n_x,), ascending; scene units
    y: Array  # (n_y,), descending; scene units
    thickness: Array  # along z, scene units
    slope: Array  # against a plane across the axis, degrees
    # Largest concave and convex curvature, seen from outside, 1 / scene unit; negative if none.
    concave: Array
    convex: Array
    face: GridFace  # seen from outside


@dataclass(frozen=True)
class FaceFigures:
    """Figures of a freeform face, in scene units and degrees."""

    sag_range: float  # highest less lowest z
    steepest: Extreme  # slope against a plane across the axis, degrees
    # Smallest radius of concave and convex curvature; infinite if none, 0 at edges of degree 1.
    tightest_concave: Extreme
    tightest_convex: Extreme
    tool_radius: Extreme  # of the largest ball cutter that fits everywhere

    @property
    def draft(self) -> float:
        """Least angle between the face and the axis of the mould, degrees; 0 at the sides."""
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
    """Figures of a lens: of its designed face, and of both faces together."""

    # Thickness along z.
    thinnest: Extreme
    thickest: Extreme
    entrance: FaceFigures | None = None  # of a freeform front face

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        both = {"thinnest": self.thinnest.to_data(), "thickest": self.thickest.to_data()}
        data = both | super().to_data()
        return data if self.entrance is None else data | {"entrance": self.entrance.to_data()}


def surface_maps(
    optic: Element, heights: Mapping[str, Array], count: tuple[int, int], face: str = ""
) -> SurfaceMaps:
    """Return maps of a face on a regular grid of ``count`` points that includes the rim.

    ``face`` is by default the designed face.
    """
    face = face or optic.designed_face
    u, v = np.linspace(0, 1, count[0]), np.linspace(1, 0, count[1])
    nets, outward = freeform_nets(optic), optic.outwards(face)
    shape = local_shape(nets[face], outward * heights[face], u, v)
    other = _other_side(optic, heights, nets, face, u, v)
    x, y = (2 * u - 1) * optic.half_width[0], (2 * v - 1) * optic.half_width[1]
    beside = np.where(outline_of(optic).contains(x, y[:, None]), 0.0, np.nan)
    seen = (each + beside.T for each in (shape.height, shape.slope_x, shape.slope_y))
    return SurfaceMaps(
        x=x,
        y=y,
        thickness=(shape.height - outward * other).T + beside,
        slope=np.degrees(np.arctan(shape.slope.T)) + beside,
        concave=shape.largest.T + beside,
        convex=-shape.smallest.T + beside,
        face=GridFace(x, y, *seen),
    )


def _other_side(
    optic: Element,
    heights: Mapping[str, Array],
    nets: Mapping[str, ControlNet],
    face: str,
    u: Array,
    v: Array,
) -> Array:
    """Return z of the opposite face: freeform, or the flat side."""
    others = [name for name in nets if name != face]
    if not others:
        return np.full((1, 1), optic.flat_z(heights[face]))
    return nets[others[0]].grid(u, v).evaluate(heights[others[0]])[0]


def manufacture(optic: Element, heights: Mapping[str, Array]) -> Manufacture:
    """Return the figures of a lens.

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
    return finished(manufacturing(optic, heights))


def manufacturing(optic: Element, heights: Mapping[str, Array]) -> Steps[Manufacture]:
    """Steps towards the figures of `manufacture`."""
    part = partial(of_equal, 3 if optic.designed_front else 2)
    steps = _figures(optic, heights, optic.designed_face)
    maps, own = yield from within(steps, partial(part, 0))
    lowest, highest = _thicknesses(optic, heights)
    thinnest = _most(maps, -maps.thickness, -lowest)
    yield part(1, 1.0)
    entrance = None
    if optic.designed_front:
        steps = _figures(optic, heights, optic.designed_front)
        _, entrance = yield from within(steps, partial(part, 2))
    return Manufacture(
        **vars(own),
        thinnest=Extreme(-thinnest.value, -thinnest.bound, thinnest.place),
        thickest=_most(maps, maps.thickness, highest),
        entrance=entrance,
    )


def _figures(
    optic: Element, heights: Mapping[str, Array], face: str
) -> Steps[tuple[SurfaceMaps, FaceFigures]]:
    net, outward = freeform_nets(optic)[face], optic.outwards(face) * heights[face]
    spans = [n - p for n, p in zip(net.shape, net.degree, strict=True)]
    parts_x, parts_y = (math.ceil(_PARTS / n) for n in spans)
    count = 2 * parts_x * spans[0] + 1, 2 * parts_y * spans[1] + 1
    check_given_up()
    maps = surface_maps(optic, heights, count, face)
    yield _WITH_MAPS
    ends = equal_parts(net, 0, parts_x), equal_parts(net, 1, parts_y)
    bounds = shape_bounds(net, outward, (parts_x, parts_y), _with_glass(optic, ends))
    yield _WITH_BOUNDS
    rises, falls = _edges(net, outward)
    flat = _FLAT / max(optic.half_width)
    concave = _radius(_most(maps, maps.concave, bounds.hollow), flat, rises)
    return maps, FaceFigures(
        sag_range=float(np.nanmax(maps.face.height) - np.nanmin(maps.face.height)),
        steepest=_most(maps, maps.slope, math.degrees(math.atan(bounds.slope))),
        tightest_concave=concave,
        tightest_convex=_radius(_most(maps, maps.convex, bounds.hump), flat, falls),
        tool_radius=_tool_radius(maps.face, concave, bounds),
    )


def _tool_radius(face: GridFace, concave: Extreme, bounds: FaceBounds) -> Extreme:
    """Return the smaller of the concave radius and the radius that another part of the face allows.

    A second derivative of z along any line is at most the curvature times (1 + slope²)^1.5. If none
    is above 1 / R, the face lies below each parabola of that second derivative that touches it, and
    a ball of radius R lies above these parabolas: it fits everywhere.
    """
    if math.isinf(concave.value) or concave.value == 0:
        return concave
    # Close pairs of points are covered by the curvature.
    value, place = blocked_radius(face.coarser(), concave.value) or (concave.value, concave.place)
    surely = concave.bound / (1 + bounds.slope**2) ** 1.5
    return Extreme(value, min(surely, value), place)


def _thicknesses(optic: Element, heights: Mapping[str, Array]) -> tuple[float, float]:
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
    """Mask of the parts, between ends in [0, 1], that overlap the outline of the lens."""
    x, y = ((2 * end - 1) * r for end, r in zip(ends, optic.half_width, strict=True))
    return outline_of(optic).area_inside((x[:-1, None], x[1:, None]), (y[:-1], y[1:])) > 0


def _most(maps: SurfaceMaps, values: Array, bound: float) -> Extreme:
    row, column = np.unravel_index(np.nanargmax(values), values.shape)
    place = float(maps.x[column]), float(maps.y[row])
    value = float(values[row, column])
    return Extreme(value, max(value, bound), place)  # by rounding the bound may be less


def _radius(curvature: Extreme, flat: float, has_edge: bool) -> Extreme:
    """Extreme of radii from the extreme of curvatures; less than ``flat`` counts as none."""
    if has_edge:
        return Extreme(0.0, 0.0, curvature.place)
    value, bound = (1 / c if c > flat else math.inf for c in (curvature.value, curvature.bound))
    return Extreme(value, bound, curvature.place)


def _edges(net: ControlNet, heights: Array) -> tuple[bool, bool]:
    """Whether the slope jumps up, and down, at the knots of degree 1."""
    jumps = [np.zeros(1)]
    for axis, values in ((0, heights), (1, heights.T)):
        if net.degree[axis] == 1:
            other = 1 - axis
            along = np.linspace(0, 1, 2 * _PARTS + 1)
            basis = basis_matrix(net.knots[other], net.degree[other], along)
            jumps.append(np.diff(values, n=2, axis=0) @ basis.T)
    rounding = _FLAT * float(np.ptp(heights))
    return any((j > rounding).any() for j in jumps), any((j < -rounding).any() for j in jumps)


def exceeded(maps: SurfaceMaps, limits: Limits) -> dict[str, Mask]:
    """Masks (n_y, n_x) of the places where a face exceeds each given limit, by figures."""
    least, most = limits.min_thickness, limits.max_thickness
    found: dict[str, Mask] = {}
    if least is not None or most is not None:
        below, above = least or -math.inf, math.inf if most is None else most
        found["thickness"] = (maps.thickness < below) | (maps.thickness > above)
    if limits.max_slope is not None:
        found["slope"] = maps.slope > limits.max_slope
    if limits.min_radius is not None:
        found["concave curvature"] = maps.concave > 1 / limits.min_radius
        found["convex curvature"] = maps.convex > 1 / limits.min_radius
    if limits.min_tool_radius is not None:
        blocked = blocked_places(maps.face, limits.min_tool_radius).T
        found["ball cutter"] = blocked | (maps.concave > 1 / limits.min_tool_radius)
    return found


def exceeding_points(
    optic: Element, surfaces: Mapping[str, Array], heights: Mapping[str, Array], limits: Limits
) -> dict[str, Mask]:
    """Masks (m_x, m_y) of the points of each freeform face where the lens exceeds a limit.

    ``surfaces`` are points (m_x, m_y, 3) by face, see `sample_faces`.
    """
    found = {}
    for face in freeform_nets(optic):
        points = surfaces[face]
        maps = surface_maps(optic, heights, points.shape[:2], face)
        masks = [np.zeros_like(maps.slope, dtype=bool), *exceeded(maps, limits).values()]
        row, column = (
            np.rint((points[..., k] - at[0]) / (at[-1] - at[0]) * (at.size - 1)).astype(int)
            for k, at in ((1, maps.y), (0, maps.x))
        )
        found[face] = np.any(masks, axis=0)[row, column]
    return found


class Verdict(NamedTuple):
    """Verdict on one limit."""

    name: str  # of the limited figure
    limit: float  # scene units or degrees
    at_least: bool  # whether it is a lower limit
    found: Extreme  # figure of the lens
    # "broken" if a sampled point exceeds the limit, "met" if the bound is within it, else "open".
    state: State

    def wanted(self, unit: str) -> str:
        """The limit in words."""
        return f"at {'least' if self.at_least else 'most'} {self.limit:g}{self.behind(unit)}"

    def behind(self, unit: str) -> str:
        """Unit of the figure, as it follows a number."""
        return "°" if "slope" in self.name else f" {unit}"


_Asked = tuple[str, float | None, bool, Extreme]  # name, limit, whether a lower one, figure


def verdicts(found: Manufacture, limits: Limits) -> list[Verdict]:
    """Compare a lens with all given limits."""
    asked: list[_Asked] = [
        ("thickness", limits.min_thickness, True, found.thinnest),
        ("thickness", limits.max_thickness, False, found.thickest),
        *_of_face(found, limits, ""),
    ]
    if found.entrance is not None:
        asked += _of_face(found.entrance, limits, "entrance ")
    return [
        Verdict(name, limit, at_least, extreme, _state(limit, at_least, extreme))
        for name, limit, at_least, extreme in asked
        if limit is not None
    ]


def _of_face(found: FaceFigures, limits: Limits, face: str) -> list[_Asked]:
    return [
        (f"{face}slope", limits.max_slope, False, found.steepest),
        (f"{face}concave radius", limits.min_radius, True, found.tightest_concave),
        (f"{face}convex radius", limits.min_radius, True, found.tightest_convex),
        (f"{face}ball cutter", limits.min_tool_radius, True, found.tool_radius),
    ]


def _state(limit: float, at_least: bool, found: Extreme) -> State:
    sign = 1 if at_least else -1

    def keeps(value: float) -> bool:
        return math.isinf(value) or sign * (value - limit) >= -_ROUNDING * abs(limit)

    if not keeps(found.value):
        return "broken"
    return "met" if keeps(found.bound) else "open"
