"""What the camera sees where: between places of the scene and pixels of the window.

Pixels are counted from the lower left corner, as VTK does.
"""

from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCellPicker

from workbench.arrays import Array

_STEP = 1e-3  # of what the picture is high, to see how far a direction leads in it
_HEAD_ON = 0.15  # a direction seen shorter than this part of its length leads nowhere


class Sight:
    """Looks through the camera of a plotter that the caller owns.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Has a window, shown or off screen.
    """

    def __init__(self, plotter: Any) -> None:
        self._renderer = plotter.renderer

    def line(self, x: float, y: float) -> tuple[Array, Array]:
        """Where the line of sight through a pixel enters and leaves what the camera sees."""
        renderer, ends = self._renderer, []
        for depth in (0.0, 1.0):
            renderer.SetDisplayPoint(x, y, depth)
            renderer.DisplayToWorld()
            *point, scale = renderer.GetWorldPoint()
            ends.append(np.array(point) / scale)
        return ends[0], ends[1]

    def point(self, x: float, y: float) -> Array:
        """The point seen at a pixel: of a body, else of the plane through the focal point."""
        picker = vtkCellPicker()
        picker.SetTolerance(0.0)
        if picker.Pick(x, y, 0.0, self._renderer):
            return np.array(picker.GetPickPosition())
        camera = self._renderer.GetActiveCamera()
        (start, end), ahead = self.line(x, y), np.array(camera.GetDirectionOfProjection())
        part = (camera.GetFocalPoint() - start) @ ahead / ((end - start) @ ahead)
        return np.asarray(start + part * (end - start))

    def pixels(self, points: Array) -> Array:
        """Where points of the scene are seen.

        Parameters
        ----------
        points : ndarray, shape (n, 3)
            Scene units.

        Returns
        -------
        ndarray, shape (n, 2)
        """
        renderer = self._renderer
        seen = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            renderer.GetTiledAspectRatio(), 0, 1
        )
        matrix = np.array([[seen.GetElement(i, j) for j in range(4)] for i in range(4)])
        x, y, _, scale = matrix @ np.column_stack([points, np.ones(len(points))]).T
        # From -1 … 1 across the window.
        across = (np.column_stack([x / scale, y / scale]) + 1) / 2
        return np.asarray(across * renderer.GetSize())

    def movement(self, point: Array, directions: Array, moved: tuple[float, float]) -> Array:
        """How far something goes along given directions as it follows the pointer.

        Parameters
        ----------
        point : ndarray, shape (3,)
            Where it is.
        directions : ndarray, shape (k, 3)
            Unit vectors that it may move along, one or two.
        moved : tuple[float, float]
            How far the pointer has gone, pixels to the right and up.

        Returns
        -------
        ndarray, shape (k,)
            Lengths along the directions, scene units; 0 along one that is seen head-on beside
            another. A single one seen head-on is taken to lead upwards in the picture.
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
