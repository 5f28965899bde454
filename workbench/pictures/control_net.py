"""Control points of a face in the 3D view: show, pick, mark, brush, lock.

1. A fine net would hide the lens. Of a fine net only the neighbourhood of the brush is shown, and
   without a brush only the locked points. The size of points follows their distance on screen.
2. Locked points are squares, others are spheres: colour alone does not distinguish them.
"""

import math
from typing import Any

import numpy as np
import pyvista as pv

from workbench.arrays import Array, Mask
from workbench.design.brush import bump
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.pictures import meshes
from workbench.pictures.actors import PointMarkers, add_to
from workbench.pictures.projection import Projection, nearest_to_line
from workbench.scene import Element

Block = tuple[slice, slice]

_POINT = {True: "#c9d2de", False: "#2c3440"}  # by dark
_MARK = {True: "#ff7ad9", False: "#c2188f"}  # neither the colour of light nor of glass
_BRUSH = {True: "#ffffff", False: "#000000"}
_LOCKED = {True: "#f0a202", False: "#9a4a00"}
_MARKED = 13.0  # size of the marked point in pixels
_LARGEST = 4.0, 8.0, 8.0  # pixels: points, points in the brush, locked points
_SMALLEST = 2.0, 3.0, 3.0
_PARTS = 0.25, 0.6, 0.6  # of the distance of neighbours
_LINES = 6.0  # least distance of neighbours in pixels with lines between them
_LIFT = 0.004  # of the half-width: lifts points off the face, which would hide half of each
_PICK_PART = 0.75  # of the diagonal between neighbours; farther away nothing is picked
_MOST_LOCKS = 40_000  # drawn; of more, every second or third
_WHOLE = 1200  # most control points of a net that is shown as a whole
_NEAR = 12  # control points shown on each side of the brush in a finer net


