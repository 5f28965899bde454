"""Raster paths of a ball cutter that do not gouge the face, and the material they leave.

The tip of a ball of radius R above (x₀, y₀) may go down to the largest z + √(R² − r²) − R of all
points of the face at a lateral distance r: the offset surface. That is also a sweep of balls seen
from below: balls of this radius around all points of the face, turned over. So `BallSweep` computes
both the tips and the material that the cutter leaves.

A ball of radius R that touches the face at P from outside, with the unit normal n, holds no other
point Q of it if R ≤ |Q − P|² / (2 n·(Q − P)) for each Q above the tangent plane (Federer, Curvature
Measures, 1959, theorem 4.18). Then the offset surface at R does not fold, either. With Q close to P
the right side becomes the radius of curvature of the concave face; other pairs are checked one by
one.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Self

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array, Mask
from workbench.errors import Refused
from workbench.geometry.ball_kernels import Pieces, touching
from workbench.geometry.ball_sweep import BallSweep
from workbench.geometry.basis import local_basis, sparse_basis
from workbench.geometry.curvature import local_shape
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.progress import Steps, check_given_up

# Pairs are checked up to this many grid steps apart, then on a grid of twice the step: positions of
# a pair are exact to a sixth of their distance or better.
_WINDOW = 12
_IN_SPAN = 4  # lattice steps in each knot span; the search for contact points starts from these
_PARTS = 256  # least parts of each axis, at whose ends the face is evaluated
_SAMPLES = 100_000  # points where cut and face are compared
_RIM = 4_000  # further points on the rim
_AT_ONCE = 20_000
_HIGHER = 1.1  # factor on the scallop height until there are few enough moves
# Radius of the default cutter over the least concave radius: the number of moves is proportional to
# 1 / (R (1 − κ R)), see `CutFace._counts`, which is least here.
_FITTING = 0.5
_TIGHTEST = 0.1  # least 1 − κ R for which lines are planned
_LARGEST = 0.5  # radius of the default cutter over the half-width


class GridFace(NamedTuple):
    """A face on a regular grid (m_x, m_y), seen from outside; concave areas bend towards +z.

    Height and slopes are NaN outside the outline.
    """

    x: Array
    y: Array
    height: Array
    slope_x: Array
    slope_y: Array

    def coarser(self) -> "GridFace":
        """Every second point along both axes."""
        fields = (each[::2, ::2] for each in self[2:])
        return GridFace(self.x[::2], self.y[::2], *fields)


def blocked_radius(face: GridFace, radius: float) -> tuple[float, tuple[float, float]] | None:
    """Return the largest ball that no other part of a face blocks, and where it touches.

    ``radius`` is the largest ball by curvature alone, scene units; None if that ball fits.
    """
    found = None
    above = _above(face)
    finest = True
    while min(face.height.shape) > 1:
        for i, j in _offsets(face.height.shape, finest):
            check_given_up()
            if not _may_block(face, i, j, radius * above):
                continue
            for (rows, columns), curved in _pairs(face, i, j):
                if (curved > 1 / radius).any():
                    row, column = divmod(int(np.nanargmax(curved)), curved.shape[1])
                    radius = 1 / float(curved[row, column])
                    found = radius, (float(face.x[rows][row]), float(face.y[columns][column]))
        if max(face.height.shape) <= _WINDOW:
            break
        face, finest = face.coarser(), False
    return found


def blocked_places(face: GridFace, radius: float) -> Mask:
    """Mask (m_x, m_y) of the places where another part of a face blocks a ball of this radius."""
    return _blocked_places(face, radius, _above(face), finest=True)


def _blocked_places(face: GridFace, radius: float, above: float, *, finest: bool) -> Mask:
    blocked: Mask = np.zeros(face.height.shape, dtype=bool)
    for i, j in _offsets(blocked.shape, finest):
        if _may_block(face, i, j, radius * above):
            for (rows, columns), curved in _pairs(face, i, j):
                blocked[rows, columns] |= curved > 1 / radius
    if max(blocked.shape) > _WINDOW and min(blocked.shape) > 2:
        further = _blocked_places(face.coarser(), radius, above, finest=False)
        twice = np.kron(further, np.ones((2, 2), dtype=bool))
        blocked |= twice[: blocked.shape[0], : blocked.shape[1]]
    return blocked


def _above(face: GridFace) -> float:
    """Sine of the largest angle between the line to another point and the tangent plane."""
    steepest = math.atan(float(np.nanmax(np.hypot(face.slope_x, face.slope_y))))
    return math.sin(min(2 * steepest, math.pi / 2))


def _may_block(face: GridFace, i: int, j: int, raised: float) -> bool:
    """Whether points so many steps apart are near enough to block a ball."""
    apart = math.hypot(i * (face.x[1] - face.x[0]), j * (face.y[1] - face.y[0]))
    return apart < 2 * raised


def _offsets(shape: tuple[int, ...], finest: bool) -> Iterator[tuple[int, int]]:
    across, up = (min(_WINDOW, n - 1) for n in shape)
    for i in range(across + 1):
        for j in range(-up if i else 1, up + 1):
            # The finer grid covered closer pairs.
            if finest or max(i, abs(j)) > _WINDOW // 2:
                yield i, j


def _pairs(face: GridFace, i: int, j: int) -> Iterator[tuple[tuple[slice, slice], Array]]:
    """Both ends of all pairs so many steps apart, and 1 / R of the largest ball that fits there."""
    rows = slice(None, -i or None), slice(i, None)
    columns = slice(max(-j, 0), -j if j > 0 else None), slice(max(j, 0), j if j < 0 else None)
    ends = [tuple(each[r, c] for each in face[2:]) for r, c in zip(rows, columns, strict=True)]
    (z, p, q), (z_far, p_far, q_far) = ends
    dx, dy = i * (face.x[1] - face.x[0]), j * (face.y[1] - face.y[0])
    dz = z_far - z
    square = dx * dx + dy * dy + dz * dz
    for number, above in enumerate(
        (
            (dz - p * dx - q * dy) / np.sqrt(1 + p * p + q * q),
            (p_far * dx + q_far * dy - dz) / np.sqrt(1 + p_far * p_far + q_far * q_far),
        )
    ):
        yield (rows[number], columns[number]), 2 * above / square


@dataclass(frozen=True)
class Raster:
    """Straight cuts along x, line after line.

    ``x`` (m_x,) and ``y`` (m_y,) are in equal steps, ``tip`` (m_x, m_y) is z of the ball's lowest
    point, scene units.
    """

    x: Array
    y: Array
    tip: Array
    radius: float

    def cut_at(self, x: Array, y: Array) -> Array:
        """Height (m,) of the remaining material."""
        return self.cut(x, y)[0]

    def cut(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Height and unit normal, to +z, of the remaining material; see `BallSweep.lowest`."""
        return self._sweep.lowest(x, y)

    @cached_property
    def _sweep(self) -> BallSweep:
        return BallSweep(self.x, self.y, self.tip + self.radius, self.radius)


