"""Light of a flat emitter."""

import math
from collections.abc import Iterator

import numpy as np

from workbench.analysis.tracing.elements import LightSource, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import (
    Cells,
    in_disc,
    in_square,
    near_places,
    pairs,
)
from workbench.arrays import Array
from workbench.geometry.reach import projected_solid_angle
from workbench.scene import AreaSource, Element

# Points that stand for the emitter at the first level of cells: their error is then like that of
# the cells. And those by which the light that meets the face is added up, along each axis.
_ORIGINS, _NODES = 64, 24


class AreaLight(LightSource):
    """Light of an emitter's face into the half-space before it; a `LightSource`.

    Each ray goes from a random place of the emitter to a random one of the rectangle of the
    entrance face, so none is wasted. They are as dense there as the light; see `near_places`. The
    parameters are those of `light_source`, and how often the points of `through` are doubled.
    """

    def __init__(
        self, source: AreaSource, optic: Element, pose: Pose, rays: int, seed: int, doubled: int = 0
    ) -> None:
        self._given = source, optic, pose, rays, seed
        self._source, self._lens, self._pose, self._seed = source, optic, pose, seed
        self._upwards, self._half_width = pose.axis(), optic.half_width
        middle = pose.to_lens(np.array([source.position]), optic.front_z)
        # From afar all points light the face alike: places by the middle are spread more evenly.
        self._middle = middle if -middle[0, 2] > max(source.half_width) else None
        self._lambertian = source.emission == "lambertian"
        self._cells = Cells(rays, optic.half_width[0] / optic.half_width[1], seed)
        self.rays, self.emitted = self._cells.count, 1.0
        self.origins = _ORIGINS << doubled
        self.places: Array = self._on_emitter(*self._even(self.origins))
        met = float(self._met().mean())
        self.beside = max(1 - met, 0.0) / met

    def finer(self, level: int) -> "AreaLight":
        """See `LightSource`."""
        return AreaLight(*self._given, doubled=level)

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin on the entrance face; see `RandomSource.batch`."""
        random = np.random.default_rng([self._seed, 300 + number])
        for a, b in self._cells.batch(number):
            points = self._on_emitter(*pairs(random, len(a)))
            foot = points if self._middle is None else self._middle
            x, y, area = near_places(a, b, foot, self._half_width)
            rays = self._between(points, x, y)
            yield rays._replace(flux=rays.flux * area)

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays through places of the entrance face; see `FaceLight.through`."""
        rays = self._between(self.places[origin : origin + 1], x, y)
        return rays._replace(flux=rays.flux / self.origins)

    def _even(self, count: int) -> tuple[Array, Array]:
        return in_disc(count) if self._source.outline == "ellipse" else in_square(count)

    def _on_emitter(self, a: Array, b: Array) -> Array:
        """Points (k, 3) as the lens sees them, for pairs that fill a square evenly."""
        x, y = 2 * a - 1, 2 * b - 1
        if self._source.outline == "ellipse":
            x, y = (np.sqrt(a) * turn(2 * math.pi * b) for turn in (np.cos, np.sin))
        r_x, r_y = self._source.half_width
        places = np.column_stack([r_x * x, r_y * y, np.zeros_like(x)]) + self._source.position
        return self._pose.to_lens(places, self._lens.front_z)

    def _between(self, points: Array, x: Array, y: Array) -> TracedRays:
        """Rays from points to places of the face, with their flux per area of it."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        way = position - points
        distance = np.linalg.norm(way, axis=1)
        way /= distance[:, None]
        ahead = (way @ self._upwards).clip(min=0)
        intensity = ahead / math.pi if self._lambertian else (ahead > 0) / (2 * math.pi)
        return TracedRays(position, way, intensity * way[:, 2].clip(min=0) / distance**2)

    def _met(self) -> Array:
        """Part of the light of many points that meets the face: in closed form for each."""
        points = self._on_emitter(*self._even(_NODES**2))
        r_x, r_y = self._half_width
        corners = np.array([[-r_x, -r_y, 0], [r_x, -r_y, 0], [r_x, r_y, 0], [-r_x, r_y, 0.0]])
        if self._lambertian:
            return projected_solid_angle(corners, points, self._upwards) / math.pi
        unit = corners - points[:, None]
        unit /= np.linalg.norm(unit, axis=2, keepdims=True)
        halves = [_solid_angle(unit[:, [0, k, k + 1]]) for k in (1, 2)]
        return np.asarray(sum(halves) / (2 * math.pi))


def _solid_angle(unit: Array) -> Array:
    """Of triangles seen along unit vectors, shape (k, 3, 3) (Van Oosterom and Strackee 1983)."""
    a, b, c = np.moveaxis(unit, 1, 0)
    volume = np.abs((a * np.cross(b, c)).sum(axis=1))
    around = 1 + (a * b).sum(axis=1) + (b * c).sum(axis=1) + (c * a).sum(axis=1)
    return np.asarray(2 * np.arctan2(volume, around))
