"""A raster of a ball cutter over a face that cuts nothing off it, and what it leaves.

The tip of a ball of radius R above (x₀, y₀) may go down to the largest z + √(R² − r²) − R of all
places of the face at a distance r, across the axis, from there: the offset surface.
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
from scipy.interpolate import NdBSpline

from workbench.errors import Refused
from workbench.geometry.curvature import local_shape
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet

Array = npt.NDArray[np.float64]

_NEWTON = 12  # steps to where the ball touches; they end where rounding does
_COARSE = 7  # places along each axis below a ball, where these steps begin
_PLACES = 257  # along each axis, where the face's shape is looked at
_SAMPLES = 4_000  # places where the cut is looked at
_FINER = 4  # parts of each straight cut there
_AT_ONCE = 500
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
        fine = np.linspace(self.x[0], self.x[-1], _FINER * (len(self.x) - 1) + 1)
        part = (fine - self.x[0]) / (self.x[1] - self.x[0])
        first = part.astype(int).clip(max=len(self.x) - 2)
        along = (part - first)[:, None]
        tip = (1 - along) * self.tip[first] + along * self.tip[first + 1]
        left = np.empty(len(x))
        for begin in range(0, len(x), _AT_ONCE):
            some = slice(begin, begin + _AT_ONCE)
            left[some] = self._lowest(fine, tip, x[some], y[some])
        return left

    def _lowest(self, fine: Array, tip: Array, x: Array, y: Array) -> Array:
        windows = []
        for ends, at in ((fine, x), (self.y, y)):
            step = ends[1] - ends[0]
            wide = min(math.ceil(self.radius / step), len(ends) - 1)
            middle = np.rint((at - ends[0]) / step).astype(int)
            windows.append((middle[:, None] + np.arange(-wide, wide + 1)).clip(0, len(ends) - 1))
        columns, rows = windows
        square = ((fine[columns] - x[:, None]) ** 2)[:, :, None] + (
            (self.y[rows] - y[:, None]) ** 2
        )[:, None, :]
        under = self.radius**2 - square
        height = tip[columns[:, :, None], rows[:, None, :]] + self.radius
        sides = np.where(under >= 0, height - np.sqrt(under.clip(0)), np.inf)
        return np.asarray(sides.min(axis=(1, 2)))


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

    def raster(self, radius: float, scallop: float, most: int) -> Raster:
        """Cuts so close that ridges between them are at most so high.

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
        slope, _, hump = self._shape
        bent = 1 / (1 / radius + hump)  # a ridge on a hump is that of a smaller ball on a plane
        height = min(scallop, bent)
        apart = 2 * math.sqrt(2 * bent * height - height**2) / math.sqrt(1 + slope**2)
        # At the rim the ball touches with its side.
        beyond = radius * slope / math.sqrt(1 + slope**2)
        ends = [r + beyond for r in self.net.half_width]
        counts = [math.ceil(2 * r / s) + 1 for r, s in zip(ends, (apart / 2, apart), strict=True)]
        if math.prod(counts) > most:
            raise Refused(
                "scallop",
                f"{scallop:.2g} takes {math.prod(counts):,} moves of this cutter, more than "
                f"{most:,}; a larger one",
            )
        x, y = (np.linspace(-r, r, count) for r, count in zip(ends, counts, strict=True))
        tip = np.stack([self._tip(x, np.full_like(x, at), radius) for at in y], axis=1)
        middles = np.stack(
            [self._tip((x[1:] + x[:-1]) / 2, np.full(len(x) - 1, at), radius) for at in y], axis=1
        )
        # A straight cut would run below an offset surface that is a hump: its ends are higher. The
        # distance of a hump to its chord is nowhere more than twice that in the middle.
        lift = np.pad((2 * middles - tip[1:] - tip[:-1]).clip(0), ((1, 1), (0, 0)))
        return Raster(x, y, tip + np.maximum(lift[1:], lift[:-1]), radius)

    def _tip(self, x_0: Array, y_0: Array, radius: float) -> Array:
        """How far down a ball may go: Newton's method finds where it touches."""
        middle = np.stack([x_0, y_0], axis=1)
        at = self._start(middle, radius)
        lowest = self._held(at, middle, radius)
        for _ in range(_NEWTON):
            _, p, q, r, s, t = self._beyond(at)
            stretch = np.sqrt(1 + p * p + q * q)
            off_x = at[:, 0] - x_0 - radius * p / stretch
            off_y = at[:, 1] - y_0 - radius * q / stretch
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
        return np.maximum(lowest, self._held(at, middle, radius))

    def _held(self, at: Array, middle: Array, radius: float) -> Array:
        """How high the tip is where a place of the face holds the ball up."""
        under = radius**2 - ((at - middle) ** 2).sum(axis=1)
        height = self._beyond(at)[0] + np.sqrt(under.clip(0)) - radius
        return np.where(under >= 0, height, -np.inf)

    def _start(self, middle: Array, radius: float) -> Array:
        """The place of a coarse lattice below each ball that holds it up most."""
        slope = self._shape[0]
        wide = radius * slope / math.sqrt(1 + slope**2)
        best, at = self._held(middle, middle, radius), middle.copy()
        lattice = np.linspace(-wide, wide, _COARSE)
        for dx in lattice:
            for dy in lattice:
                place = middle + np.array([dx, dy])
                held = self._held(place, middle, radius)
                better = held > best
                best, at[better] = np.where(better, held, best), place[better]
        return at

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
