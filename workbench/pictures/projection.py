"""Projection between scene points and window pixels.

Pixels are counted from the lower left corner, as in VTK.
"""

from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCellPicker

from workbench.arrays import Array

_STEP = 1e-3  # of the height of the picture, for finite differences
_SNAP = 6.0  # pixels to a vertex
_HEAD_ON = 0.15  # a direction seen shorter than this part of its length counts as head-on


class Projection:
    """Projection of the camera of a plotter of the caller."""

    def __init__(self, plotter: Any) -> None:
        self._renderer = plotter.renderer

    def line(self, x: float, y: float) -> tuple[Array, Array]:
        """Return the ends of the line of sight through a pixel, at the clipping planes."""
        renderer, ends = self._renderer, []
        for depth in (0.0, 1.0):
            renderer.SetDisplayPoint(x, y, depth)
            renderer.DisplayToWorld()
            *point, scale = renderer.GetWorldPoint()
            ends.append(np.array(point) / scale)
        return ends[0], ends[1]

    def point(self, x: float, y: float) -> Array:
        """Return the point of a body at a pixel; without a body, of the focal plane."""
        picker = self._picked(x, y)
        if picker is not None:
            return np.array(picker.GetPickPosition())
        camera = self._renderer.GetActiveCamera()
        (start, end), ahead = self.line(x, y), np.array(camera.GetDirectionOfProjection())
        part = (camera.GetFocalPoint() - start) @ ahead / ((end - start) @ ahead)
        return np.asarray(start + part * (end - start))

    def corner(self, x: float, y: float) -> Array | None:
        """Return the point of a body at a pixel, or a vertex of its mesh close to it."""
        picker = self._picked(x, y)
        if picker is None:
            return None
        place = np.array(picker.GetPickPosition())
        vertex = picker.GetDataSet().GetPoint(picker.GetPointId())
        corner = np.array(picker.GetActor().GetMatrix().MultiplyPoint((*vertex, 1.0))[:3])
        return corner if self.away(corner[None], x, y)[0] <= _SNAP else place

    def _picked(self, x: float, y: float) -> vtkCellPicker | None:
        picker = vtkCellPicker()
        picker.SetTolerance(0.0)
        return picker if picker.Pick(x, y, 0.0, self._renderer) else None

    def pixels(self, points: Array) -> Array:
        """Return the pixels (n, 2) of points (n, 3)."""
        renderer = self._renderer
        seen = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            renderer.GetTiledAspectRatio(), 0, 1
        )
        matrix = np.array([[seen.GetElement(i, j) for j in range(4)] for i in range(4)])
        x, y, _, scale = matrix @ np.column_stack([points, np.ones(len(points))]).T
        # From -1 … 1 across the window.
        across = (np.column_stack([x / scale, y / scale]) + 1) / 2
        return np.asarray(across * renderer.GetSize())

    def away(self, points: Array, x: float, y: float) -> Array:
        """Return how many pixels (n,) points (n, 3) are seen from a pixel."""
        return np.asarray(np.linalg.norm(self.pixels(points) - (x, y), axis=1))

    def movement(self, point: Array, directions: Array, moved: tuple[float, float]) -> Array:
        """Return the lengths (k,) by which an object follows the pointer.

        `point` (3,): position of the object; `directions` (k, 3): one or two unit vectors of
        allowed movement; `moved`: movement of the pointer in pixels, to the right and up. Returns
        (k,): scene units; 0 along a direction seen head-on beside another. A single direction seen
        head-on is taken to point upwards in the picture.
        """
        camera = self._renderer.GetActiveCamera()
        up = np.array(camera.GetViewUp())
        step = _STEP * camera.GetDistance()
        if camera.GetParallelProjection():
            step = _STEP * camera.GetParallelScale()
        ends = point + step * np.vstack([directions, up])
        here, *there = self.pixels(np.vstack([point, ends]))
        *seen, upwards = (np.array(there) - here) / step  # pixels for one scene unit
        scale = float(np.linalg.norm(upwards))
        if len(seen) == 1 and np.linalg.norm(seen[0]) < _HEAD_ON * scale:
            seen = [upwards]
        return np.asarray(np.linalg.pinv(np.array(seen).T, rcond=_HEAD_ON) @ np.array(moved))


def nearest_to_line(points: Array, start: Array, end: Array) -> tuple[tuple[int, ...], float]:
    """Return the index of the point of (..., 3) nearest to a line, and its distance."""
    direction = (end - start) / np.linalg.norm(end - start)
    away = points - start
    away = away - (away @ direction)[..., None] * direction
    distances = np.linalg.norm(away, axis=-1)
    index = np.unravel_index(int(distances.argmin()), distances.shape)
    return tuple(int(i) for i in index), float(distances[index])
