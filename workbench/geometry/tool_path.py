"""A raster of a ball cutter over a face that cuts nothing off it, and what it leaves.

The tip of a ball of radius R above (x₀, y₀) may go down to the largest z + √(R² − r²) − R of all
places of the face at a distance r, across the axis, from there: the offset surface.
"""

import math
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from scipy.interpolate import BSpline, NdBSpline
from scipy.sparse import csr_array

from workbench.arrays import Array, Index
from workbench.errors import Refused
from workbench.geometry.curvature import local_shape
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.said import Said
from workbench.watch import Steps, of_equal, within

_NEWTON = 4  # steps to where the ball touches, from the lattice
_COARSE = 7  # places along each axis below a ball, where these steps begin
_PLACES = 257  # along each axis, where the face's shape is looked at
_SAMPLES = 4_000  # places where the cut is looked at
_AT_ONCE = 20_000
_LINES = 64  # of a raster across, whose contacts are found together
_HIGHER = 1.1  # ridges, until there are few enough
_FITTING = 0.8  # of the tightest hollow's radius: a cutter that is chosen
_LARGEST = 0.5  # of the half-width


@dataclass(frozen=True)
class Raster:
    """Straight cuts along x, line after line.

    Attributes
    ----------
    x, y : ndarray, shapes (m_x,) and (m_y,)
        In equal steps, scene units.
    tip : ndarray, shape (m_x, m_y)
        Where the lowest point of the ball is, z.
    radius : float
        That of the ball.
    """

    x: Array
    y: Array
    tip: Array
    radius: float

    def cut_at(self, x: Array, y: Array) -> Array:
        """Height that the ball leaves at places, shape (m,): what it sweeps over is gone."""
        return self.cut(x, y)[0]

    def cut(self, x: Array, y: Array) -> tuple[Array, Array]:
        """What the ball leaves at places, as it goes straight from each place of the raster on.

        Parameters
        ----------
        x, y : ndarray, shape (m,)
            Places, scene units.

        Returns
        -------
        height : ndarray, shape (m,)
        normal : ndarray, shape (m, 3)
            Unit normals to +z.
        """
        height, normal = np.empty(len(x)), np.empty((len(x), 3))
        for begin in range(0, len(x), _AT_ONCE):
            some = slice(begin, begin + _AT_ONCE)
            height[some], normal[some] = self._lowest(x[some], y[some])
        return height, normal

    def _lowest(self, x: Array, y: Array) -> tuple[Array, Array]:
        """The lowest of the sides of the ball in all cuts that come near, each in three moves."""
        step = self.y[1] - self.y[0]
        wide = min(math.ceil(self.radius / step), len(self.y) - 1)
        middle = np.rint((y - self.y[0]) / step).astype(int)
        rows = (middle[:, None] + np.arange(-wide, wide + 1)).clip(0, len(self.y) - 1)
        aside = self.y[rows] - y[:, None]
        half_chord = np.sqrt((self.radius**2 - aside**2).clip(0))
        move = self._move(np.broadcast_to(x[:, None], rows.shape))
        for _ in range(2):  # to where the ball touches: slopes of neighbours are alike
            slope = self._slopes[move, rows]
            move = self._move(x[:, None] - half_chord * slope / np.sqrt(1 + slope**2))
        best, normal = np.full(len(x), np.inf), np.zeros((len(x), 3))
        for each in (move - 1, move, move + 1):
            each = each.clip(0, len(self.x) - 2)
            slope = self._slopes[each, rows]
            there = x[:, None] - half_chord * slope / np.sqrt(1 + slope**2)
            there = there.clip(self.x[each], self.x[each + 1])
            along = there - x[:, None]
            under = half_chord**2 - along**2
            above = self.tip[each, rows] + slope * (there - self.x[each]) + self.radius
            side = np.where(under > 0, above - np.sqrt(under.clip(0)), np.inf)
            row = side.argmin(axis=1)[:, None]
            found = np.take_along_axis(side, row, axis=1)[:, 0]
            towards = [
                np.take_along_axis(part, row, axis=1)[:, 0] / self.radius
                for part in (along, aside, np.sqrt(under.clip(0)))
            ]
            lower = found < best
            best = np.where(lower, found, best)
            normal[lower] = np.stack(towards, axis=1)[lower]
        return best, normal

    @cached_property
    def _slopes(self) -> Array:
        """Those of the moves along x, shape (m_x - 1, m_y)."""
        return np.asarray(np.diff(self.tip, axis=0) / (self.x[1] - self.x[0]))

    def _move(self, x: Array) -> Index:
        """Numbers of the moves that pass places."""
        number = np.floor((x - self.x[0]) / (self.x[1] - self.x[0]))
        return np.asarray(number.clip(0, len(self.x) - 2), dtype=np.intp)


