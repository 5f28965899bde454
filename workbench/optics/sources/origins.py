"""Origins of light, points or directions: where they lie, and what each sends to the first face."""

import math
from collections.abc import Hashable, Sequence
from functools import lru_cache
from typing import Literal, NamedTuple, Protocol

import numpy as np
import torch

from workbench.arrays import Array, Index
from workbench.geometry.outlines import outline_named, outline_of
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.samples import Samples, parts_inside, places_of_points
from workbench.scene import Element

Outline = Literal["rectangle", "ellipse"]

_GOLDEN = (math.sqrt(5) - 1) / 2
# Along each axis of a quarter: what is nearest to a place is counted by as many.
_FINE = 100
_ROUNDS = 30


class SpreadPlaces(NamedTuple):
    """Places within −1 and 1 along x and y, of a rectangle or of the ellipse in it."""

    # (k,), the places.
    x: Array
    y: Array
    share: Array  # (k,), part of the area that each stands for; all together 1


@lru_cache(maxsize=16)
def spread(count: int, outline: Outline, aspect: float = 1.0) -> SpreadPlaces:
    """Places that fill an outline evenly; its own mirror image in x and in y.

    `count`: how many; rounded up to a multiple of 4, except that 1 is the middle alone; `outline`:
    what is filled; `aspect`: width over height of it.

    Notes
    -----
    Lloyd's method on a quarter: each place moves to the middle of all that is nearest to it, and
    its share is that area, so that what is linear between places is summed up without an error.
    Error of a photograph of 256 × 256 pixels that is blurred by a disc, relative to its own norm:

    ======  =========  =========  =========  =========  =========
    places  blur 3 px  blur 6 px  12 px      24 px      sunflower, 12 px
    ======  =========  =========  =========  =========  =========
    16      0.13 %     0.27 %     1.05 %     1.90 %     1.34 %
    32      0.06 %     0.13 %     0.42 %     1.00 %     0.60 %
    64      0.03 %     0.05 %     0.12 %     0.46 %     0.27 %
    128     0.02 %     0.03 %     0.04 %     0.19 %     0.12 %
    256     0.01 %     0.01 %     0.02 %     0.04 %     0.06 %
    ======  =========  =========  =========  =========  =========

    Low-discrepancy sets that are mapped on the disc are two to ten times worse: they crowd at
    its rim or in its middle.
    """
    if count == 1:
        return SpreadPlaces(np.zeros(1), np.zeros(1), np.ones(1))
    few = -(-count // 4)
    x, y, share = _quarter(few, outline, aspect)
    # Place k from the end is the mirror image in y of place k, as in `interleaving`.
    x, share = np.concatenate([x, -x]), np.concatenate([share, share]) / 4
    y = np.concatenate([y, y])
    return SpreadPlaces(
        np.concatenate([x, x[::-1]]),
        np.concatenate([y, -y[::-1]]),
        np.concatenate([share, share[::-1]]),
    )


def at_corners(cells: tuple[int, int], outline: Outline) -> SpreadPlaces:
    """Corners of a grid of cells that fills an outline; its own mirror image in x and in y.

    `cells`: cells along x and y; corners come row by row; `outline`: what is filled; lines of an
    ellipse's grid are arcs.
    """
    (u, w_u), (v, w_v) = (_trapezoids(count) for count in cells)
    filled = outline_named(outline, (1.0, 1.0))
    u, v = (part.ravel() for part in np.meshgrid(u, v))
    x, y = filled.from_square(u, v)
    share = filled.stretch(u, v) * np.outer(w_v, w_u).ravel()
    return SpreadPlaces(x, y, share / share.sum())


def _trapezoids(cells: int) -> tuple[Array, Array]:
    """Corners from −1 to 1 of so many cells in a row, and what each stands for."""
    weight = np.ones(cells + 1)
    weight[[0, -1]] = 0.5
    return (2 * np.arange(cells + 1) - cells) / cells, weight


def filling(a: Array, b: Array, outline: Outline) -> tuple[Array, Array]:
    """Places (x, y) within −1 and 1 for places of the unit square, as even as these."""
    if outline == "rectangle":
        return 2 * a - 1, 2 * b - 1
    radius, angle = np.sqrt(a), 2 * math.pi * b
    return radius * np.cos(angle), radius * np.sin(angle)


def _quarter(count: int, outline: Outline, aspect: float) -> tuple[Array, Array, Array]:
    """Places with x, y > 0 and their shares of the quarter."""
    from scipy.spatial import cKDTree  # late: it takes long to import

    # As wide as its aspect, or places would be nearer along one axis than along the other.
    size = np.array([math.sqrt(aspect), 1 / math.sqrt(aspect)])
    middle = (np.arange(_FINE) + 0.5) / _FINE
    all_of_it = np.stack(np.meshgrid(middle, middle), axis=-1).reshape(-1, 2)
    number = np.arange(count)
    a, b = (number + 0.5) / count, (_GOLDEN * number + 0.5) % 1
    if outline == "ellipse":
        all_of_it = all_of_it[np.square(all_of_it).sum(axis=1) < 1]
        a, b = np.sqrt(a) * np.cos(math.pi / 2 * b), np.sqrt(a) * np.sin(math.pi / 2 * b)
    all_of_it, places = all_of_it * size, np.column_stack([a, b]) * size
    for _ in range(_ROUNDS):
        nearest = cKDTree(places).query(all_of_it)[1]
        areas = np.bincount(nearest, minlength=count)
        sums = [np.bincount(nearest, part, count) for part in all_of_it.T]
        # Of a slim source, places may have nothing near them: they stay, and have no share.
        filled = areas[:, None] > 0
        places = np.where(filled, np.column_stack(sums) / np.maximum(areas, 1)[:, None], places)
    x, y = (places / size).T
    return x, y, areas / len(all_of_it)


class EnteringLight(NamedTuple):
    """Light at places of the entrance face; arrays of one shape."""

    direction: tuple[Array, Array, Array]  # unit vectors
    density: Array  # flux per area of the face


class Pattern(Hashable, Protocol):
    """How the intensity of points depends on direction."""

    def at(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """Intensity in any unit, which `Origins.flux` goes with.

        Parameters
        ----------
        origin : ndarray of int
            Of which point.
        direction : tuple of three ndarray
            Unit vectors, with which the points broadcast.
        """
        ...


class TurnedPattern(NamedTuple):
    """Light of faces that are turned away from +z; a `Pattern`."""

    facing: tuple[float, ...]  # (3,), unit vector across the face, to the side that shines
    # Whether intensity falls with the cosine to it; else it is even before the face.
    lambertian: bool

    def at(self, origin: Index, direction: tuple[Array, Array, Array]) -> Array:
        """See `Pattern`."""
        x, y, z = self.facing
        ahead = x * direction[0] + y * direction[1] + z * direction[2]
        return np.asarray(ahead.clip(min=0) if self.lambertian else (ahead > 0) * 1.0)


class EmittedLight(NamedTuple):
    """All light of one point, as the flux into directions."""

    direction: Array  # (n, 3), unit vectors
    flux: Array  # (n,), flux into each; together 1

    def onto(self, z: float) -> tuple["EmittedLight", Array, Array]:
        """The light that goes to +z; x and y, from those of the point, at a distance z."""
        lit = EmittedLight(*(part[self.direction[:, 2] > 0] for part in self))
        x, y, ahead = lit.direction.T
        return lit, z * x / ahead, z * y / ahead


class Origins(NamedTuple):
    """Where the light of a source comes from, k places with their flux."""

    # (k, 3), points, scene units; or, where infinite, unit vectors in which the light goes.
    places: Array
    infinite: bool  # whether the light of each origin is parallel
    # (k,), of points, flux per solid angle straight ahead, to +z. Of directions, flux per area of a
    # plane across the direction, in the middle of the beam. All light of the source together, what
    # misses the lens included, is 1.
    flux: Array
    # Of points: whether intensity falls with the cosine to +z; else it is even.
    lambertian: bool = False
    # Of directions: 1/e² radius of the flux per area about the line through the middle of the
    # entrance face; infinite for even light.
    waist: float = math.inf
    # Of points: intensity by direction; flux per solid angle is ``flux`` times that.
    pattern: Pattern | None = None
    # How far they are from what they stand for, in words; empty where they are exact.
    note: str = ""
    emitted: EmittedLight | None = None  # all light of a single point, where a table says it

    def light(self, x: Array, y: Array, z: float, origin: Index) -> EnteringLight:
        """Light of origins at places of the entrance face.

        `x`, `y`: places, scene units; `z`: where the face is; `origin`: from which origin the light
        comes there; all three broadcast against each other.

        Examples
        --------
        Two points one above the other, seen from the middle of the face:

        >>> import numpy as np
        >>> pair = Origins(np.array([[0.0, -3, -4], [0, 0, -4]]), False, np.array([1.0, 1]))
        >>> pair.light(np.zeros(1), np.zeros(1), 0.0, np.array([0, 1])).density
        array([0.032 , 0.0625])
        """
        place = self.places[origin]
        if self.infinite:
            d_x, d_y, d_z = np.moveaxis(place, -1, 0)
            beside2 = np.square(x) + np.square(y) - np.square(x * d_x + y * d_y)
            density = self.flux[origin] * d_z * np.exp(-2 * beside2 / self.waist**2)
            return EnteringLight(_alike(d_x, d_y, d_z, density), density)
        away = np.broadcast_arrays(x - place[..., 0], y - place[..., 1], z - place[..., 2])
        distance = np.sqrt(np.square(away).sum(axis=0))
        d_x, d_y, d_z = (part / distance for part in away)
        density = self.flux[origin] * d_z / distance**2
        if self.pattern is not None:
            density = density * self.pattern.at(origin, (d_x, d_y, d_z))
        return EnteringLight((d_x, d_y, d_z), density * d_z if self.lambertian else density)

    def density(self, x: Array, y: Array, z: float) -> Array:
        """Flux per area of all origins together at places of the face; see `light`."""
        count = len(self.places)
        return sum((self.light(x, y, z, np.array(k)).density for k in range(count)), np.zeros(1))

    def middle(self, x: Array, y: Array, z: float) -> Array:
        """Mean of the places, weighed with the light of each at places of the face; see `light`."""
        count = len(self.places)
        light = [self.light(x, y, z, np.array(k)).density.sum() for k in range(count)]
        return np.average(self.places, axis=0, weights=light if any(light) else None)


def through_cells(origins: Origins, optic: Element, samples: Samples) -> RayBundle:
    """Rays through cells of the entrance face, shape (m_x, m_y for each origin).

    Several origins need `Corners`. The flux is that of what of the cells is inside the outline of
    the lens.
    """
    count = len(origins.places)
    across, up = (places_of_points(samples, axis, n) for axis, n in enumerate((1, count)))
    r_x, r_y = optic.half_width
    x, y = ((2 * along.part - 1) * r for along, r in ((across, r_x), (up, r_y)))
    area = 4 * r_x * r_y * (across.high - across.low)[:, None] * (up.high - up.low)
    area *= parts_inside(outline_of(optic), across, up)
    origin = np.repeat(np.arange(count), len(up.part) // count)
    lit = origins.light(x[:, None], y, optic.front_z, origin)
    place = np.broadcast_arrays(x[:, None], y, np.full(area.shape, optic.front_z))
    alive = torch.ones(area.shape, dtype=torch.bool)
    return RayBundle(
        vector(place), vector(lit.direction), torch.as_tensor(lit.density * area), alive
    )


def bulk_of(place: Array, flux: Array, beyond: float) -> tuple[float, float]:
    """Places between which the flux is, but for a part ``beyond`` each of them."""
    order = np.argsort(place)
    sums = np.cumsum(flux[order])
    low, high = np.searchsorted(sums, sums[-1] * np.array([beyond, 1 - beyond]))
    return float(place[order[low]]), float(place[order[min(high, len(place) - 1)]])


def vector(parts: Sequence[Array]) -> Vector:
    """Arrays as tensors with memory of their own."""
    x, y, z = (torch.as_tensor(np.array(part)) for part in parts)
    return x, y, z


def _alike(d_x: Array, d_y: Array, d_z: Array, other: Array) -> tuple[Array, Array, Array]:
    x, y, z = (np.broadcast_to(part, other.shape) for part in (d_x, d_y, d_z))
    return x, y, z
