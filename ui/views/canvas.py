"""A matplotlib canvas that draws no more than what changed.

1. A full draw of a small figure takes some 30 ms, blitting its changing artists a third of that.
   The artists are `animated`, so that a full draw leaves them out and its result can be kept as
   the background.
2. Constrained layout takes several times as long as drawing, most of all on logarithmic axes. The
   labels here are known well enough for margins of so many pixels.
3. `draw` runs on resize, on a change of the device pixel ratio, of scale or of colours; each makes
   a new background.
4. Drawing and painting happen before `show_changes` returns, so that their cost can be measured.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.artist import Artist
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.pictures.style import paint

if TYPE_CHECKING:
    from matplotlib.axes import Axes


# Logical pixels for tick labels and names; powers of ten are wider than the ticks of an image.
_LEFT_OF_IMAGE, _LEFT_OF_CURVE, _BOTTOM, _RIGHT, _TOP = 68, 84, 40, 18, 12
_BAR = 1.105, 62  # what a colour bar spans in widths of the axes, and pixels for its labels


class Canvas(FigureCanvasQTAgg):
    """A figure with one set of axes whose artists change often.

    Parameters
    ----------
    parent : QWidget
        Its palette gives the colours.
    bar : bool
        Leave room for a colour bar beside the axes.
    """

    def __init__(self, parent: QWidget, bar: bool) -> None:
        super().__init__(Figure())
        self._bar = bar
        self.setParent(parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._artists: Sequence[Artist] = ()
        self._background: Any = None

    def begin(self) -> "Axes":
        """Throw the old picture away; the axes of the next."""
        self._artists = ()
        self.figure.clear()
        self._place()
        return self.figure.add_subplot()

    def animate(self, artists: Sequence[Artist]) -> None:
        """Tell which artists change from picture to picture, and take colours for all others."""
        for artist in artists:
            artist.set_animated(True)
        self._artists = artists
        self.recolour()

    def show_changes(self, everything: bool) -> None:
        """Paint the artists over the background, or draw all anew."""
        if everything or self._background is None:
            self.draw()
        else:
            self.restore_region(self._background)
            self._draw_artists()
        self.repaint()

    def recolour(self) -> None:
        """Take the colours of the palette; seen with the next drawing."""
        palette = self.parentWidget().palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())
        self._background = None

    def draw(self) -> None:
        """Draw everything and keep all but the artists as the background."""
        super().draw()
        self._background = self.copy_from_bbox(self.figure.bbox)
        self._draw_artists()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Place the axes anew; also sent when the device pixel ratio changes."""
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        width, height = max(self.width(), 1), max(self.height(), 1)
        if self._bar:
            spans, labels = _BAR
            left = _LEFT_OF_IMAGE
            right = left + (width - left - labels) / spans
        else:
            left, right = _LEFT_OF_CURVE, width - _RIGHT
        self.figure.subplots_adjust(
            left=left / width,
            right=max(right, left + 1) / width,
            bottom=_BOTTOM / height,
            top=max(height - _TOP, _BOTTOM + 1) / height,
        )
        self._background = None

    def _draw_artists(self) -> None:
        for artist in self._artists:
            self.figure.draw_artist(artist)