@dataclass(frozen=True, eq=False)
class CutFace:
    """A face cut from +z: its net, control heights (n_u, n_v) and the outline to cut."""

    net: ControlNet
    heights: Array
    outline: Outline

    @classmethod
    def lying(cls, net: ControlNet, heights: Array, outline: Outline, up: int) -> Self:
        """A face as it lies below the cutter: turned over about y unless it looks up."""
        return cls(net, heights if up > 0 else -heights[::-1], outline)

    @cached_property
    def _pieces(self) -> Pieces:
        r_x, r_y = map(float, self.net.half_width)
        along_x, along_y = map(_polynomials, self.net.knots, self.net.degree)
        control = np.ascontiguousarray(self.heights, np.float64)
        return Pieces(control, along_x, along_y, r_x, r_y)

    @cached_property
    def _shape(self) -> tuple[float, float]:
        shape = local_shape(self.net, self.heights, *self._places)
        return float(shape.slope.max()), max(float(shape.largest.max()), 0.0)

    @cached_property
    def _places(self) -> tuple[Array, Array]:
        spans = (n - p for n, p in zip(self.net.shape, self.net.degree, strict=True))
        along_x, along_y = (np.linspace(0, 1, n * math.ceil(_PARTS / n) + 1) for n in spans)
        return along_x, along_y

    @cached_property
    def default_radius(self) -> float:
        """Radius of the default cutter, scene units.

        It is smaller than the least concave radius and fits between all parts of the face.
        """
        largest = _LARGEST * min(self.net.half_width)
        concave = self._shape[1]
        if concave * largest <= _FITTING:
            return largest
        x, y = ((2 * t - 1) * r for t, r in zip(self._places, self.net.half_width, strict=True))
        face = GridFace(x, y, *self.net.grid(*self._places).evaluate(self.heights))
        blocked = blocked_radius(face, 1 / concave)
        return min(_FITTING * (1 / concave if blocked is None else blocked[0]), largest)

    def plan_raster(
        self, radius: float, scallop: float, most: int, step: float = 0.0
    ) -> Steps[Raster]:
        """Find cuts with a scallop height of at most ``scallop``, in short steps.

        Lengths in scene units; the height is exact on a plane across the axis. x and y of the cuts
        are multiples of ``step``, if it is given. Raise Refused for more than ``most`` moves.
        """
        ends, counts = self._counts(radius, scallop)
        if math.prod(counts) > most:
            raise Refused(
                "scallop",
                Message(
                    "{scallop:.2g} takes {moves:,} moves of this cutter, more than "
                    "{most:,}; a larger one",
                    scallop=scallop,
                    moves=math.prod(counts),
                    most=most,
                ),
            )
        x, y = (_spread(end, count, step) for end, count in zip(ends, counts, strict=True))
        x = np.linspace(x[0], x[-1], 2 * len(x) - 1)
        tips = yield from self._tips(x, y, radius)
        tip, middles = tips[::2], tips[1::2]
        # A straight cut runs below a convex offset surface: raise its ends. The distance of a
        # convex curve to its chord is nowhere more than twice that in the middle.
        lift = np.pad((2 * middles - tip[1:] - tip[:-1]).clip(0), ((1, 1), (0, 0)))
        return Raster(x[::2], y, tip + np.maximum(lift[1:], lift[:-1]), radius)

    def finest_scallop(self, radius: float, scallop: float, most: int) -> float:
        """Least scallop height, from ``scallop`` on, that takes at most ``most`` moves."""
        while scallop < radius:
            _, counts = self._counts(radius, scallop)
            if math.prod(counts) <= most:
                return scallop
            scallop *= _HIGHER
        return radius / 2

    # Centres of balls of radius R that are s apart along the offset surface of a concave face of
    # curvature κ touch it s / (1 − κ R) apart and leave scallops of s² / (8 R (1 − κ R)). On a
    # convex face κ is negative and scallops are lower.
    def scallop_of(self, radius: float, step_over: float) -> float:
        """Largest height of the scallops of cuts that are ``step_over`` apart, seen along z."""
        equivalent_radius = self._equivalent(radius)
        half = min(step_over / 2 * math.sqrt(1 + self._shape[0] ** 2), equivalent_radius)
        return equivalent_radius - math.sqrt(equivalent_radius**2 - half**2)

    def _equivalent(self, radius: float) -> float:
        """Radius of a ball that leaves such scallops on a plane as this one where it fits worst."""
        return radius * max(1 - self._shape[1] * radius, _TIGHTEST)

    def _counts(self, radius: float, scallop: float) -> tuple[list[float], list[int]]:
        slope, equivalent_radius = self._shape[0], self._equivalent(radius)
        height = min(scallop, equivalent_radius)
        apart = 2 * math.sqrt(2 * equivalent_radius * height - height**2) / math.sqrt(1 + slope**2)
        # At the rim the side of the ball touches. Between two lines the ball must be clear of it.
        beyond = radius * slope / math.sqrt(1 + slope**2) + apart / 2
        ends = [r + beyond for r in self.net.half_width]
        return ends, [
            math.ceil(2 * r / s) + 1 for r, s in zip(ends, (apart / 2, apart), strict=True)
        ]

    def _tips(self, x: Array, y: Array, radius: float) -> Steps[Array]:
        turned = self._turned_over(x, y, radius)
        stray = max(turned.x[1] - turned.x[0], turned.y[1] - turned.y[0])
        tips = np.empty((len(x), len(y)))
        lines = math.ceil(_AT_ONCE / len(y))
        for begin in range(0, len(x), lines):
            some = slice(begin, begin + lines)
            places = np.meshgrid(x[some], y, indexing="ij")
            x_ball, y_ball = (each.ravel() for each in places)
            _, normal = turned.lowest(x_ball, y_ball)
            at_x, at_y = x_ball + radius * normal[:, 0], y_ball + radius * normal[:, 1]
            tip = np.empty(len(x_ball))
            touching(self._pieces, radius, stray, x_ball, y_ball, at_x, at_y, tip)
            tips[some] = tip.reshape(-1, len(y))
            yield min(begin + lines, len(x)) / len(x)
        return tips

    def _turned_over(self, x: Array, y: Array, radius: float) -> BallSweep:
        lattice = []
        reach = radius * self._shape[0] / math.sqrt(1 + self._shape[0] ** 2)
        for axis, end in enumerate((x[-1], y[-1])):
            r, spans = self.net.half_width[axis], self.net.shape[axis] - self.net.degree[axis]
            # As fine as the cuts along x.
            steps = spans * max(_IN_SPAN, math.ceil(r / (spans * (x[1] - x[0]))))
            beyond = math.ceil((end + reach - r) / (2 * r / steps)) + 1
            lattice.append(np.arange(-beyond, steps + beyond + 1) * (2 * r / steps) - r)
        return BallSweep(lattice[0], lattice[1], -self.extended(*lattice), radius)

    def extended(self, x: Array, y: Array) -> Array:
        """Heights (m_x, m_y) on a grid; beyond the edge the face continues with its slope there."""
        return np.asarray((self._basis(0, x) @ self.heights) @ self._basis(1, y).T)

    def _basis(self, axis: int, places: Array) -> csr_array:
        r, knots, degree = self.net.half_width[axis], self.net.knots[axis], self.net.degree[axis]
        inner = places.clip(-r, r)
        value = sparse_basis(knots, degree, (inner / r + 1) / 2)
        slopes = sparse_basis(knots, degree, np.array([0.0, 1.0]), derivative=1) / (2 * r)
        beyond = np.stack([(places - inner).clip(max=0), (places - inner).clip(min=0)], axis=1)
        return value + csr_array(beyond) @ slopes

    def cut_errors(self, raster: Raster, seed: int = 1) -> Steps["CutErrors"]:
        """Compare the remaining material with the face at random points and on its rim."""
        a, b = np.random.default_rng(seed).random((2, _SAMPLES))
        x, y = np.concatenate([self.outline.evenly(a, b), self.outline.boundary(_RIM).T], axis=1)
        above = np.empty(len(x))
        for begin in range(0, len(x), _AT_ONCE):
            some = slice(begin, begin + _AT_ONCE)
            z, p, q = self.net.at(x[some], y[some], self.heights)
            above[some] = (raster.cut_at(x[some], y[some]) - z) / np.sqrt(1 + p * p + q * q)
            yield min(begin + _AT_ONCE, len(x)) / len(x)
        most = above.argmax()
        return CutErrors(float(-above.min()), float(above[most]), (float(x[most]), float(y[most])))


class CutErrors(NamedTuple):
    """Errors of a cut face along its normal, scene units.

    ``cut_off`` is the deepest gouge, negative if there is none; ``left`` the largest excess, at
    ``place`` (x, y).
    """

    cut_off: float
    left: float
    place: tuple[float, float]


def _spread(end: float, count: int, step: float) -> Array:
    """Places from ``-end`` or before to ``end`` or beyond, as many as ``count`` or more."""
    apart = 2 * end / (count - 1)
    if step:  # half of an even number of steps is a whole number of them
        apart = 2 * step * max(math.floor(apart / (2 * step) * (1 + 1e-12)), 1)
        count = math.ceil(2 * end / apart * (1 - 1e-12)) + 1
    return np.asarray(apart * (np.arange(count) - (count - 1) / 2))


def _polynomials(knots: Array, degree: int) -> Array:
    begins = knots[degree : -degree - 1]
    width = 1 / len(begins)
    taylor = [
        local_basis(knots, degree, begins, derivative=k)[1] * (width**k / math.factorial(k))
        for k in range(degree + 1)
    ]
    return np.ascontiguousarray(np.stack(taylor, axis=2))
