"""A B-spline over the entrance face, with the outline of the lens."""

import math

import numpy as np
from scipy.interpolate import BSpline

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.surfaces.spline_kernels import Spline, meet, surface
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet
from workbench.scene import Element

# Places on the rim, over the half-width, by rounding.
_RIM = 1 + 1e-9
_LEVEL = 1e-12  # sine of the angle to the plane z = const below which rays count as level
# How many places along a ray are looked at, at least and at most, whether it is back at the face,
# and how far behind the face it is then at least, over the half-width.
_LOOKS, _CLOSE = (32, 512), 1e-9


class SplineFace:
    """The exit face of a lens, lit from inside; a `TracedFace`.

    `control_points` (n_u, n_v): control heights, scene units; `missed`: see `TracedFace`; `net`:
    where the control points sit; the net of the face that the task shapes by default.
    """

    def __init__(
        self, optic: Element, control_points: Array, missed: str, net: ControlNet | None = None
    ) -> None:
        self.missed = missed
        net = net or ControlNet.of(optic)
        knots = [
            np.concatenate([np.full(p, -r), np.linspace(-r, r, n - p + 1), np.full(p, r)])
            for r, n, p in zip(net.half_width, net.shape, net.degree, strict=True)
        ]
        # A spline is never steeper than the steepest of its derivative's coefficients.
        steepest = []
        for axis, (t, p) in enumerate(zip(knots, net.degree, strict=True)):
            width = np.expand_dims(t[p + 1 : -1] - t[1 : -p - 1], 1 - axis)
            slopes = np.abs(np.diff(control_points, axis=axis)) * p / width
            steepest.append(float(slopes.max()))
        # Counted from a level of their own: of a lens that is thick for how much it bends light, a
        # height from the front has no digits left for its shape.
        middle = float(control_points.mean())
        heights = np.ascontiguousarray(control_points - middle, dtype=np.float64)
        self._level = middle - optic.front_z
        along_x, along_y = (_pieces(t, p) for t, p in zip(knots, net.degree, strict=True))
        r_x, r_y = optic.half_width
        self._spline = Spline(
            heights,
            along_x,
            along_y,
            r_x,
            r_y,
            density_x=len(along_x) / (2 * r_x),
            density_y=len(along_y) / (2 * r_y),
            lowest=float(heights.min()),
            highest=float(heights.max()),
            steepest_x=steepest[0],
            steepest_y=steepest[1],
            curved=not outline_of(optic).whole,
        )

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays that go upwards first meet it; see `TracedFace.meet`."""
        # Rays that do not meet it get the origin: memory as it comes might hold any number.
        position, normal = np.zeros_like(rays.position), np.zeros_like(rays.position)
        flux = np.empty_like(rays.flux)
        place = rays.position - [0.0, 0.0, self._level]
        meet(self._spline, place, rays.direction, rays.flux, position, normal, flux)
        position[:, 2] += np.where(flux > 0, self._level, 0.0)
        return Crossings(position, normal, flux)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """See `TracedFace.met_again`: places along each ray, two for each knot span up to a limit.

        Rays that go away from the face faster than it anywhere follows are not looked at.
        """
        spline = self._spline
        found = np.full((len(rays.flux), 2), np.nan)
        direction = np.broadcast_to(rays.direction, rays.position.shape)
        aside = np.abs(direction[:, :2])
        follows = aside @ [spline.steepest_x, spline.steepest_y]
        left = np.flatnonzero((rays.flux > 0) & (onwards * direction[:, 2] < follows))
        if not left.size:
            return found
        length = self._length_beside(rays.position[left], direction[left], onwards)
        spans = length * (aside[left] @ [spline.density_x, spline.density_y])
        looks = int(np.clip(2 * spans.max(), *_LOOKS))
        for part in np.arange(1, looks + 1) / looks:
            place = rays.position[left] + direction[left] * (length * part)[:, None]
            x, y, z = np.ascontiguousarray(place.T)
            height, _, _ = self.shape_at(x, y)
            back = onwards * (z - height) < -_CLOSE * max(spline.r_x, spline.r_y)
            found[left[back]] = place[back, :2]
            left, length = left[~back], length[~back]
        return found

    def shape_at(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height and slopes along x and y at places, all of shape (m,)."""
        z, slope_x, slope_y = np.empty((3, len(x)))
        surface(self._spline, x, y, z, slope_x, slope_y)
        return z + self._level, slope_x, slope_y

    @property
    def _lowest(self) -> float:
        """Height of the lowest control point."""
        return self._level + self._spline.lowest

    def _inside(self, found: Crossings) -> Crossings:
        """Crossings without those beside the outline."""
        return self._within(found, found.position)

    def _within(self, found: Crossings, place: Array) -> Crossings:
        """Crossings of rays of which some places (m, 2 or 3) are inside the outline."""
        flux = np.where(self._radius(place) <= _RIM, found.flux, 0.0)
        return found._replace(flux=flux)

    def _radius(self, place: Array) -> Array:
        """Parts of the way from the axis to the rim at places; of ellipses their squares."""
        across, up = np.abs(place[:, 0]) / self._spline.r_x, np.abs(place[:, 1]) / self._spline.r_y
        return np.asarray(across**2 + up**2 if self._spline.curved else np.maximum(across, up))

    def _length_beside(self, place: Array, way: Array, onwards: int) -> Array:
        """How far rays go from the face until they are beside it or beyond all of it."""
        far = self._level + (self._spline.highest if onwards > 0 else self._spline.lowest)
        with np.errstate(divide="ignore", invalid="ignore"):
            to_end = np.where(onwards * way[:, 2] > 0, (far - place[:, 2]) / way[:, 2], np.inf)
            half = np.array([self._spline.r_x, self._spline.r_y])
            scaled, slope = place[:, :2] / half, way[:, :2] / half
            if self._spline.curved:
                a, b = (slope**2).sum(axis=1), (scaled * slope).sum(axis=1)
                c = (1 - (scaled**2).sum(axis=1)).clip(min=0)
                to_rim = (np.sqrt(b * b + a * c) - b) / a
            else:
                to_rim = np.fmin(*((1 - np.sign(slope) * scaled).clip(min=0) / np.abs(slope)).T)
        return np.asarray(np.fmin(to_end, to_rim).clip(min=0))


