"""Which places of an aperture rays go through, if these make a tensor grid."""

import math
from typing import NamedTuple, Self

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.geometry.outlines import Outline

# Cells beside a ray that differ in width by less than twice this part count as equal.
_EVEN = 1e-6
# Beyond a crowd, places go with this power of even ones: of these, two thirds are within.
_POWER, _CORE = 15, 2 / 3
# Points at less than so many half-widths are near: even cells before them would be too large.
_NEAR = 0.25


class Crowd(NamedTuple):
    """Where corners of cells lie along an axis: evenly in a part of it, and fewer beyond."""

    middle: float = 0.0  # of that part, half-widths from the middle of the aperture
    half: float = 1.0  # its half, half-widths; 1 where corners are even all the way
    # Whether they become fewer as the light of a point does, in proportion to the distance; else
    # there are hardly any beyond.
    fading: bool = False

    @classmethod
    def of(cls, half: float, middle: float) -> Self:
        """A crowd that reaches so far about its middle; even where that is beyond the aperture."""
        wider = half / _CORE
        return cls(middle, wider) if wider + abs(middle) < 1 else cls()

    @classmethod
    def about(cls, half: float, middle: float) -> Self:
        """A crowd about the foot of a point that is so far away; even where that is not near."""
        return cls(middle, half, fading=True) if half < _NEAR else cls()

    def __call__(self, part: Array) -> Array:
        """Places for even parts of the way from one side of the aperture to the other."""
        if self.half == 1:
            return part
        even = 2 * part - 1
        if self.fading:
            low, high = (math.asinh((end - self.middle) / self.half) for end in (-1, 1))
            away = np.sinh((low + high) / 2 + (high - low) / 2 * even)
            return np.asarray((1 + self.middle + self.half * away) / 2).clip(0, 1)
        beyond = 1 - self.half - self.middle * np.sign(even)
        place = self.middle + even * (self.half + beyond * even ** (_POWER - 1))
        return np.asarray((1 + place) / 2)


EVERYWHERE = Crowd()


class Corners(NamedTuple):
    """One ray at each corner of cells along x and y; see `workbench.optics.images.beams`."""

    # Cells.
    x: int
    y: int
    # From how many origins light comes through them, where the source leaves that open.
    origins: int = 1
    # Cells along x and y of a source of some size, at whose corners these origins lie; all see the
    # same corners of the aperture. 0 where origins lie elsewhere. See
    # `workbench.optics.images.source_beams`.
    source_x: int = 0
    source_y: int = 0
    # Where the corners lie along x and y.
    crowd_x: Crowd = EVERYWHERE
    crowd_y: Crowd = EVERYWHERE

    @classmethod
    def and_of_source(cls, x: int, y: int, of_source: tuple[int, int]) -> Self:
        """Corners of cells of the aperture, and of the source."""
        return cls(x, y, math.prod(cells + 1 for cells in of_source), *of_source)

    @property
    def crowds(self) -> tuple[Crowd, Crowd]:
        """Where the corners lie along x and y."""
        return self.crowd_x, self.crowd_y

    @property
    def even(self) -> bool:
        """Whether all cells are alike."""
        return self.crowds == (EVERYWHERE, EVERYWHERE)

    @property
    def of_source(self) -> tuple[int, int] | None:
        """Cells of the source along x and y; None where origins lie elsewhere."""
        return (self.source_x, self.source_y) if self.source_x else None


Samples = tuple[int, int] | Corners
"""So many rays along x and y, each in the middle of a cell; or rays at the corners of cells."""


class Places(NamedTuple):
    """Places along one axis, as parts of the way from one side of the aperture to the other."""

    part: Array  # (m,), where the rays are
    # (m,), ends of what each ray stands for; together they fill the aperture.
    low: Array
    high: Array

    @property
    def split(self) -> Array:
        """Parts of what each ray stands for that lie before and behind it; and 1 where they equal.

        An array of shape (m, 3).
        """
        behind = (self.high - self.part) / (self.high - self.low)
        return np.stack([1 - behind, behind, np.abs(behind - 0.5) < _EVEN], axis=1)


def counts(samples: Samples) -> tuple[int, int]:
    """Cells along x and y."""
    return samples[0], samples[1]


