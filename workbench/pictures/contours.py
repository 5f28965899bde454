"""Lines of equal light over an image."""

from typing import TYPE_CHECKING, Any

import numpy as np
from contourpy import contour_generator
from matplotlib.ticker import MaxNLocator

from workbench.arrays import Array
from workbench.pictures.axes import Extent, label_place
from workbench.powers import power_of, written
from workbench.targets.raster import averaged

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

_LINES = 6  # at most
# Cells along an axis, at most: finer ones show noise, and are slow for large images.
_CELLS = 192
_NOISE = 20  # points of a line around a few cells
_GAP = np.full((1, 2), np.nan)  # between the lines of a level, which are one artist
_LOOK: dict[str, Any] = {"color": "#e8ecf2", "linewidth": 0.8}


class Contours:
    """Contour lines with numbers at round values of a scale."""

    def __init__(self, axes: "Axes", extent: Extent) -> None:
        self._axes, self._bounds = axes, extent.bounds
        self._artists: list[Artist] = []

    def show(self, values: Array, top: float) -> None:
        """Draw lines of an image (n_y, n_x), row 0 at the upper edge, on a scale up to ``top``.

        Rings around a few cells are left out; noise has thousands of them.
        """
        self.clear()
        if min(values.shape) < 2:
            return  # a line of pixels has no such lines
        left, right, bottom, upper = self._bounds
        n_y, n_x = shape = tuple(min(count, _CELLS) for count in values.shape)
        x = left + (np.arange(n_x) + 0.5) * ((right - left) / n_x)
        y = upper - (np.arange(n_y) + 0.5) * ((upper - bottom) / n_y)
        found = contour_generator(x, y, averaged(values, shape))
        levels = np.asarray(MaxNLocator(_LINES, steps=[1, 2, 5, 10]).tick_values(0, top))
        ten = 10.0 ** power_of(0.0, top)  # as on a colour bar
        for level in levels[(levels > 0) & (levels < top)].tolist():
            lines = [np.asarray(line) for line in found.lines(level)]
            if lines:
                longest = max(lines, key=len)
                shown = [line for line in lines if len(line) > _NOISE or line is longest]
                gapped = np.concatenate([part for line in shown for part in (line, _GAP)])
                self._artists += self._axes.plot(*gapped[:-1].T, **_LOOK)
                at = longest[longest[:, 0].argmax()]
                text = written(level / ten, digits=3)
                self._artists.append(label_place(self._axes, at, text, "left", "top"))

    def clear(self) -> None:
        """Remove the lines."""
        for artist in self._artists:
            artist.remove()
        self._artists = []
