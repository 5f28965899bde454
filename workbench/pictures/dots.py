"""Marks of one size in pixels at places of a scene."""

from typing import Any

import numpy as np
import pyvista as pv

from workbench.arrays import Array


class Dots:
    """Points on a plotter that the caller owns; none at first.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Where they are drawn.
    size : float
        Pixels.
    round : bool
        Balls rather than squares.
    """

    def __init__(self, plotter: Any, size: float, *, round: bool = True) -> None:
        self._mesh = pv.PolyData(np.zeros((1, 3)))
        self._actor = plotter.add_mesh(
            self._mesh,
            style="points",
            point_size=size,
            render_points_as_spheres=round,
            lighting=False,
            copy_mesh=False,
            show_scalar_bar=False,
            reset_camera=False,
            render=False,
        )
        self.place(np.zeros((0, 3)))

    def place(self, points: Array) -> None:
        """Show them at other places, shape (n, 3), scene units."""
        self._actor.SetVisibility(len(points) > 0)
        if not len(points):  # VTK takes no empty arrays
            return
        self._mesh.points = points
        if self._mesh.n_verts != len(points):
            self._mesh.verts = np.insert(np.arange(len(points)), np.arange(len(points)), 1)

    def resize(self, size: float) -> None:
        """Draw them larger or smaller, in pixels."""
        self._actor.prop.point_size = size

    def colour(self, colour: str) -> None:
        """Draw them in another colour."""
        self._actor.prop.color = colour