@dataclass(frozen=True, eq=False)
class CutFace:
    """A face as a cutter that comes from +z sees it.

    Attributes
    ----------
    net : ControlNet
        Its net.
    heights : ndarray, shape (n_u, n_v)
        Its control heights, scene units.
    outline : Outline
        What of it is needed.
    """

    net: ControlNet
    heights: Array
    outline: Outline

    @cached_property
    def _spline(self) -> NdBSpline:
        knots = tuple(
            (2 * k - 1) * r for k, r in zip(self.net.knots, self.net.half_width, strict=True)
        )
        return NdBSpline(knots, self.heights, self.net.degree)

    @cached_property
    def _shape(self) -> tuple[float, float, float]:
        """Largest slope, curvature of hollows, and of humps."""
        t = np.linspace(0, 1, _PLACES)
        shape = local_shape(self.net, self.heights, t, t)
        hollow, hump = max(shape.largest.max(), 0.0), max(-shape.smallest.min(), 0.0)
        return float(shape.slope.max()), float(hollow), float(hump)

    @property
    def fitting_radius(self) -> float:
        """Radius of a cutter that may be taken if nobody says which, scene units."""
        largest = _LARGEST * min(self.net.half_width)
        hollow = self._shape[1]
        return min(_FITTING / hollow, largest) if hollow > 0 else largest

    def rastering(self, radius: float, scallop: float, most: int) -> Steps[Raster]:
        """Find cuts so close that ridges between them are at most so high, in steps of a moment.

        Parameters
        ----------
        radius : float
            That of the ball, scene units.
        scallop : float
            Largest height of ridges, scene units; exact on a plane across the axis.
        most : int
            Places that there may be.

        Raises
        ------
        Refused
            If there would be more.
        """
        ends, counts = self._counts(radius, scallop)
        if math.prod(counts) > most:
            raise Refused(
                "scallop",
                Said(
                    "{scallop:.2g} takes {moves:,} moves of this cutter, more than "
                    "{most:,}; a larger one",
                    scallop=scallop,
                    moves=math.prod(counts),
                    most=most,
                ),
            )
        (x_end, y_end), (m_x, m_y) = ends, counts
        x, y = np.linspace(-x_end, x_end, 2 * m_x - 1), np.linspace(-y_end, y_end, m_y)
        tips = yield from self._tips(x, y, radius)
        tip, middles = tips[::2], tips[1::2]
        # A straight cut would run below an offset surface that is a hump: its ends are higher. The
        # distance of a hump to its chord is nowhere more than twice that in the middle.
        lift = np.pad((2 * middles - tip[1:] - tip[:-1]).clip(0), ((1, 1), (0, 0)))
        return Raster(x[::2], y, tip + np.maximum(lift[1:], lift[:-1]), radius)

    def finest(self, radius: float, scallop: float, most: int) -> float:
        """Height of ridges that takes no more moves: as asked, or as high as needed for that."""
        while scallop < radius:
            _, counts = self._counts(radius, scallop)
            if math.prod(counts) <= most:
                return scallop
            scallop *= _HIGHER
        return radius / 2

    def _counts(self, radius: float, scallop: float) -> tuple[list[float], list[int]]:
        """How far a raster reaches along x and y, and how many places it has."""
        slope, _, hump = self._shape
        # A ridge on a hump is that of a smaller ball on a plane.
        equivalent_radius = 1 / (1 / radius + hump)
        height = min(scallop, equivalent_radius)
        apart = 2 * math.sqrt(2 * equivalent_radius * height - height**2) / math.sqrt(1 + slope**2)
        # At the rim the ball touches with its side.
        beyond = radius * slope / math.sqrt(1 + slope**2)
        ends = [r + beyond for r in self.net.half_width]
        return ends, [
            math.ceil(2 * r / s) + 1 for r, s in zip(ends, (apart / 2, apart), strict=True)
        ]

    def _tips(self, x: Array, y: Array, radius: float) -> Steps[Array]:
        """How far down a ball may go over a grid: Newton's method finds where it touches."""
        lowest, at = yield from within(self._start(x, y, radius), partial(of_equal, 2, 0))
        middle = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
        for begin in range(0, len(x), _LINES):
            some = slice(begin, begin + _LINES)
            held = self._touching(at[some].reshape(-1, 2), middle[some].reshape(-1, 2), radius)
            lowest[some] = np.maximum(lowest[some], held.reshape(lowest[some].shape))
            yield (1 + min(begin + _LINES, len(x)) / len(x)) / 2
        return lowest

    def _touching(self, at: Array, middle: Array, radius: float) -> Array:
        """How far down balls may go that touch close to places."""
        for _ in range(_NEWTON):
            _, p, q, r, s, t = self._beyond(at)
            stretch = np.sqrt(1 + p * p + q * q)
            off_x, off_y = (at - middle - (radius / stretch)[:, None] * np.stack([p, q], axis=1)).T
            # Derivatives of these: those of the normal (-p, -q) / stretch are in them.
            scale = radius / stretch**3
            xx = 1 - scale * ((1 + q * q) * r - p * q * s)
            xy = -scale * ((1 + q * q) * s - p * q * t)
            yx = -scale * ((1 + p * p) * s - p * q * r)
            yy = 1 - scale * ((1 + p * p) * t - p * q * s)
            whole = xx * yy - xy * yx
            step = np.stack([yy * off_x - xy * off_y, xx * off_y - yx * off_x], axis=1)
            step = np.divide(
                step, whole[:, None], out=np.zeros_like(step), where=whole[:, None] > 0
            )
            at = (at - step).clip(middle - radius, middle + radius)
        return self._held(at, middle, radius)

    def _held(self, at: Array, middle: Array, radius: float) -> Array:
        """How high the tip is where a place of the face holds the ball up."""
        under = radius**2 - ((at - middle) ** 2).sum(axis=1)
        height = self._beyond(at)[0] + np.sqrt(under.clip(0)) - radius
        return np.where(under >= 0, height, -np.inf)

    def _start(self, x: Array, y: Array, radius: float) -> Steps[tuple[Array, Array]]:
        """How high places of a coarse lattice hold balls up, and those that do most (…, 2).

        All balls see the same lattice, so that heights are products of matrices with few entries.
        """
        slope = self._shape[0]
        wide = radius * slope / math.sqrt(1 + slope**2)
        lattice = np.unique(np.append(np.linspace(-wide, wide, _COARSE), 0.0))
        best = np.full((len(x), len(y)), -np.inf)
        at = np.zeros((len(x), len(y), 2))
        upwards = [self._basis(1, y + dy).T for dy in lattice]
        for done, dx in enumerate(lattice):
            across = self._basis(0, x + dx) @ self.heights
            for dy, up in zip(lattice, upwards, strict=True):
                held = across @ up + (math.sqrt(max(radius**2 - dx**2 - dy**2, 0.0)) - radius)
                better = held > best
                best = np.where(better, held, best)
                at[better] = np.stack(np.meshgrid(x + dx, y + dy, indexing="ij"), axis=-1)[better]
                yield (done + 1) / len(lattice)
        return best, at

    def _basis(self, axis: int, places: Array) -> csr_array:
        """Values of the basis along an axis; straight lines go on at the rim."""
        end, knots, degree = self.net.half_width[axis], self._spline.t[axis], self.net.degree[axis]
        inner = places.clip(-end, end)
        value = BSpline.design_matrix(inner, knots, degree)
        slopes = BSpline(knots, np.eye(self.net.shape[axis]), degree)(np.array([-end, end]), nu=1)
        beyond = np.stack([(places - inner).clip(max=0), (places - inner).clip(min=0)], axis=1)
        return csr_array(value) + csr_array(beyond) @ csr_array(slopes)

    def _beyond(self, at: Array) -> tuple[Array, ...]:
        """Height and derivatives z_x, z_y, z_xx, z_xy, z_yy; straight lines go on at the rim."""
        ends = np.array(self.net.half_width)
        inner = at.clip(-ends, ends)
        z, p, q, r, s, t = (
            self._spline(inner, nu=nu) for nu in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
        )
        dx, dy = (at - inner).T
        in_x, in_y = (at == inner).T
        return (
            z + p * dx + q * dy,
            p + in_x * s * dy,
            q + in_y * s * dx,
            in_x * r,
            (in_x | in_y) * s,
            in_y * t,
        )

    def left(self, raster: Raster, seed: int = 1) -> tuple[float, float]:
        """The deepest cut into the face, and the most that is left on it, along its normal.

        Looked at where fresh random places of the face are, not where the cutter has touched.
        """
        a, b = np.random.default_rng(seed).random((2, _SAMPLES))
        x, y = self.outline.evenly(a, b)
        at = np.stack([x, y], axis=1)
        p, q = (self._spline(at, nu=nu) for nu in ((1, 0), (0, 1)))
        above = (raster.cut_at(x, y) - self._spline(at)) / np.sqrt(1 + p * p + q * q)
        return float((-above).max()), float(above.max())
