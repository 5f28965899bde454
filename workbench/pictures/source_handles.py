"""Handles of a point source or a grid of them, by which it is moved and widened.

Handles of a source that is small in the picture stand beside it, so that the source itself is left
to be moved. They follow the camera: each rendering places them anew.
"""

import weakref
from typing import Any, Literal

import numpy as np

from workbench.arrays import Array
from workbench.pictures.dots import Dots
from workbench.pictures.sight import Sight
from workbench.scene import Source

Handle = Literal["middle"] | int
"""The whole source, or the number of a corner of a grid."""

_COLOUR = {True: "#ffffff", False: "#000000"}  # by dark
_SIZE = 11.0  # pixels
_PICK_DISTANCE = 14.0  # pixels; farther away nothing is picked
_BESIDE = 3 * _PICK_DISTANCE  # pixels from the middle to a handle of a corner, at least
_INSIDE = (9, 9)  # places of a grid, along x and y, that are as good as its middle


class SourceHandles:
    """Draws handles on a plotter that the caller owns; none at first.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Where the scene is drawn.
    dark : bool
        Whether the ground is dark.
    """

    def __init__(self, plotter: Any, *, dark: bool = False) -> None:
        self._dots = Dots(plotter, _SIZE, round=False)
        self._sight = Sight(plotter)
        self._source: Source | None = None
        self._renderer, handles = plotter.renderer, weakref.ref(self)

        def follow(*_: object) -> None:
            if (present := handles()) is not None:
                present._place()

        self._observer = self._renderer.AddObserver("StartEvent", follow)
        self.recolour(dark)

    def show(self, source: Source | None) -> None:
        """Show the handles of a source; collimated light has none."""
        self._source = source
        self._place()

    def close(self) -> None:
        """Follow the camera no more."""
        self._renderer.RemoveObserver(self._observer)

    def recolour(self, dark: bool) -> None:
        """Change between the dark and the light ground."""
        self._dots.colour(_COLOUR[dark])

    def pick(self, x: float, y: float) -> Handle | None:
        """What is under a place in the window, pixels from the lower left; None for nothing."""
        source = self._source
        if source is None:
            return None
        corner = self._nearest(self._beside(source), x, y)
        if corner is not None:
            return corner
        return None if self._nearest(source.seen(_INSIDE), x, y) is None else "middle"

    def _place(self) -> None:
        source = self._source
        if source is None or source.place is None:
            self._dots.place(np.zeros((0, 3)))
        else:
            self._dots.place(np.vstack([self._beside(source), source.place]))

    def _beside(self, source: Source) -> Array:
        """Places of the handles of the corners, shape (n, 3): no nearer than `_BESIDE`."""
        corners = source.corners
        if source.place is None or not len(corners):
            return corners
        place = np.array(source.place)
        *seen, middle = self._sight.pixels(np.vstack([corners, place]))
        away = np.linalg.norm(np.array(seen) - middle, axis=1)
        # A corner that is seen on the middle itself leads nowhere.
        times = np.where(away > 0, np.maximum(1, _BESIDE / np.maximum(away, 1e-9)), 1)
        return np.asarray(place + times[:, None] * (corners - place))

    def _nearest(self, points: Array, x: float, y: float) -> int | None:
        if not len(points):
            return None
        away = np.hypot(*(self._sight.pixels(points) - (x, y)).T)
        return int(away.argmin()) if away.min() <= _PICK_DISTANCE else None


def moved(source: Source, handle: Handle, by: Array, digits: int) -> Source:
    """The source after one of its handles was dragged.

    Parameters
    ----------
    source : Source
        The source before.
    handle : Handle
        What was dragged: a corner widens or narrows a grid on both sides of its middle.
    by : ndarray, shape (3,)
        How far, scene units.
    digits : int
        Decimals that the new lengths have.
    """
    if source.place is None:
        return source
    if handle == "middle":
        x, y, z = (np.round(np.add(source.place, by), digits) + 0.0).tolist()  # without -0
        return source.placed((x, y, z))
    return source.widened(source.corners[handle] + by, digits)
