"""Handles for moving and resizing a point source or a grid, and for elements and the screen.

The handles of a source that is small on screen stand beside it, so that the source itself can still
be dragged. They follow the camera: each rendering places them anew.
"""

import weakref
from typing import Any, Literal, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.pictures.actors import PointMarkers
from workbench.pictures.projection import Projection
from workbench.scene import Scene, Source


class ElementHandle(NamedTuple):
    """An element of the train, by its number."""

    number: int


Handle = Literal["middle", "screen"] | int | ElementHandle
"""The whole source, the screen, the number of a corner of a grid, or an element."""

_COLOUR = {True: "#ffffff", False: "#000000"}  # by dark
_SIZE = 11.0  # pixels
_PICK_DISTANCE = 14.0  # pixels; farther away nothing is picked
_CORNER_DISTANCE = 3 * _PICK_DISTANCE  # least pixels from the middle to a corner handle
_NOWHERE: Array = np.zeros((0, 3))
_INSIDE = (9, 9)  # points of a grid, along x and y, that drag the whole grid


class SourceHandles:
    """Draws handles of a source and of elements on a plotter of the caller; none at first."""

    def __init__(self, plotter: Any, *, dark: bool = False) -> None:
        self._markers = PointMarkers(plotter, _SIZE, round=False)
        self._projection = Projection(plotter)
        self._source: Source | None = None
        self._elements = self._screen = _NOWHERE
        self._renderer, handles = plotter.renderer, weakref.ref(self)

        def follow(*_: object) -> None:
            if (present := handles()) is not None:
                present._place()

        self._observer = self._renderer.AddObserver("StartEvent", follow)
        self.recolour(dark)

    def show(
        self, source: Source | None, elements: Array = _NOWHERE, screen: Array = _NOWHERE
    ) -> None:
        """Show the handles of a source, of elements at places (n, 3), of a screen at (0 or 1, 3).

        A collimated source has none.
        """
        self._source, self._elements, self._screen = source, elements, screen
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
        if source is not None:
            corner = self._nearest(self._corner_handles(source), x, y)
            if corner is not None:
                return corner
            if self._nearest(source.seen(_INSIDE), x, y) is not None:
                return "middle"
        if self._nearest(self._screen, x, y) is not None:
            return "screen"
        element = self._nearest(self._elements, x, y)
        return None if element is None else ElementHandle(element)

    def _place(self) -> None:
        source, places = self._source, [self._elements, self._screen]
        if source is not None and source.place is not None:
            places += [self._corner_handles(source), np.array([source.place])]
        self._markers.place(np.vstack(places))

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


def moved(scene: Scene, handle: Handle, by: Array, digits: int) -> Scene:
    """Return the scene after one of its handles was dragged by a vector (3,); it is not checked.

    A corner widens or narrows a grid on both sides of its middle. ``digits`` is the number of
    decimals of the new lengths.
    """
    if isinstance(handle, ElementHandle):
        elements = list(scene.elements)
        element = elements[handle.number]
        place = _rounded(element.position, by, digits)
        elements[handle.number] = element.model_copy(update={"position": place})
        return scene.model_copy(update={"elements": tuple(elements)})
    if handle == "screen":
        z = round(scene.receiver.plane_z + float(by[2]), digits)
        return scene.with_receiver(scene.receiver.moved_to(z))
    source = scene.source
    if source.place is None:
        return scene
    if handle == "middle":
        source = source.placed(_rounded(source.place, by, digits))
    else:
        source = source.widened(source.corners[handle] + by, digits)
    return scene.model_copy(update={"source": source})


def _rounded(
    place: tuple[float, float, float], by: Array, digits: int
) -> tuple[float, float, float]:
    x, y, z = (np.round(np.add(place, by), digits) + 0.0).tolist()  # without -0
    return x, y, z
