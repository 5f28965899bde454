"""A raster of a ball cutter over a face that cuts nothing off it, and what it leaves.

The tip of a ball of radius R above (x₀, y₀) may go down to the largest z + √(R² − r²) − R of all
points of the face at a distance r, across the axis, from there: the offset surface. That is a
sweep of balls, too, seen from below: balls of this radius around all points of the face, turned
over. So `BallSweep` finds both the tips and what the cutter leaves.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.ball_kernels import Pieces, touching
from workbench.geometry.ball_sweep import BallSweep
from workbench.geometry.basis import local_basis, sparse_basis
from workbench.geometry.curvature import local_shape
from workbench.geometry.outlines import Outline
from workbench.geometry.surface import ControlNet
from workbench.geometry.tool_radius import GridFace, blocked_radius
from workbench.said import Said
from workbench.watch import Steps

_IN_SPAN = 4  # lattice steps in each knot span, from whose points touching balls are found
_PARTS = 256  # along each axis, at least, at whose ends the face's shape is evaluated
_SAMPLES = 100_000  # points where the cut is compared with the face
_RIM = 4_000  # further ones on its rim
_AT_ONCE = 20_000
_HIGHER = 1.1  # ridges, until there are few enough
# A cutter that is chosen, over the tightest hollow's radius: the number of moves goes with
# 1 / (R (1 − κ R)), see `CutFace._counts`, which is least here.
_FITTING = 0.5
_TIGHTEST = 0.1  # least 1 − κ R that lines are planned for
_LARGEST = 0.5  # of the half-width


@dataclass(frozen=True)
class Raster:
    """Straight cuts along x, line after line.

    Attributes
    ----------
    x, y : ndarray, shapes (m_x,) and (m_y,)
        In equal steps, scene units.
    tip : ndarray, shape (m_x, m_y)
        Lowest point of the ball there, z.
    radius : float
        Radius of the ball.
    """

    x: Array
    y: Array
    tip: Array
    radius: float

    def cut_at(self, x: Array, y: Array) -> Array:
        """Height that the ball leaves at places, shape (m,): what it sweeps over is gone."""
        return self.cut(x, y)[0]

    def cut(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Height and unit normal, to +z, of what the ball leaves; see `BallSweep.lowest`."""
        return self._sweep.lowest(x, y)

    @cached_property
    def _sweep(self) -> BallSweep:
        return BallSweep(self.x, self.y, self.tip + self.radius, self.radius)


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
    def _pieces(self) -> Pieces:
        r_x, r_y = map(float, self.net.half_width)
        along_x, along_y = map(_polynomials, self.net.knots, self.net.degree)
        control = np.ascontiguousarray(self.heights, np.float64)
        return Pieces(control, along_x, along_y, r_x, r_y)

    @cached_property
    def _shape(self) -> tuple[float, float]:
        """Largest slope, and largest curvature of hollows."""
        shape = local_shape(self.net, self.heights, *self._places)
        return float(shape.slope.max()), max(float(shape.largest.max()), 0.0)

    @cached_property
    def _places(self) -> tuple[Array, Array]:
        """Parameters along both axes, knots among them."""
        spans = (n - p for n, p in zip(self.net.shape, self.net.degree, strict=True))
        along_x, along_y = (np.linspace(0, 1, n * math.ceil(_PARTS / n) + 1) for n in spans)
        return along_x, along_y

    @cached_property
    def fitting_radius(self) -> float:
        """Radius of a cutter that may be taken if nobody says which, scene units.

        Such a ball is smaller than the tightest hollow, and no other part of the face is in its
        way.
        """
        largest = _LARGEST * min(self.net.half_width)
        hollow = self._shape[1]
        if hollow * largest <= _FITTING:
            return largest
        x, y = ((2 * t - 1) * r for t, r in zip(self._places, self.net.half_width, strict=True))
        face = GridFace(x, y, *self.net.grid(*self._places).evaluate(self.heights))
        blocked = blocked_radius(face, 1 / hollow)
        return min(_FITTING * (1 / hollow if blocked is None else blocked[0]), largest)

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
        """How far a raster reaches along x and y, and how many places it has.

        Where centres of balls of radius R are s apart along the offset surface of a hollow of
        curvature κ, the balls touch it s / (1 − κ R) apart, with ridges of s² / (8 R (1 − κ R))
        between them. On a hump κ is negative and ridges are lower.
        """
        slope, hollow = self._shape
        equivalent_radius = radius * max(1 - hollow * radius, _TIGHTEST)
        height = min(scallop, equivalent_radius)
        apart = 2 * math.sqrt(2 * equivalent_radius * height - height**2) / math.sqrt(1 + slope**2)
        # At the rim the ball touches with its side. Where it goes on to the next line it does not.
        beyond = radius * slope / math.sqrt(1 + slope**2) + apart / 2
        ends = [r + beyond for r in self.net.half_width]
        return ends, [
            math.ceil(2 * r / s) + 1 for r, s in zip(ends, (apart / 2, apart), strict=True)
        ]

    def _tips(self, x: Array, y: Array, radius: float) -> Steps[Array]:
        """How far down a ball may go over a grid: it touches near a point of a lattice."""
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
        """Balls around points of the face, which goes on straight at its rim, turned over."""
        lattice = []
        reach = radius * self._shape[0] / math.sqrt(1 + self._shape[0] ** 2)
        for axis, end in enumerate((x[-1], y[-1])):
            r, spans = self.net.half_width[axis], self.net.shape[axis] - self.net.degree[axis]
            # As fine as the cuts are along x.
            steps = spans * max(_IN_SPAN, math.ceil(r / (spans * (x[1] - x[0]))))
            beyond = math.ceil((end + reach - r) / (2 * r / steps)) + 1
            lattice.append(np.arange(-beyond, steps + beyond + 1) * (2 * r / steps) - r)
        across, up = (self._basis(axis, places) for axis, places in enumerate(lattice))
        centre = -((across @ self.heights) @ up.T)
        return BallSweep(lattice[0], lattice[1], centre, radius)

    def _basis(self, axis: int, places: Array) -> csr_array:
        """Values of the basis along an axis; straight lines go on at the rim."""
        r, knots, degree = self.net.half_width[axis], self.net.knots[axis], self.net.degree[axis]
        inner = places.clip(-r, r)
        value = sparse_basis(knots, degree, (inner / r + 1) / 2)
        slopes = sparse_basis(knots, degree, np.array([0.0, 1.0]), derivative=1) / (2 * r)
        beyond = np.stack([(places - inner).clip(max=0), (places - inner).clip(min=0)], axis=1)
        return value + csr_array(beyond) @ slopes

    def left(self, raster: Raster, seed: int = 1) -> Steps["Remains"]:
        """Compare what a raster leaves with the face, in steps of a moment.

        Fresh random points of the face are compared, not those where the cutter touches, and
        points of its rim.
        """
        a, b = np.random.default_rng(seed).random((2, _SAMPLES))
        x, y = np.concatenate([self.outline.evenly(a, b), self.outline.boundary(_RIM).T], axis=1)
        above = np.empty(len(x))
        for begin in range(0, len(x), _AT_ONCE):
            some = slice(begin, begin + _AT_ONCE)
            z, p, q = self.net.at(x[some], y[some], self.heights)
            above[some] = (raster.cut_at(x[some], y[some]) - z) / np.sqrt(1 + p * p + q * q)
            yield min(begin + _AT_ONCE, len(x)) / len(x)
        most = above.argmax()
        return Remains(float(-above.min()), float(above[most]), (float(x[most]), float(y[most])))


class Remains(NamedTuple):
    """What a cutter leaves of a face, along its normal, scene units.

    Attributes
    ----------
    cut_off : float
        The deepest cut into the face; negative where nothing is cut.
    left : float
        The most that is left on it.
    place : tuple[float, float]
        Where that is, x and y.
    """

    cut_off: float
    left: float
    place: tuple[float, float]


def _polynomials(knots: Array, degree: int) -> Array:
    """Basis functions on each span; see `Pieces`."""
    begins = knots[degree : -degree - 1]
    width = 1 / len(begins)
    taylor = [
        local_basis(knots, degree, begins, derivative=k)[1] * (width**k / math.factorial(k))
        for k in range(degree + 1)
    ]
    return np.ascontiguousarray(np.stack(taylor, axis=2))
