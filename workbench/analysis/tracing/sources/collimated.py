"""Parallel light, and light from a disc of directions, even or a Gaussian beam."""

import math
from collections.abc import Iterator

import numpy as np
from scipy.special import ndtr, ndtri

from workbench.analysis.tracing.elements import LightSource, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import Cells, in_disc, pairs
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.scene import CollimatedSource, Element


class CollimatedLight(LightSource):
    """Parallel light; a `LightSource`.

    It has no edge: it fills the entrance face however that stands. The parameters are those of
    `light_source`.
    """

    def __init__(
        self, source: CollimatedSource, optic: Element, pose: Pose, rays: int, seed: int
    ) -> None:
        r_x, r_y = optic.half_width
        self._outline = outline_of(optic)
        self._direction = pose.ways(source.directions(np.zeros(1), np.zeros(1)))
        self._cells = Cells(rays, r_x / r_y, seed)
        self.rays = self._cells.count
        # Of the rectangle around the lens, all is lit, and rays are drawn on the glass alone.
        self.origins, self.emitted = 1, 4 * r_x * r_y
        self.beside = self.emitted / self._outline.area - 1

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin on the entrance face; see `RandomSource.batch`."""
        for a, b in self._cells.batch(number):
            position = np.zeros((len(a), 3))
            position[:, 0], position[:, 1] = self._outline.evenly(a, b)
            yield TracedRays(position, self._direction, np.ones(len(a)))

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays through places of the entrance face; see `FaceLight.through`."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        return TracedRays(position, self._direction, np.ones_like(x))


# Directions that stand for the disc at the first level of cells.
_ORIGINS = 32
# Less of a beam than this on the face is none.
_DARK = 1e-12
# Beyond so many radii there is no light of a beam.
_FAR = 4.0
_NODE, _WEIGHT = np.polynomial.legendre.leggauss(12)
# Rings of the disc, and places on each, by which the flux of a beam is added up.
_RING, _RING_WEIGHT = np.polynomial.legendre.leggauss(6)
_TURNS = 8


class BeamLight(LightSource):
    """Light of all directions in a cone; a `LightSource`.

    Even light has no edge: it fills the entrance face however that stands. A Gaussian beam goes
    through the middle of where the face belongs. The parameters are those of `light_source`, and
    the places of the directions of `through` on the disc; see `LightSource.on_disc`.
    """

    def __init__(
        self,
        source: CollimatedSource,
        optic: Element,
        pose: Pose,
        rays: int,
        seed: int,
        disc: tuple[Array, Array] | None = None,
    ) -> None:
        self._given = source, optic, pose, rays, seed
        self._seed, self._half_width = seed, optic.half_width
        self._waist, self._angle = source.profile.radius, math.radians(source.angular_diameter) / 2
        frame = Pose(tilt=(math.radians(source.direction[0]), math.radians(source.direction[1])))
        # Columns: where the disc's right, its upper side and its middle point, as the lens sees it.
        self._frame = pose.ways(frame.to_scene(0.0)[0].T).T
        self._middle = pose.to_lens(np.array([[*pose.beam, optic.front_z]]), optic.front_z)[0]
        self._cells = Cells(rays, optic.half_width[0] / optic.half_width[1], seed)
        self.rays = self._cells.count
        part, turn = disc or in_disc(_ORIGINS if self._angle else 1)
        self.origins, self._ways = len(part), self._towards(part, turn)
        if math.isinf(self._waist):
            self.beside = 0.0
            # The mean of all directions of the disc, which points to its middle, is a little short.
            facing = math.cos(self._angle / 2) ** 2 * float(self._frame[2, 2])
            self.emitted = 4 * math.prod(self._half_width) * facing
        else:
            met = self._met()
            self.beside, self.emitted = max(1 - met, 0.0) / max(met, _DARK), 1.0

    def finer(self, level: int) -> "BeamLight":
        """See `LightSource`."""
        return self._with(*in_disc(_ORIGINS << level)) if self._angle else self

    def on_disc(self, part: Array, turn: Array) -> "BeamLight | None":
        """See `LightSource.on_disc`."""
        return self._with(part, turn) if self._angle else None

    def _with(self, part: Array, turn: Array) -> "BeamLight":
        return BeamLight(*self._given, disc=(part, turn))

    def batch(self, number: int) -> Iterator[TracedRays]:
        """Rays that begin on the entrance face; see `RandomSource.batch`."""
        random = np.random.default_rng([self._seed, 200 + number])
        for a, b in self._cells.batch(number):
            (x, by_x), (y, by_y) = (self._places(part, axis) for axis, part in enumerate((a, b)))
            ways = self._towards(*pairs(random, len(a))) if self._angle else self._ways
            position = np.column_stack([x, y, np.zeros_like(x)])
            yield TracedRays(position, ways, self._density(position, ways) * by_x * by_y)

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays through places of the entrance face; see `FaceLight.through`."""
        position = np.column_stack([x, y, np.zeros_like(x)])
        ways = self._ways[origin : origin + 1]
        return TracedRays(position, ways, self._density(position, ways) / self.origins)

    def _towards(self, part: Array, turn: Array) -> Array:
        """Unit vectors (k, 3) as the lens sees them: even in solid angle for an even ``part``."""
        versine = 2 * math.sin(self._angle / 2) ** 2 * part
        sine = np.sqrt(versine * (2 - versine))
        angle = 2 * math.pi * turn
        local = np.column_stack([sine * np.cos(angle), sine * np.sin(angle), 1 - versine])
        return np.asarray(local @ self._frame.T)

    def _density(self, position: Array, ways: Array) -> Array:
        """Flux per area of the face at places (m, 3), for light of one direction or one each."""
        facing = ways[:, 2].clip(min=0)
        if math.isinf(self._waist):
            return np.broadcast_to(facing, len(position)).copy()
        away = position - self._middle
        along = (away * ways).sum(axis=1)
        beside2 = np.square(away).sum(axis=1) - along**2
        peak = 2 / (math.pi * self._waist**2)
        return np.asarray(peak * facing * np.exp(-2 * beside2 / self._waist**2))

    def _places(self, part: Array, axis: int) -> tuple[Array, Array]:
        """Places along an axis for even parts in [0, 1], and the length that each stands for.

        Where the light is that of a beam, they are as dense as its widest shadow on the face.
        """
        r = self._half_width[axis]
        if math.isinf(self._waist):
            return (2 * part - 1) * r, np.ones_like(part)
        middle, wide = self._middle[axis], self._widest / 2
        low, high = ndtr((-r - middle) / wide), ndtr((r - middle) / wide)
        if high - low < 1e-9:  # the beam is far beside the lens
            return (2 * part - 1) * r, np.full_like(part, 2 * r)
        t = ndtri(low + (high - low) * part)
        density = np.exp(-(t**2) / 2) / (math.sqrt(2 * math.pi) * wide * (high - low))
        return (middle + wide * t).clip(-r, r), 1 / density

    @property
    def _widest(self) -> float:
        """Radius of the largest shadow of the beam on the plane of the face."""
        steepest = math.acos(min(float(self._frame[2, 2]), 1.0)) + self._angle
        return self._waist / max(math.cos(steepest), 0.05)

    def _met(self) -> float:
        """Part of a beam's light that meets the face, by Gauss's rule."""
        (x, along), (y, up) = (self._nodes(axis) for axis in (0, 1))
        position = np.stack(np.broadcast_arrays(x[:, None], y, 0.0), axis=-1).reshape(-1, 3)
        area = np.outer(along, up).ravel()
        part, turn = np.repeat((_RING + 1) / 2, _TURNS), np.tile(np.arange(_TURNS) / _TURNS, 6)
        ways, weight = self._towards(part, turn), np.repeat(_RING_WEIGHT, _TURNS)
        if not self._angle:
            ways, weight = self._ways, np.ones(1)
        found = [float(self._density(position, way[None]) @ area) for way in ways]
        return float(np.average(found, weights=weight))

    def _nodes(self, axis: int) -> tuple[Array, Array]:
        """Places and lengths along an axis that add up what a beam has on the face."""
        r, middle, far = self._half_width[axis], self._middle[axis], _FAR * self._widest
        low, high = np.clip([middle - far, middle + far], -r, r)
        panels = max(math.ceil((high - low) / self._waist), 1)
        width = (high - low) / panels
        start = low + width * np.arange(panels)
        place = start[:, None] + width * (_NODE + 1) / 2
        return place.ravel(), np.tile(width * _WEIGHT / 2, panels)