class LaterFace(SplineFace):
    """The first face of an element behind others; a `TracedFace`."""

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays from far below first meet it; see `TracedFace.meet`."""
        up = rays.direction[:, 2:]
        up = np.where(up > _LEVEL, up, np.inf)  # level rays never come to the face
        ahead = (self._lowest - rays.position[:, 2:]).clip(min=0) / up
        with np.errstate(invalid="ignore"):  # lost rays may have no place
            begin = rays.position + ahead * rays.direction
        return self._inside(super().meet(rays._replace(position=begin)))


class FrontFace(SplineFace):
    """The face that light meets first, perhaps before the plane of the aperture; a `TracedFace`.

    Light of the source is what passes the outline in the plane z = 0: other rays miss the face.
    """

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays from far below first meet it; see `TracedFace.meet`."""
        way = rays.direction / rays.direction[:, 2:]
        back = (rays.position[:, 2:] - self._lowest).clip(min=0)
        # What comes in from beside, over the rim, meets no front.
        found = super().meet(rays._replace(position=rays.position - back * way))
        return self._inside(self._within(found, self._crossing(rays)))

    @staticmethod
    def _crossing(rays: TracedRays) -> Array:
        """Where rays cross the plane of the aperture, shape (m, 2)."""
        way, ahead = rays.direction[:, :2], rays.direction[:, 2:]
        slope = way / np.where(ahead > 0, ahead, np.inf)  # rays that go back meet no face
        return np.asarray(rays.position[:, :2] - rays.position[:, 2:] * slope)


def _pieces(knots: Array, degree: int) -> Array:
    """Basis functions as polynomials on each knot span, as in `Spline`: Taylor's, by scipy."""
    count = len(knots) - degree - 1
    spans = count - degree
    basis = BSpline(knots, np.eye(count), degree)
    begin, width = knots[degree:count], (knots[-1] - knots[0]) / spans
    span, of_span = np.arange(spans)[:, None], np.arange(degree + 1)[None, :]
    terms = [
        basis(begin, nu=power)[span, span + of_span] * (width**power / math.factorial(power))
        for power in range(degree, -1, -1)
    ]
    return np.ascontiguousarray(np.stack(terms, axis=-1))
