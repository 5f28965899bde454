"""Control points of the exit face in three dimensions: one can be picked, and is marked.

The marked point is shown with those that share a piece of the face with it. All of a fine net would
hide the lens.
"""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pyvista as pv

from workbench.geometry.lines import nearest_to_line
from workbench.geometry.surface import ControlNet
from workbench.scene import Lens

Array = npt.NDArray[np.float64]

_POINT = {True: "#c9d2de", False: "#2c3440"}  # by dark
_MARK = {True: "#ff7ad9", False: "#c2188f"}  # neither of light nor of glass
_SIZES = 4.0, 13.0  # of points and of the marked one, in pixels
_LIFT = 0.004  # of the lens's half-width, above the face that would swallow half of each point
_REACH = 0.75  # of the diagonal between neighbours; farther away nothing is picked


class ControlNetPicture:
    """Draws control points of a lens on a plotter that the caller owns; none at first.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Where the lens is drawn.
    lens : Lens
        Says where the control points are along x and y.
    dark : bool
        Whether the ground is dark.
    """

    def __init__(self, plotter: Any, lens: Lens, *, dark: bool = False) -> None:
        self._plotter = plotter
        x, y = ControlNet.of(lens).positions
        self._places = np.zeros((len(x), len(y), 3))
        self._places[..., 0], self._places[..., 1] = x[:, None], y
        self._reach = _REACH * math.hypot(np.diff(x).max(), np.diff(y).max())
        self._lift = np.array([0.0, 0.0, _LIFT * max(lens.half_width)])
        self._marked: tuple[int, int] | None = None
        self._degree = lens.degree
        self._near, self._mark = pv.PolyData([[0.0] * 3]), pv.PolyData([[0.0] * 3])
        self._actors = [self._add(self._near, _SIZES[0]), self._add(self._mark, _SIZES[1])]
        self.update(self._places[..., 2])
        self.mark(None)
        self.recolour(dark)

    def update(self, heights: Array) -> None:
        """Move the points to their heights z, shape (n_u, n_v), scene units."""
        self._places[..., 2] = heights
        self._place()

    def mark(self, index: tuple[int, int] | None) -> None:
        """Show one of the points and its neighbours, or none at all."""
        self._marked = index
        for actor in self._actors:
            actor.SetVisibility(index is not None)
        self._place()

    def pick(self, x: float, y: float) -> tuple[int, int] | None:
        """The control point under a place in the window, while one is marked.

        Parameters
        ----------
        x, y : float
            Pixels from the lower left corner.

        Returns
        -------
        tuple[int, int] or None
            Index of the point along x and y that is nearest to the line of sight; None where no
            point is near it.
        """
        if self._marked is None:
            return None
        (i, j), distance = nearest_to_line(self._places, *self._line_of_sight(x, y))
        return (i, j) if distance <= self._reach else None

    def recolour(self, dark: bool) -> None:
        """Change between the dark and the light ground."""
        for actor, colours in zip(self._actors, (_POINT, _MARK), strict=True):
            actor.prop.color = colours[dark]

    def _add(self, mesh: pv.PolyData, size: float) -> Any:
        return self._plotter.add_mesh(
            mesh,
            style="points",
            point_size=size,
            render_points_as_spheres=True,
            lighting=False,
            copy_mesh=False,
            show_scalar_bar=False,
            reset_camera=False,
            render=False,
        )

    def _place(self) -> None:
        if self._marked is None:
            return
        i, j = self._marked
        p, q = self._degree
        near = self._places[max(i - p, 0) : i + p + 1, max(j - q, 0) : j + q + 1].reshape(-1, 3)
        self._near.points = near + self._lift
        if self._near.n_verts != len(near):
            self._near.verts = np.insert(np.arange(len(near)), np.arange(len(near)), 1)
        self._mark.points = (self._places[i, j] + self._lift)[None]

    def _line_of_sight(self, x: float, y: float) -> tuple[Array, Array]:
        """Where it enters and leaves what the camera sees."""
        renderer, ends = self._plotter.renderer, []
        for depth in (0.0, 1.0):
            renderer.SetDisplayPoint(x, y, depth)
            renderer.DisplayToWorld()
            *point, scale = renderer.GetWorldPoint()
            ends.append(np.array(point) / scale)
        return ends[0], ends[1]
