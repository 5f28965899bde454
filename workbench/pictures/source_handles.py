"""Handles of a point source or a grid of them, by which it is moved and widened."""

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from workbench.pictures import shapes
from workbench.pictures.dots import Dots
from workbench.pictures.sight import Sight
from workbench.scene import CollimatedSource, GridSource, PointSource, Source

Array = npt.NDArray[np.float64]
Handle = Literal["middle"] | int
"""The whole source, or the number of a corner of a grid."""

_COLOUR = {True: "#ffffff", False: "#000000"}  # by dark
_SIZE = 11.0  # pixels
_REACH = 14.0  # pixels; farther away nothing is picked
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
        self.recolour(dark)

    def show(self, source: Source | None) -> None:
        """Show the handles of a source; collimated light has none."""
        self._source = source
        self._dots.place(np.zeros((0, 3)) if source is None else _handles(source))

    def recolour(self, dark: bool) -> None:
        """Change between the dark and the light ground."""
        self._dots.colour(_COLOUR[dark])

    def pick(self, x: float, y: float) -> Handle | None:
        """What is under a place in the window, pixels from the lower left; None for nothing."""
        source = self._source
        if source is None or isinstance(source, CollimatedSource):
            return None
        if isinstance(source, GridSource):
            corner = self._nearest(shapes.source_points(source, (2, 2)), x, y)
            if corner is not None and max(source.points) > 1:
                return corner
        inside = self._nearest(shapes.source_points(source, _INSIDE), x, y)
        return None if inside is None else "middle"

    def _nearest(self, points: Array, x: float, y: float) -> int | None:
        away = np.hypot(*(self._sight.pixels(points) - (x, y)).T)
        return int(away.argmin()) if away.min() <= _REACH else None


def moved(source: Source, handle: Handle, by: Array, digits: int) -> Source:
    """The source after one of its handles was dragged.

    Parameters
    ----------
    source : PointSource or GridSource
        The source before.
    handle : Handle
        What was dragged: a corner widens or narrows a grid on both sides of its middle.
    by : ndarray, shape (3,)
        How far, scene units.
    digits : int
        Decimals that the new lengths have.
    """
    if isinstance(source, CollimatedSource):
        return source
    if isinstance(source, PointSource):
        return source.model_copy(update={"position": _rounded(source.position + by, digits)})
    if handle == "middle":
        return source.model_copy(update={"center": _rounded(source.center + by, digits)})
    corner = shapes.source_points(source, (2, 2))[handle] + by
    wide = _rounded(np.abs(corner - source.center), digits)
    # Along an axis with a single point there is nothing to widen.
    axes = zip(wide, source.half_width, source.points, strict=False)
    return source.model_copy(
        update={"half_width": tuple(new if count > 1 else old for new, old, count in axes)}
    )


def _rounded(lengths: Array, digits: int) -> tuple[float, ...]:
    return tuple((np.round(lengths, digits) + 0.0).tolist())  # without -0


def _handles(source: Source) -> Array:
    """Corners of a grid and its middle; a point is its own handle."""
    if isinstance(source, GridSource):
        corners = shapes.source_points(source, (2, 2))
        return np.vstack([corners, source.center])
    return shapes.source_points(source, (1, 1))