def cells(samples: Samples) -> int:
    """Number of cells that rays stand for."""
    return samples[0] * samples[1]


def shares(samples: Samples, axis: int) -> Array:
    """Which part of a cell each ray stands for along x (0) or y (1): those at the rim for half."""
    if not isinstance(samples, Corners):
        return np.ones(counts(samples)[axis])
    share = np.ones(counts(samples)[axis] + 1)
    share[0] = share[-1] = 0.5
    return share


def places(samples: Samples, axis: int) -> Places:
    """Places of samples along x (0) or y (1)."""
    count = counts(samples)[axis]
    if isinstance(samples, Corners):
        return _between(np.arange(count + 1) / count, samples.crowds[axis])
    cell = np.arange(count)
    return Places((cell + 0.5) / count, cell / count, (cell + 1) / count)


def places_of_points(samples: Samples, axis: int, points: int) -> Places:
    """Places of the corners of each point, one point after the other.

    All points but a single one have grids that are shifted against each other, with narrower cells
    at both ends: what lies between the corners of one lies at those of others. Only where beams run
    between the points all have the same.
    """
    if points == 1:
        return places(samples, axis)
    if isinstance(samples, Corners) and samples.of_source is not None:
        return Places(*(np.tile(part, points) for part in places(samples, axis)))
    count = counts(samples)[axis]
    each = []
    for shift in (interleaving(points) + 0.5) / points:
        inner = (np.arange(count) + shift) / count
        part = np.concatenate([[0.0], inner, [1.0]])
        each.append(_between(part, samples.crowds[axis] if isinstance(samples, Corners) else None))
    return Places(*(np.concatenate(parts) for parts in zip(*each, strict=True)))


def parts_inside(outline: Outline, across: Places, up: Places) -> Array:
    """Which part of what each ray stands for is inside an outline, by area; shape (m_x, m_y).

    Exactly 1 or 0 where the outline does not cut it.
    """
    r_x, r_y = outline.half_width
    (left, right), (low, high) = (
        tuple((2 * end - 1) * r for end in (along.low, along.high))
        for along, r in ((across, r_x), (up, r_y))
    )
    inside = outline.area_inside((left[:, None], right[:, None]), (low, high))
    return np.asarray(inside / ((right - left)[:, None] * (high - low)))


def areas_of(outline: Outline, across: Places, up: Places) -> Array:
    """Area inside an outline of what each ray stands for, as seen along the axis; (m_x, m_y)."""
    (r_x, r_y), inside = outline.half_width, parts_inside(outline, across, up)
    wide, high = across.high - across.low, up.high - up.low
    return np.asarray(4 * r_x * r_y * wide[:, None] * high * inside)


def splits_side_by_side(across: Places, up: Places, origins: int) -> tuple[Array, Array]:
    """Splits of rays that all origins share, one origin after the other along y."""
    return across.split, np.tile(up.split, (origins, 1))


def interleaving(points: int) -> npt.NDArray[np.int64]:
    """Order in which points take turns: mirror-symmetric, and without a trend.

    If the points came one after the other, those on the right would always sample the right part
    of each cell, which shifts the light. Steps of a fixed stride mix them.
    """
    turn = np.arange(points)
    best, least = turn, np.inf
    for stride in range(1, points):
        if math.gcd(stride, points) > 1:
            continue
        # Point m − 1 − k comes at turn m − 1 − j where point k comes at turn j.
        start = (stride - 1 if stride % 2 else stride - 1 + points) // 2
        order = (stride * turn + start) % points
        trend = abs(float((turn - turn.mean()) @ (order - order.mean())))
        # Short strides leave long runs.
        trend += points**2 * (min(stride, points - stride) < math.isqrt(points) - 1)
        if trend < least:
            best, least = order, trend
    return best


def _between(part: Array, crowd: Crowd | None) -> Places:
    """Rays at corners stand for the halves of the cells on both sides.

    Halves of what becomes a crowd: the sum over corners of a crowd about a point then errs by a
    quarter of what it does with middles between the corners.
    """
    crowd = crowd or EVERYWHERE
    middle = crowd((part[1:] + part[:-1]) / 2)
    part = crowd(part)
    return Places(part, np.append(part[:1], middle), np.append(middle, part[-1:]))
