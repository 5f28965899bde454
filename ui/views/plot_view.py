"""A matplotlib canvas that redraws only what changed, and the view around it.

1. A full draw takes 30 ms, blitting animated artists a third of that: full draws are kept as the
   background.
2. Constrained layout takes several times as long as drawing: margins are fixed in pixels, and the
   labels of a colour bar are measured at full draws.
3. A narrow image omits the name of its vertical axis; files have all names.
4. Drawing ends before `show_changes` returns, so that its cost can be measured.
5. A new size is drawn when it is painted, one canvas in a turn of the event loop.
"""

import math
from abc import abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QFocusEvent,
    QHideEvent,
    QImage,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QWidget

from ui.document.frame import same_task
from ui.views.shared_view import SharedView
from ui.views.view import View, drawing_queue
from ui.widgets.figures import translate, translate_axes
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.pictures.axes import Column, paint, shown_data

if TYPE_CHECKING:
    from ui.document.frame import Frame
    from workbench.files.session import Session

# Logical pixels for tick labels and names; powers of ten are wider than the ticks of an image.
_LEFT_OF_IMAGE, _LEFT_OF_CURVE, _BOTTOM, _RIGHT, _TOP = 68, 84, 40, 18, 12
_TOP_OF_IMAGE = 24  # the unit of its light, and a power of ten
_LEFT_OF_NARROW, _NARROW = 46, 440  # of an image without the name of its upright axis
_SPAN = 1.105  # of axes with a colour bar, in widths of the axes
_BAR_LABELS = 62.0  # to begin with
_LEAST = 30  # of axes; on smaller ones labels lie over each other
_EDGE, _SLACK = 4.0, 20.0  # between the widest label and the end, at least and at most
_TRIES = 3  # with wider labels, other numbers may stand beside the bar
_FILE_DPI = 200
_INK, _PAPER = "black", "white"  # of files, which are read and printed elsewhere


