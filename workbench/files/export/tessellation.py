"""Closed body of the lens as triangles, and their distance from the freeform faces."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.files.export.design import Design, Deviation
from workbench.geometry.basis import local_basis
from workbench.geometry.curvature import derivative_range
from workbench.messages import Message

Indices = npt.NDArray[np.int64]

_MOST_CELLS = 4_000_000
# Parts of each cell's sides, at whose ends the chord error is sampled.
_PARTS = 4
_SLIVER = 1e-5  # of the width: thinner cells would have no area in single precision


class TriangleBody(NamedTuple):
    """A closed surface: vertices (n, 3), triangles (m, 3) counterclockwise from outside."""

    vertices: Array
    triangles: Indices


class Tessellation(NamedTuple):
    """The faces over one grid of cells, each cut along the diagonal from −x −y to +x +y.

    Cells are rectangles; those of an ellipse are mapped from equal rectangles by
    `workbench.geometry.outlines`, with vertices on the rim. Vertices of both faces have the same x
    and y, which makes the walls.
    """

    # (m_x, 1) and (1, m_y).
    x: Array
    y: Array
    z: Array  # (m_x, m_y), exit face of a lens, or the face of a mirror; scene units
    # (m_x, m_y), z of the other side: of a freeform entrance face, or a number for a flat side.
    other: Array

    @classmethod
    def of(cls, design: Design, precision: float = 2.0**-53) -> "Tessellation":
        """Return cells small enough for the design's chord error at each face.

        ``precision`` is the largest relative rounding error of coordinates in the file. Linear
        interpolation on a right triangle with the sides h and k errs by at most (h² |z_xx| + 2 h k
        |z_xy| + k² |z_yy|) / 8, and 2 h k ≤ h² + k². Each direction gets half of the error, and in
        each the strip of knot spans with the largest curvature sets the step. With two freeform
        faces, strips end at the knots of both. Raise Refused if the coordinates cannot be so
        precise or there are too many triangles.
        """
        design.check_flat_side()
        largest = design.largest_chord_error
        rounding = max(_rounding(face, precision) for face in design.faces)
        if largest < 2 * rounding:
            raise Refused(
                "--chord-error",
                Message(
                    "{largest:.3g} {unit} is finer than the numbers of this format; at "
                    "least {least:.3g}",
                    largest=largest,
                    unit=design.unit,
                    least=2 * rounding,
                ),
            )
        allowed = largest - rounding
        rectangle = design.rectangle
        if rectangle is None:
            return cls._mapped(design, allowed)
        strips = [_strips(design, axis, allowed) for axis in (0, 1)]
        parts = (rectangle[1] - rectangle[0]) / (2 * np.array(design.optic.half_width))
        _check_cells(
            math.prod(part * float(s.sum()) for part, (_, s) in zip(parts, strips, strict=True)),
            design,
        )
        x, y = (
            _between((2 * _divided(ends, steps.astype(int)) - 1) * r, low, high)
            for (ends, steps), r, low, high in zip(
                strips, design.optic.half_width, *rectangle, strict=True
            )
        )
        z, *other = (face.surface(x, y)[0] for face in design.faces)
        return cls(x[:, None], y[None, :], z, _other(design, other))

    # Of triangles with sides up to d, linear interpolation errs by at most d² |D²z| / 6; the error
    # of the rim is that of its chords. Fewer cells suffice where the face is mostly flat: try them.
    @classmethod
    def _mapped(cls, design: Design, allowed: float) -> "Tessellation":
        r = np.array(design.net.half_width)
        orders = ((2, 0), (1, 1), (0, 2))
        curvature = max(
            sum(float(_most(face, order).max()) for order in orders) for face in design.faces
        )
        enough = math.ceil(2 * r.max() * math.sqrt(curvature / (6 * allowed)))
        rim = math.ceil(math.sqrt(r.max() / (2 * allowed)))
        count = max(rim, math.ceil(enough / 4), 8)
        while True:
            _check_cells(float(count) ** 2, design)
            side = np.linspace(-1, 1, count + 1)
            (x, y, z, *_), *other = (
                face.net.over(design.outline, side, side, face.heights) for face in design.faces
            )
            found = cls(x, y, z, _other(design, [each[2] for each in other]))
            off = found.chord_error(design) / allowed
            if off <= 1:
                return found
            count = math.ceil(count * max(1.05 * math.sqrt(off), 1.1))

    def rounded(self, scale: float = 1.0) -> "Tessellation":
        """The tessellation as single precision keeps it after scaling."""
        return Tessellation(*((scale * c).astype(np.float32) / np.float64(scale) for c in self))

    def deviation(self, design: Design, mesh_unit: str) -> Deviation:
        """Measured chord error, with the tile and the unit of lengths in the file as a note."""
        part = "" if design.tile is None else "test tile, "
        return Deviation(
            "chord error", self.chord_error(design), design.unit, f"{part}lengths in {mesh_unit}"
        )

    def body(self, scale: float = 1.0) -> TriangleBody:
        """The closed body, scaled: freeform face, walls, and the other side."""
        m_x, m_y = self.z.shape
        index = np.arange(m_x * m_y).reshape(m_x, m_y)
        # Counterclockwise, seen from above.
        rim = np.concatenate([index[:-1, 0], index[-1, :-1], index[:0:-1, -1], index[0, :0:-1]])
        top = self._places(self.z)
        if self.other.ndim:
            bottom, foot = self._places(self.other), index.size + rim
            closing = _cells(index.size + index)[:, ::-1]
        else:  # its rim and a point in its middle
            middle = np.array([[self.x.mean(), self.y.mean(), self.other]])
            bottom, foot = top[rim], index.size + np.arange(len(rim))
            bottom[:, 2] = self.other
            bottom = np.concatenate([bottom, middle])
            center = np.full(len(rim), foot[-1] + 1)
            closing = np.column_stack([center, np.roll(foot, -1), foot])
        next_rim, next_foot = np.roll(rim, -1), np.roll(foot, -1)
        walls = [(rim, foot, next_foot), (rim, next_foot, next_rim)]
        found = np.concatenate([_cells(index), *map(np.column_stack, walls), closing])
        if self.other.flat[0] > self.z.flat[0]:  # the face looks down
            found = found[:, ::-1]
        return TriangleBody(scale * np.concatenate([top, bottom]), found)

    def _places(self, z: Array) -> Array:
        return np.stack(np.broadcast_arrays(self.x, self.y, z), axis=-1).reshape(-1, 3)

    def chord_error(self, design: Design) -> float:
        """Largest distance, along z, between triangles and faces, on a grid in each cell."""
        error = self._error_of_mapped if design.rectangle is None else self._error_of_rectangles
        return max(error(face, z) for face, z in zip(design.faces, self._freeform(), strict=True))

    def _freeform(self) -> Iterator[Array]:
        yield self.z
        if self.other.ndim:
            yield self.other

    def _error_of_rectangles(self, face: Design, z: Array) -> float:
        x, y = _subdivided(self.x[:, 0]), _subdivided(self.y[0])
        by_column = face.heights @ face.basis(x[:1], y).along_y
        u = (x / face.net.half_width[0] + 1) / 2
        first, along_x = local_basis(face.net.knots[0], face.net.degree[0], u)
        row = first[:, None] + np.arange(along_x.shape[1])
        # Places in a cell: s along x, t along y, j the cell's column.
        s = np.linspace(0, 1, _PARTS + 1)[:, None]
        j = np.minimum(np.arange(by_column.shape[1]) // _PARTS, z.shape[1] - 2)
        t = np.arange(by_column.shape[1]) / _PARTS - j
        high, low = np.maximum(s, t), np.minimum(s, t)
        largest = 0.0
        for i, (near, far) in enumerate(pairwise(z)):
            # Below the diagonal a triangle has the cell's corner at +x, above it that at +y.
            third = np.where(s > t, far[j], near[j + 1])
            flat = near[j] + high * (third - near[j]) + low * (far[j + 1] - third)
            places = slice(i * _PARTS, (i + 1) * _PARTS + 1)
            exact = np.einsum("kp,kpj->kj", along_x[places], by_column[row[places]])
            largest = max(largest, float(np.abs(flat - exact).max()))
        return largest

    def _error_of_mapped(self, face: Design, z: Array) -> float:
        places = np.stack(np.broadcast_arrays(self.x, self.y, z), axis=-1)
        a, b, c, d = places[:-1, :-1], places[1:, :-1], places[1:, 1:], places[:-1, 1:]
        largest = 0.0
        for i in range(_PARTS + 1):
            for j in range(_PARTS + 1 - i):
                s, t = i / _PARTS, j / _PARTS
                for corner in (b, d):
                    x, y, flat = np.moveaxis((1 - s - t) * corner + s * a + t * c, -1, 0)
                    exact = face.net.at(x, y, face.heights)[0]
                    largest = max(largest, float(np.abs(flat - exact).max()))
        return largest


def _other(design: Design, freeform: list[Array]) -> Array:
    return freeform[0] if freeform else np.array(design.flat_z)


def _cells(index: Indices) -> Indices:
    corners = (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:])
    a, b, c, d = (corner.ravel() for corner in corners)
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def _strips(design: Design, axis: int, allowed: float) -> tuple[Array, Array]:
    ends = np.unique(np.concatenate([face.net.knots[axis] for face in design.faces]))
    width, middle = np.diff(ends), (ends[1:] + ends[:-1]) / 2
    steps = np.ones(len(middle))
    for face in design.faces:
        curvature = _most(face, (2, 0) if axis == 0 else (0, 2)) + _most(face, (1, 1))
        sharpest = curvature.max(axis=1 - axis)
        sharpest = sharpest[(middle * len(sharpest)).astype(int)]
        length = 2 * face.net.half_width[axis] * width
        steps = np.maximum(steps, np.ceil(length * np.sqrt(sharpest / (4 * allowed))))
    return ends, steps


def _check_cells(cells: float, design: Design) -> None:
    if cells > _MOST_CELLS:
        largest = design.largest_chord_error
        raise Refused(
            "--chord-error",
            Message(
                "{largest:.3g} {unit} takes {triangles:.0f} triangles, more than "
                "{most}; about {possible:.2g} is possible",
                largest=largest,
                unit=design.unit,
                triangles=2 * cells,
                most=2 * _MOST_CELLS,
                possible=1.1 * largest * cells / _MOST_CELLS,
            ),
        )


def _most(face: Design, order: tuple[int, int]) -> Array:
    low, high = derivative_range(face.net, face.heights, order)
    return np.maximum(np.abs(low), np.abs(high))


def _rounding(face: Design, precision: float) -> float:
    sideways = sum(
        r * np.abs(np.diff(heights, axis=0) / np.diff(places)[:, None]).max()
        for r, heights, places in zip(
            face.net.half_width, (face.heights, face.heights.T), face.net.positions, strict=True
        )
    )
    return precision * float(np.abs(face.heights).max() + sideways)


def _divided(ends: Array, steps: npt.NDArray[np.int_]) -> Array:
    parts = [
        low + (high - low) * (np.arange(k) / k)
        for (low, high), k in zip(pairwise(ends), steps, strict=True)
    ]
    return np.concatenate([*parts, ends[-1:]])


def _between(places: Array, low: float, high: float) -> Array:
    """Places of a part, with its ends but without slivers beside them."""
    sliver = _SLIVER * (high - low)
    inner = places[(places > low + sliver) & (places < high - sliver)]
    return np.concatenate([[low], inner, [high]])


def _subdivided(places: Array) -> Array:
    within = np.arange(_PARTS) / _PARTS
    fine = places[:-1, None] + np.diff(places)[:, None] * within
    return np.append(fine.ravel(), places[-1])
