"""The closed body of the lens as triangles, with a bound on their distance from the exit face."""

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.errors import Refused
from workbench.files.export.design import Design
from workbench.geometry.basis import local_basis
from workbench.geometry.bounds import derivative_range

Array = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]

_MOST_CELLS = 4_000_000
# The chord error is looked for on so many equal parts of each cell's sides.
_LOOKS = 4


class Body(NamedTuple):
    """A closed surface of triangles.

    Attributes
    ----------
    vertices : ndarray, shape (n, 3)
        Scene units.
    triangles : ndarray of int, shape (m, 3)
        Vertices of each, counterclockwise as seen from outside.
    """

    vertices: Array
    triangles: Indices


class Tessellation(NamedTuple):
    """The exit face over a grid of cells, each cut along the diagonal from −x −y to +x +y.

    The cells are rectangles; those of an ellipse are what `workbench.geometry.outlines` makes of
    equal rectangles, so that the rim has no steps: its vertices are on it.

    Attributes
    ----------
    x, y : ndarray, shape (m_x, 1) and (1, m_y), or (m_x, m_y)
    z : ndarray, shape (m_x, m_y)
        Scene units.
    flat_z : float
        Where the flat side is: the entrance face of a lens, the back of a mirror.
    """

    x: Array
    y: Array
    z: Array
    flat_z: float

    @classmethod
    def of(cls, design: Design, precision: float = 2.0**-53) -> "Tessellation":
        """Rectangles small enough for the design's chord error.

        Parameters
        ----------
        design : Design
            The lens.
        precision : float
            Largest relative rounding error of the coordinates in the file.

        Raises
        ------
        Refused
            If the coordinates cannot be as precise as that, or if it takes too many triangles.

        Notes
        -----
        Linear interpolation on a right triangle with the sides h and k is off by at most
        (h² |z_xx| + 2 h k |z_xy| + k² |z_yy|) / 8, and 2 h k ≤ h² + k². Each direction gets half
        of the error, and in each the strip of knot spans that bends most sets the step.
        """
        largest = design.largest_chord_error
        rounding = _rounding(design, precision)
        if largest < 2 * rounding:
            raise Refused(
                "--chord-error",
                f"{largest:.3g} {design.unit} is finer than the numbers of this format; "
                f"at least {2 * rounding:.3g}",
            )
        allowed = largest - rounding
        if not design.outline.whole:
            return cls._mapped(design, allowed)
        bends = [_most(design, order) for order in ((2, 0), (1, 1), (0, 2))]
        steps = []
        for axis, bend in ((0, bends[0]), (1, bends[2])):
            sharpest = (bend + bends[1]).max(axis=1 - axis)
            span = 2 * design.scene.optic.half_width[axis] / len(sharpest)
            steps.append(np.maximum(np.ceil(span * np.sqrt(sharpest / (4 * allowed))), 1))
        _check_cells(math.prod(float(s.sum()) for s in steps), design)
        x, y = (
            (2 * _divided(s.astype(int)) - 1) * r
            for s, r in zip(steps, design.scene.optic.half_width, strict=True)
        )
        z = design.surface(x, y)[0]
        return cls(x[:, None], y[None, :], z, design.flat_z)

    @classmethod
    def _mapped(cls, design: Design, allowed: float) -> "Tessellation":
        """Equal cells of a square, mapped onto the outline: as many as keep the chord error.

        Of triangles with sides up to d, linear interpolation is off by at most d² |D²z| / 6; the
        rim is off by no more than its own chords. Fewer do where the face bends little at most
        places, so it is tried out.
        """
        r = np.array(design.net.half_width)
        bend = sum(float(_most(design, order).max()) for order in ((2, 0), (1, 1), (0, 2)))
        enough = math.ceil(2 * r.max() * math.sqrt(bend / (6 * allowed)))
        rim = math.ceil(math.sqrt(r.max() / (2 * allowed)))
        count = max(rim, math.ceil(enough / 4), 8)
        while True:
            _check_cells(float(count) ** 2, design)
            side = np.linspace(-1, 1, count + 1)
            x, y, z, _, _ = design.net.over(design.outline, side, side, design.heights)
            found = cls(x, y, z, design.flat_z)
            off = found.chord_error(design) / allowed
            if off <= 1:
                return found
            count = math.ceil(count * max(1.05 * math.sqrt(off), 1.1))

    def rounded(self) -> "Tessellation":
        """The same in single precision, as some formats keep it."""
        x, y, z = (c.astype(np.float32).astype(np.float64) for c in (self.x, self.y, self.z))
        return Tessellation(x, y, z, float(np.float32(self.flat_z)))

    def body(self) -> Body:
        """The closed body: freeform face, four walls, flat side."""
        m_x, m_y = self.z.shape
        top = np.stack(np.broadcast_arrays(self.x, self.y, self.z), axis=-1)
        index = np.arange(m_x * m_y).reshape(m_x, m_y)
        # Counterclockwise, seen from above.
        rim = np.concatenate([index[:-1, 0], index[-1, :-1], index[:0:-1, -1], index[0, :0:-1]])
        feet = top.reshape(-1, 3)[rim]
        feet[:, 2] = self.flat_z
        middle = np.array([[self.x.mean(), self.y.mean(), self.flat_z]])
        a, b, c, d = (
            corner.ravel()
            for corner in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:])
        )
        foot = m_x * m_y + np.arange(len(rim))
        next_rim, next_foot = np.roll(rim, -1), np.roll(foot, -1)
        center = np.full(len(rim), foot[-1] + 1)
        triangles = [
            (a, b, c),
            (a, c, d),
            (rim, foot, next_foot),
            (rim, next_foot, next_rim),
            (center, next_foot, foot),
        ]
        found = np.concatenate([np.column_stack(corners) for corners in triangles])
        if self.flat_z > self.z.min():  # the face is below: seen from outside, it is turned over
            found = found[:, ::-1]
        return Body(np.concatenate([top.reshape(-1, 3), feet, middle]), found)

    def chord_error(self, design: Design) -> float:
        """Largest distance, along z, between triangles and exit face, on a grid in each cell."""
        if not design.outline.whole:
            return self._chord_error_of_mapped(design)
        x, y = _subdivided(self.x[:, 0]), _subdivided(self.y[0])
        by_column = design.heights @ design.basis(x[:1], y).along_y
        u = (x / design.net.half_width[0] + 1) / 2
        first, along_x = local_basis(design.net.knots[0], design.net.degree[0], u)
        row = first[:, None] + np.arange(along_x.shape[1])
        # Places in a cell: s along x, t along y, j the cell's column.
        s = np.linspace(0, 1, _LOOKS + 1)[:, None]
        j = np.minimum(np.arange(by_column.shape[1]) // _LOOKS, self.z.shape[1] - 2)
        t = np.arange(by_column.shape[1]) / _LOOKS - j
        high, low = np.maximum(s, t), np.minimum(s, t)
        largest = 0.0
        for i, (near, far) in enumerate(pairwise(self.z)):
            # Below the diagonal a triangle has the cell's corner at +x, above it that at +y.
            third = np.where(s > t, far[j], near[j + 1])
            flat = near[j] + high * (third - near[j]) + low * (far[j + 1] - third)
            places = slice(i * _LOOKS, (i + 1) * _LOOKS + 1)
            exact = np.einsum("kp,kpj->kj", along_x[places], by_column[row[places]])
            largest = max(largest, float(np.abs(flat - exact).max()))
        return largest

    def _chord_error_of_mapped(self, design: Design) -> float:
        """As `chord_error`, for cells that are no rectangles."""
        places = np.stack(np.broadcast_arrays(self.x, self.y, self.z), axis=-1)
        a, b, c, d = places[:-1, :-1], places[1:, :-1], places[1:, 1:], places[:-1, 1:]
        largest = 0.0
        for i in range(_LOOKS + 1):
            for j in range(_LOOKS + 1 - i):
                s, t = i / _LOOKS, j / _LOOKS
                for corner in (b, d):
                    x, y, flat = np.moveaxis((1 - s - t) * corner + s * a + t * c, -1, 0)
                    exact = design.net.at(x, y, design.heights)[0]
                    largest = max(largest, float(np.abs(flat - exact).max()))
        return largest


def _check_cells(cells: float, design: Design) -> None:
    """Refuse a chord error that takes too many triangles."""
    if cells > _MOST_CELLS:
        largest = design.largest_chord_error
        raise Refused(
            "--chord-error",
            f"{largest:.3g} {design.unit} takes {2 * cells:.0f} triangles, more than "
            f"{2 * _MOST_CELLS}; about {1.1 * largest * cells / _MOST_CELLS:.2g} is possible",
        )


def _most(design: Design, order: tuple[int, int]) -> Array:
    """The most that a derivative can be on each knot span."""
    low, high = derivative_range(design.net, design.heights, order)
    return np.maximum(np.abs(low), np.abs(high))


def _rounding(design: Design, precision: float) -> float:
    """How far off rounded vertices can be, seen along z."""
    sideways = sum(
        r * np.abs(np.diff(heights, axis=0) / np.diff(places)[:, None]).max()
        for r, heights, places in zip(
            design.net.half_width,
            (design.heights, design.heights.T),
            design.net.positions,
            strict=True,
        )
    )
    return precision * float(np.abs(design.heights).max() + sideways)


def _divided(steps: npt.NDArray[np.int_]) -> Array:
    """Places in [0, 1] that cut each of the equal spans into so many equal steps."""
    spans = len(steps)
    parts = [(i + np.arange(k) / k) / spans for i, k in enumerate(steps)]
    return np.concatenate([*parts, [1.0]])


def _subdivided(places: Array) -> Array:
    within = np.arange(_LOOKS) / _LOOKS
    fine = places[:-1, None] + np.diff(places)[:, None] * within
    return np.append(fine.ravel(), places[-1])