class ControlNetPicture:
    """Draws control points of a face on a plotter of the caller; none at first."""

    def __init__(self, plotter: Any, optic: Element, face: str, *, dark: bool = False) -> None:
        self._net = freeform_nets(optic)[face]
        self._optic = optic
        x, y = self._net.positions
        self._own = np.zeros((len(x), len(y), 3))  # in the coordinates of the element
        self._own[..., 0], self._own[..., 1] = x[:, None], y
        self._shaping = self._net.shaping(outline_of(optic))  # others are not shown
        self._pick_distance = _PICK_PART * math.hypot(np.diff(x).max(), np.diff(y).max())
        self._lift = _LIFT * max(optic.half_width) * optic.outwards(face) * optic.turn[:, 2]
        self._shown = False
        self._marked: tuple[int, int] | None = None
        self._brush: tuple[tuple[int, int], float] | None = None
        self._locked: Mask | None = None
        self._drawn = np.zeros((0, 0), dtype=np.bool_)  # points of the block with lines
        self._lines = pv.PolyData(np.zeros((2, 3)), lines=[2, 0, 1])
        self._net_lines = add_to(plotter, self._lines, line_width=1.0, opacity=0.5, lighting=False)
        self._mark = PointMarkers(plotter, _MARKED)
        self._points, self._brushed = (
            PointMarkers(plotter, _LARGEST[0]),
            PointMarkers(plotter, _LARGEST[1]),
        )
        self._locks = PointMarkers(plotter, _LARGEST[2], round=False)
        self._projection = Projection(plotter)
        self.update(self._own[..., 2])
        self.recolour(dark)

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of control points (n_u, n_v)."""
        return self._net.shape

    def places(self, which: Any) -> Array:
        """Positions (..., 3) of some control points, scene units; ``which`` is an index of numpy.

        Those of a whole fine net would take longer than all else of a new picture.
        """
        return self._optic.in_scene(self._own[which])

    def update(self, heights: Array) -> None:
        """Set the control heights z, (n_u, n_v), scene units."""
        self._own[..., 2] = heights
        self._resize()
        self._place()

    def show(self, shown: bool) -> None:
        """Show net and locks for picking, or only the marked point."""
        if shown != self._shown:
            self._shown = shown
            self._place()

    def mark(self, index: tuple[int, int] | None) -> None:
        """Show one point with its neighbours for picking; None hides it."""
        if index != self._marked:
            self._marked = index
            self._place()

    def brush(self, index: tuple[int, int] | None, radius: float = 0.0) -> None:
        """Show the points within a radius (scene units) of a control point."""
        brush = None if index is None else (index, radius)
        if brush != self._brush:
            self._brush = brush
            self._place()

    def lock(self, locked: Mask | None) -> None:
        """Set the locked points, (n_u, n_v)."""
        if locked is not self._locked:
            self._locked = locked
            self._place()

    def pick(self, x: float, y: float) -> tuple[int, int] | None:
        """Return the index of the control point nearest to a window pixel; None if none is near."""
        start, end = map(self._optic.seen, self._projection.line(x, y))
        block = self._along(start, end)
        if block is None:
            return None
        (i, j), distance = nearest_to_line(self._own[block], start, end)
        index = block[0].start + i, block[1].start + j
        return index if distance <= self._pick_distance and self._shaping[index] else None

    def recolour(self, dark: bool) -> None:
        """Change between dark and light background."""
        self._net_lines.prop.color = _POINT[dark]
        self._points.colour(_POINT[dark])
        self._mark.colour(_MARK[dark])
        self._brushed.colour(_BRUSH[dark])
        self._locks.colour(_LOCKED[dark])

    def _along(self, start: Array, end: Array) -> Block | None:
        margin, z = self._pick_distance, self._own[..., 2]
        rise = end[2] - start[2]
        if rise != 0:  # between the lowest and the highest point
            low, high = z.min() - margin, z.max() + margin
            near, far = np.clip(sorted(((low - start[2]) / rise, (high - start[2]) / rise)), 0, 1)
            start, end = start + near * (end - start), start + far * (end - start)
        block = []
        for axis, at in enumerate(self._net.positions):
            low, high = sorted((start[axis], end[axis]))
            first = int(np.searchsorted(at, low - margin))
            last = int(np.searchsorted(at, high + margin, side="right"))
            if first >= last:
                return None
            block.append(slice(first, last))
        return block[0], block[1]

    def _resize(self) -> None:
        i, j = (count // 2 for count in self._net.shape)
        here, *there = self._projection.pixels(self.places(([i, i - 1, i], [j, j, j - 1])))
        self._spacing = max(float(np.linalg.norm(seen - here)) for seen in there)
        kinds = (self._points, self._brushed, self._locks)
        for dots, part, low, high in zip(kinds, _PARTS, _SMALLEST, _LARGEST, strict=True):
            dots.resize(min(max(part * self._spacing, low), high))

    def _place(self) -> None:
        places, lift = self.places, self._lift
        block, none = self._block(), np.zeros((0, 3))
        near = none if block is None else places(block).reshape(-1, 3) + lift
        self._draw_lines(block, near)
        locked = self._locked if self._shown else None
        if block is not None:
            hidden = ~self._shaping if locked is None else ~self._shaping | locked
            near = near[~hidden[block].ravel()]
        self._points.place(near)
        self._mark.place(none if self._marked is None else places(self._marked)[None] + lift)
        brushed = none
        if self._brush is not None:
            reached, weights = bump(self._net, *self._brush)
            brushed = places(reached)[(weights > 0) & self._shaping[reached]] + 2 * lift
        self._brushed.place(brushed)
        held = none if locked is None else places(locked & self._shaping)
        self._locks.place(held[:: 1 + len(held) // _MOST_LOCKS] + 2 * lift)

    def _block(self) -> Block | None:
        if self._shown and math.prod(self.shape) <= _WHOLE:
            return slice(None), slice(None)
        if self._shown:
            return None if self._brush is None else _neighbourhood(self._brush[0], (_NEAR, _NEAR))
        return None if self._marked is None else _neighbourhood(self._marked, self._net.degree)

    def _draw_lines(self, block: Block | None, points: Array) -> None:
        shaping = self._shaping[:0] if block is None else self._shaping[block]
        shown = self._shown and min(shaping.shape) > 1 and self._spacing >= _LINES
        self._net_lines.SetVisibility(shown)
        if not shown:
            return
        self._lines.points = points
        if not np.array_equal(shaping, self._drawn):
            self._drawn = shaping
            self._lines.lines = meshes.grid_lines(shaping)
            self._lines.verts = np.zeros(0, dtype=np.int64)


def _neighbourhood(index: tuple[int, int], margin: tuple[int, int]) -> Block:
    i, j = (slice(max(k - r, 0), k + r + 1) for k, r in zip(index, margin, strict=True))
    return i, j
