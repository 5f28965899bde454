"""A matplotlib canvas that draws no more than what changed.

1. A full draw of a small figure takes some 30 ms, blitting its changing artists a third of that.
   The artists are `animated`, so that a full draw leaves them out and its result can be kept as
   the background.
2. Constrained layout takes as long as drawing. It is solved in the first draw after a resize or a
   change of scale, whose labels may be wider, and frozen in between.
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


class Canvas(FigureCanvasQTAgg):
    """A figure with one set of axes whose artists change often."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(Figure(layout="constrained"))
        self.setParent(parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._artists: Sequence[Artist] = ()
        self._background: Any = None

    def begin(self) -> "Axes":
        """Throw the old picture away; the axes of the next."""
        self._artists = ()
        self.figure.clear()
        self._thaw()
        return self.figure.add_subplot()

    def animate(self, artists: Sequence[Artist]) -> None:
        """Tell which artists change from picture to picture, and take colours for all others."""
        for artist in artists:
            artist.set_animated(True)
        self._artists = artists
        self.recolour()

    def show_changes(self, everything: bool) -> None:
        """Paint the artists over the background, or draw all anew."""
        if everything:
            self._thaw()
        if self._background is None:
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
        self.figure.set_layout_engine("none")
        self._background = self.copy_from_bbox(self.figure.bbox)
        self._draw_artists()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay out anew; also sent when the device pixel ratio changes."""
        self._thaw()
        super().resizeEvent(event)

    def _thaw(self) -> None:
        self.figure.set_layout_engine("constrained", w_pad=0.06, h_pad=0.05)
        self._background = None

    def _draw_artists(self) -> None:
        for artist in self._artists:
            self.figure.draw_artist(artist)
