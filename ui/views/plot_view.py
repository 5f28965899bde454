"""A matplotlib canvas for curves that redraws only what changed, and the base of all plots.

1. A full draw takes 30 ms, drawing the curves alone a third of that: the rest is kept as the
   background, as long as the axes stay the same.
2. Constrained layout takes several times as long as drawing: margins are fixed in pixels.
3. Drawing ends before `show_changes` returns, so that its cost can be measured.
"""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, BinaryIO

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QWidget

from ui.document.document import Document
from ui.document.frame import Frame, same_task
from ui.document.shown_lens import ShownLens
from ui.views.image_canvas import ImageCanvas, frame_focused, write_figure
from ui.views.shared_view import SharedView
from ui.views.view import View
from ui.widgets.figures import translate, translate_axes
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.files.session import Session
from workbench.pictures.axes import Column, paint, shown_data

_LEFT, _BOTTOM, _RIGHT, _TOP = 84, 46, 18, 12  # pixels, for labels and what is over a corner
_LEAST = 30  # of axes; on smaller ones labels lie over each other


class PlotCanvas(FigureCanvasQTAgg):
    """A figure with one set of axes whose curves change often."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(Figure())
        self.setParent(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._background: Any = None
        self._drawn: tuple[object, ...] = ()  # of the axes, in the background
        self.recolour()  # no white sheet before the first picture

    @property
    def has_space(self) -> bool:
        """Whether there is space for axes beside their labels."""
        across, up = self.width() - _LEFT - _RIGHT, self.height() - _BOTTOM - _TOP
        return bool(min(across, up) >= _LEAST)

    def begin(self) -> Axes:
        self.figure.clear()
        self._place()
        return self.figure.add_subplot()

    def show_changes(self) -> None:
        if self._background is None or self._look() != self._drawn:
            self.draw()
        else:
            self.restore_region(self._background)
            self._draw_curves()
        self.repaint()

    def recolour(self) -> None:
        palette = self.parentWidget().palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())
        self._background = None

    def draw(self) -> None:
        """Draw everything, and keep all but the curves as background."""
        for curve in self._curves():
            curve.set_animated(True)
        super().draw()
        self._background, self._drawn = self.copy_from_bbox(self.figure.bbox), self._look()
        self._draw_curves()

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the figure as "png" or "svg", black on white."""
        write_figure(self.figure, file, format)
        self.recolour()
        self.draw()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Pass keys to the view; matplotlib would consume them."""
        event.ignore()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        frame_focused(self)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay out the axes; also called when the device pixel ratio changes."""
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        width, height = max(self.width(), 1), max(self.height(), 1)
        self.figure.subplots_adjust(
            left=_LEFT / width,
            right=max(width - _RIGHT, _LEFT + 1) / width,
            bottom=_BOTTOM / height,
            top=max(height - _TOP, _BOTTOM + 1) / height,
        )
        self._background = None

    def _look(self) -> tuple[object, ...]:
        return tuple(
            (axes.get_visible(), axes.axis(), axes.get_xlabel(), axes.get_ylabel())
            for axes in self.figure.axes
        )

    def _curves(self) -> list[Artist]:
        """Curves, and a legend that covers them: one takes as long as ten curves."""
        seen = [axes for axes in self.figure.axes if axes.get_visible()]
        legends = filter(None, (axes.get_legend() for axes in seen))
        lines = sorted((line for axes in seen for line in axes.lines), key=Artist.get_zorder)
        return [*lines, *(legend for legend in legends if legend.get_frame_on())]

    def _draw_curves(self) -> None:
        for curve in self._curves():
            self.figure.draw_artist(curve)


class PlotView(View):
    """Holds a canvas with a plot of one design, of curves unless it is overridden."""

    ENDINGS: tuple[str, ...] = (".png", ".svg", ".csv")
    """Of files that it is saved to."""

    touched = Signal()

    _WAITING = later("The image is being computed.")
    _TOO_SMALL = later("Too little space for a plot.")
    _NOTHING = later("There is no image: this design cannot be traced.")

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._canvas = self._new_canvas()
        self._canvas.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._canvas.installEventFilter(self)
        self.setFocusProxy(self._canvas)
        self._box.addWidget(self._canvas, 1)
        self._hint = WrappedLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self._hint.setMargin(self.fontMetrics().height())
        self._hint.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._untraced = False
        self._over = QGridLayout(self._canvas)
        self._over.setContentsMargins(2, 2, 2, 2)
        self._over.addWidget(self._hint, 0, 0)
        self._shown: Session | None = None
        self._anew = True
        self._has_space = True

    @property
    def empty(self) -> bool:
        axes = self._canvas.figure.axes
        return not axes or not axes[0].get_visible()

    def offer(self, actions: Sequence[QAction]) -> None:
        self._canvas.addActions(actions)

    def write(self, file: BinaryIO, format: str) -> None:
        self._canvas.write(file, format)

    def data(self) -> list[Column]:
        return shown_data(self._canvas.figure)

    def figures(self) -> dict[str, Any]:
        """Figures of the plot, for JSON, if ".json" is among its endings."""
        return {}

    def show_frame(self, frame: Frame) -> None:
        self._untraced = False
        super().show_frame(frame)

    def show_nothing(self, session: Session) -> None:
        self._untraced = False
        super().show_nothing(session)

    def follow(self, document: Document, shown: ShownLens) -> None:
        super().follow(document, shown)
        shown.untraced.connect(self._show_untraced)

    def _show_untraced(self) -> None:
        self._untraced = True
        self._ask()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FocusIn:
            self.touched.emit()
        if event.type() == QEvent.Type.Resize and self._canvas.has_space is not self._has_space:
            self._has_space = self._canvas.has_space
            self._ask()
        return super().eventFilter(watched, event)

    def _draw(self, session: Session, frame: Frame | None) -> None:
        anew = frame is None or self._anew
        if anew or self._shown is None or not self._looks_alike(self._shown, session):
            self._begin(self._canvas.begin(), session)
            translate(self._canvas.figure)
            self._canvas.recolour()
            self._anew = False
        self._shown = session
        self._explain(self._why_empty(frame) or self._why_small())
        self._adapt()
        if frame is not None:
            self._change(frame)
        translate_axes(self._canvas.figure)
        self._canvas.show_changes()

    def _new_canvas(self) -> PlotCanvas | ImageCanvas:
        return PlotCanvas(self)

    def _begin_anew(self) -> None:
        self._anew = True
        self._ask()

    def _explain(self, why_empty: str) -> None:
        (axes,) = self._canvas.figure.axes
        self._hint.setText(why_empty)
        axes.set_visible(not why_empty)

    def _recolour(self) -> None:
        self._canvas.recolour()

    def _why_empty(self, frame: Frame | None) -> str:
        if frame is not None:
            return ""
        return tr(self._NOTHING if self._untraced else self._WAITING)

    def _why_small(self) -> str:
        return "" if self._has_space else tr(self._TOO_SMALL)

    def _looks_alike(self, one: Session, other: Session) -> bool:
        return same_task(one, other)

    @abstractmethod
    def _begin(self, axes: Axes, session: Session) -> None:
        """Draw on empty axes what the design alone decides."""

    def _adapt(self) -> None:
        """Follow the shared options."""

    def _change(self, frame: Frame) -> None:
        """Show what a frame changes."""