class PlotCanvas(FigureCanvasQTAgg):
    """A figure with one set of axes whose artists change often."""

    def __init__(self, parent: QWidget, bar: bool) -> None:
        super().__init__(Figure())
        self._bar = bar
        self._bar_labels = _BAR_LABELS
        self.setParent(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._artists: Sequence[Artist] = ()
        self._background: Any = None
        self._stale = False
        self.recolour()  # no white sheet before the first picture

    @property
    def has_space(self) -> bool:
        """Whether there is space for axes beside their labels."""
        across = self.width() - self._left - (self._bar_labels if self._bar else _RIGHT)
        return bool(min(across, self.height() - _BOTTOM - _TOP) >= _LEAST)

    @property
    def _narrow(self) -> bool:
        return self._bar and self.width() < _NARROW

    @property
    def _left(self) -> int:
        if not self._bar:
            return _LEFT_OF_CURVE
        return _LEFT_OF_NARROW if self._narrow else _LEFT_OF_IMAGE

    def begin(self) -> Axes:
        self._artists = ()
        self.figure.clear()
        self._place()
        return self.figure.add_subplot()

    def animate(self, artists: Sequence[Artist]) -> None:
        """Set the artists that change from frame to frame, and recolour the others."""
        for artist in artists:
            artist.set_animated(True)
        self._artists = artists
        self.recolour()

    def show_changes(self, everything: bool) -> None:
        if everything or self._background is None:
            self.draw()
        else:
            self.restore_region(self._background)
            self._draw_artists()
        self.repaint()

    def recolour(self) -> None:
        palette = self.parentWidget().palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())
        self._background = None

    def draw_idle(self) -> None:
        """Schedule a drawing before the next paint event."""
        self._stale = True
        self.update()

    def draw_now(self) -> None:
        if self._stale:
            self.draw()
            self.repaint()

    def draw(self) -> None:
        """Draw everything, and keep all but the artists as background."""
        self._stale = False
        self._name_axes(not self._narrow)
        for _ in range(_TRIES):
            super().draw()
            if not self._widen_labels():
                break
        self._background = self.copy_from_bbox(self.figure.bbox)
        self._draw_artists()

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the figure as "png" or "svg", black on white."""
        paint(self.figure, _INK, _PAPER)
        self._name_axes(True)
        self.figure.savefig(file, format=format, dpi=_FILE_DPI)
        self.recolour()
        self.draw()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Pass keys to the view; matplotlib would consume them."""
        event.ignore()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._stale and drawing_queue().may_draw(self):
            self.draw()
        if self._stale:
            self._paint_stretched()
        else:
            super().paintEvent(event)
        if self.hasFocus():
            painter = QPainter(self)
            painter.setPen(QPen(self.palette().highlight().color(), 1))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
            painter.end()

    def hideEvent(self, event: QHideEvent) -> None:
        drawing_queue().leave(self)
        super().hideEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay out the axes; also called when the device pixel ratio changes."""
        super().resizeEvent(event)
        self._place()

    def _paint_stretched(self) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.parentWidget().palette().window())
        if hasattr(self, "renderer"):
            pixels = np.asarray(self.renderer.buffer_rgba())
            (height, width, _), kind = pixels.shape, QImage.Format.Format_RGBA8888
            painter.drawImage(self.rect(), QImage(pixels.data, width, height, kind))
        painter.end()

    def _place(self) -> None:
        width, height = max(self.width(), 1), max(self.height(), 1)
        left = self._left
        if self._bar:
            right = left + (width - left - self._bar_labels) / _SPAN
        else:
            right = float(width - _RIGHT)
        self.figure.subplots_adjust(
            left=left / width,
            right=max(right, left + 1) / width,
            bottom=_BOTTOM / height,
            top=max(height - (_TOP_OF_IMAGE if self._bar else _TOP), _BOTTOM + 1) / height,
        )
        self._background = None

    def _name_axes(self, named: bool) -> None:
        if self._bar:
            for axes in self.figure.axes:
                for each in (axes, *axes.child_axes):
                    each.yaxis.label.set_visible(named)
                for bar in axes.child_axes:
                    above = "" if named else bar.get_ylabel()
                    colour, size = bar.yaxis.label.get_color(), bar.yaxis.label.get_fontsize()
                    axes.set_title(above, loc="right", fontsize=size, color=colour, pad=5)
                    bar.yaxis.get_offset_text().set_fontsize(size)

    def _widen_labels(self) -> bool:
        bars = [bar for axes in self.figure.axes for bar in axes.child_axes]
        if not bars:
            return False
        labels = bars[0].yaxis.get_tightbbox(self.get_renderer())
        assert labels is not None  # it has a name
        beyond = labels.x1 - bars[0].get_window_extent().x1
        needed = math.ceil(beyond / self.device_pixel_ratio) + _EDGE
        # Narrowing the labels at once may make them wider again, without end.
        if self._bar_labels - _SLACK <= needed <= self._bar_labels:
            return False
        self._bar_labels = needed
        self._place()
        return True

    def _draw_artists(self) -> None:
        for artist in self._artists:
            if artist.axes is not None and artist.axes.get_visible():
                self.figure.draw_artist(artist)
        for axes in self.figure.axes:
            if axes.images and axes.get_visible():
                for edge in axes.spines.values():  # of which an image has covered one half
                    self.figure.draw_artist(edge)


class PlotView(View):
    """Holds a canvas with a plot of one design."""

    touched = Signal()

    _HAS_BAR = True
    _WAITING = later("The image is being computed.")
    _TOO_SMALL = later("Too little space for a plot.")
    _NOTHING = later("There is no image: this design cannot be traced.")

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._canvas = PlotCanvas(self, bar=self._HAS_BAR)
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

    def offer(self, actions: "Sequence[QAction]") -> None:
        self._canvas.addActions(actions)

    def write(self, file: BinaryIO, format: str) -> None:
        self._canvas.write(file, format)

    def data(self) -> list[Column]:
        return shown_data(self._canvas.figure)

    def figures(self) -> dict[str, Any] | None:
        """Figures of the plot, for JSON; None if there are only its data."""
        return None

    def show_frame(self, frame: "Frame") -> None:
        self._untraced = False
        super().show_frame(frame)

    def show_nothing(self, session: "Session") -> None:
        self._untraced = True
        super().show_nothing(session)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FocusIn:
            self.touched.emit()
        if event.type() == QEvent.Type.Resize and self._canvas.has_space is not self._has_space:
            self._has_space = self._canvas.has_space
            self._ask()
        return super().eventFilter(watched, event)

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        anew = frame is None or self._anew
        if anew or self._shown is None or not self._looks_alike(self._shown, session):
            self._canvas.animate(self._begin(self._canvas.begin(), session))
            translate(self._canvas.figure)
            self._anew = False
        self._shown = session
        everything = self._explain(self._why_empty(frame) or self._why_small()) | self._adapt()
        if frame is not None:
            everything |= self._change(frame)
        if everything:
            translate_axes(self._canvas.figure)
        self._canvas.show_changes(everything)

    def _begin_anew(self) -> None:
        self._anew = True
        self._ask()

    def _add_in_corner(self, widget: QWidget) -> None:
        self._over.addWidget(
            widget, 0, 0, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom
        )

    def _explain(self, why_empty: str) -> bool:
        (axes,) = self._canvas.figure.axes
        shown = not why_empty
        self._hint.setText(why_empty)
        changed = axes.get_visible() is not shown
        axes.set_visible(shown)
        return changed

    def _recolour(self) -> None:
        self._canvas.recolour()

    def _why_empty(self, frame: "Frame | None") -> str:
        if frame is not None:
            return ""
        return tr(self._NOTHING if self._untraced else self._WAITING)

    def _why_small(self) -> str:
        return "" if self._has_space else tr(self._TOO_SMALL)

    def _looks_alike(self, one: "Session", other: "Session") -> bool:
        return same_task(one, other)

    @abstractmethod
    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]": ...

    def _adapt(self) -> bool:
        return False

    @abstractmethod
    def _change(self, frame: "Frame") -> bool: ...
