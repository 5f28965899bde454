"""Handles for moving and resizing a point source or a grid of point sources.

The handles of a source that is small on screen stand beside it, so that the source itself can still
be dragged. They follow the camera: each rendering places them anew.
"""

import weakref
from typing import Any, Literal

import numpy as np

from workbench.arrays import Array
from workbench.pictures.actors import PointMarkers
from workbench.pictures.projection import Projection
from workbench.scene import Source

Handle = Literal["middle"] | int
"""The whole source, or the number of a corner of a grid."""

_COLOUR = {True: "#ffffff", False: "#000000"}  # by dark
_SIZE = 11.0  # pixels
_PICK_DISTANCE = 14.0  # pixels; farther away nothing is picked
_CORNER_DISTANCE = 3 * _PICK_DISTANCE  # least pixels from the middle to a corner handle
_INSIDE = (9, 9)  # points of a grid, along x and y, that drag the whole grid


class SourceHandles:
    """Draws handles of a source on a plotter of the caller; none at first."""

    def __init__(self, plotter: Any, *, dark: bool = False) -> None:
        self._markers = PointMarkers(plotter, _SIZE, round=False)
        self._projection = Projection(plotter)
        self._source: Source | None = None
        self._renderer, handles = plotter.renderer, weakref.ref(self)

        def follow(*_: object) -> None:
            if (present := handles()) is not None:
                present._place()

        self._observer = self._renderer.AddObserver("StartEvent", follow)
        self.recolour(dark)

    def show(self, source: Source | None) -> None:
        """Show the handles of a source; a collimated source has none."""
        self._source = source
        self._place()

    def close(self) -> None:
        """Stop following the camera."""
        self._renderer.RemoveObserver(self._observer)

    def recolour(self, dark: bool) -> None:
        """Change between dark and light background."""
        self._markers.colour(_COLOUR[dark])

    def pick(self, x: float, y: float) -> Handle | None:
        """Return the handle at a pixel from the lower left; None if there is none."""
        source = self._source
        if source is None:
            return None
        corner = self._nearest(self._corner_handles(source), x, y)
        if corner is not None:
            return corner
        return None if self._nearest(source.seen(_INSIDE), x, y) is None else "middle"

    def _place(self) -> None:
        source = self._source
        if source is None or source.place is None:
            self._markers.place(np.zeros((0, 3)))
        else:
            self._markers.place(np.vstack([self._corner_handles(source), source.place]))

    def _corner_handles(self, source: Source) -> Array:
        corners = source.corners
        if source.place is None or not len(corners):
            return corners
        place = np.array(source.place)
        *seen, middle = self._projection.pixels(np.vstack([corners, place]))
        away = np.linalg.norm(np.array(seen) - middle, axis=1)
        # A corner seen at the middle itself has no direction on screen.
        times = np.where(away > 0, np.maximum(1, _CORNER_DISTANCE / np.maximum(away, 1e-9)), 1)
        return np.asarray(place + times[:, None] * (corners - place))

    def _nearest(self, points: Array, x: float, y: float) -> int | None:
        if not len(points):
            return None
        away = np.hypot(*(self._projection.pixels(points) - (x, y)).T)
        return int(away.argmin()) if away.min() <= _PICK_DISTANCE else None


def moved(source: Source, handle: Handle, by: Array, digits: int) -> Source:
    """Return the source after one of its handles was dragged by a vector (3,).

    A corner widens or narrows a grid on both sides of its middle. ``digits`` is the number of
    decimals of the new lengths.
    """
    if source.place is None:
        return source
    if handle == "middle":
        x, y, z = (np.round(np.add(source.place, by), digits) + 0.0).tolist()  # without -0
        return source.placed((x, y, z))
    return source.widened(source.corners[handle] + by, digits)
