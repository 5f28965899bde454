"""Loss of a run as a strip along the window; its curve is the slider to earlier iterations."""

from collections.abc import Sequence
from typing import Any, BinaryIO

import numpy as np
from matplotlib.figure import Figure
from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QAction, QColor, QFocusEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSlider, QToolTip

from ui.document.frame import Frame, iterations_before
from ui.views.image_canvas import write_figure
from ui.views.shared_view import SharedView
from ui.views.view import View
from ui.widgets.controls import STRETCH, filled, push_button
from ui.words import tr
from workbench.arrays import Array
from workbench.files.session import Session
from workbench.pictures.axes import Column, shown_data
from workbench.pictures.loss import CHECKED, OTHERS, THIS_RUN, LossCourse, Verified, draw_loss
from workbench.powers import written

_HEIGHT, _EDGE, _DOT = 76, 8, 4.0  # pixels: around the curve, of its points
_LABELS = 9  # characters left of the curve
_BUTTON = 160  # pixels at the right, which names leave to a button
_FEWEST = 0.02  # decades of loss that fill the height, at least
_AXES = 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000  # iterations of a run that goes on
_SMALL = 0.85  # of the font, for scales


class Curve(QSlider):
    """Losses over iterations; its value is the number of the shown one of the recorded frames."""

    touched = Signal()

    def __init__(self) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.setAccessibleName(tr("Iteration of the run"))
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setFixedHeight(_HEIGHT)
        self._labels = _LABELS * self.fontMetrics().averageCharWidth()
        self.losses: Array = np.zeros(0)  # after each iteration, the first design included
        self.others: tuple[LossCourse, ...] = ()
        self.length = 1  # iterations along the axis
        self.at: Sequence[int] = ()  # iterations of the recorded frames
        self.stages: Sequence[int] = ()
        self.verified: tuple[Verified, ...] = ()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.touched.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._go(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._go(event)
        at = self._iteration(event)
        if 0 <= at < self.losses.size:
            text = tr("Iteration {number}: loss {loss}")
            text = text.format(number=at, loss=written(self.losses[at]))
            QToolTip.showText(event.globalPosition().toPoint(), text, self)

    def _go(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton and self.at:
            distances = np.abs(np.asarray(self.at) - self._iteration(event))
            self.setValue(int(distances.argmin()))

    def _iteration(self, event: QMouseEvent) -> int:
        part = (event.position().x() - self._place.left()) / max(self._place.width(), 1.0)
        return round(part * self.length)

    @property
    def _place(self) -> QRectF:
        return QRectF(self.rect()).adjusted(self._labels, _EDGE + 2, -2 * _EDGE, -_EDGE)

    def _points(self, iterations: Array, losses: Array) -> list[QPointF]:
        place, (low, high) = self._place, self._range
        fits = (losses > 0) & np.isfinite(losses)
        x = place.left() + place.width() * iterations[fits] / self.length
        y = place.bottom() - place.height() * (np.log10(losses[fits]) - low) / (high - low)
        return list(map(QPointF, x.tolist(), np.clip(y, place.top(), place.bottom()).tolist()))

    @property
    def _range(self) -> tuple[float, float]:
        """Decimal logarithms of the least and the largest loss."""
        every = np.concatenate([self.losses, *(other.losses for other in self.others)])
        seen = np.log10(every[(every > 0) & np.isfinite(every)])
        low = float(seen.min(initial=0.0 if not seen.size else np.inf))
        return low, max(float(seen.max(initial=-np.inf)), low + _FEWEST)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, place = QPainter(self), self._place
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(self.palette().placeholderText().color())
        if not (self.losses.size or self.others):
            hint = tr("The loss of a run is plotted here. Run > Start starts a run.")
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, hint)
            painter.end()
            return
        self._draw_scales(painter)
        for number, other in enumerate(self.others):
            painter.setPen(QPen(QColor(OTHERS[number % len(OTHERS)][0]), 1.3))
            painter.drawPolyline(self._points(np.arange(1.0, other.losses.size + 1), other.losses))
            beside = place.adjusted(0, 12 * number, -_BUTTON, 0)
            painter.drawText(beside, Qt.AlignmentFlag.AlignRight, other.name)
        curve = self._points(np.arange(0.0, self.losses.size), self.losses)
        colour = QColor(THIS_RUN)
        painter.setPen(QPen(colour, 1.8))
        painter.drawPolyline(curve)
        painter.setPen(Qt.PenStyle.NoPen)
        colour.setAlpha(40)
        painter.setBrush(colour)
        ends = [QPointF(each.x(), place.bottom()) for each in (*curve[-1:], *curve[:1])]
        painter.drawPolygon([*curve, *ends])
        painter.setBrush(QColor(CHECKED))
        for point in self._points(*np.array(self.verified).reshape(-1, 2).T):
            painter.drawEllipse(point, _DOT, _DOT)
        self._draw_handle(painter)
        painter.end()

    def _draw_scales(self, painter: QPainter) -> None:
        place, font = self._place, painter.font()
        font.setPointSizeF(_SMALL * font.pointSizeF())
        painter.setFont(font)
        painter.drawLine(place.bottomLeft(), place.bottomRight())
        for stage in self.stages:
            x = place.left() + place.width() * stage / self.length
            painter.drawLine(QPointF(x, place.top()), QPointF(x, place.bottom()))
        beside = QRectF(0, place.top() - 3, self._labels - _EDGE, place.height() + 6)
        low, high = (written(10.0**decade, digits=2) for decade in self._range)
        flags = Qt.AlignmentFlag
        painter.drawText(beside, flags.AlignRight | flags.AlignBottom, low)
        painter.drawText(beside, flags.AlignRight | flags.AlignTop, high)

    def _draw_handle(self, painter: QPainter) -> None:
        """Mark the shown iteration, or the latest one while none can be chosen."""
        rewinds = self.isEnabled() and len(self.at) > 1
        at = min(self.at[self.value()] if rewinds else self.losses.size - 1, self.losses.size - 1)
        text = self.palette().windowText().color()
        for point in self._points(np.array([at]), self.losses[[at]] if at >= 0 else np.zeros(1)):
            if rewinds:
                painter.setPen(QPen(text, 2 if self.hasFocus() else 1))
                x = point.x()
                painter.drawLine(QPointF(x, _EDGE / 2), QPointF(x, self._place.bottom()))
            painter.setPen(QPen(text, 1.5))
            painter.setBrush(QColor(THIS_RUN))
            painter.drawEllipse(point, _DOT + 1, _DOT + 1)


class LossStrip(View):
    """The loss of this run and of others, and rewinding of this one."""

    ENDINGS = (".png", ".svg", ".csv")

    touched = Signal()
    frame_chosen = Signal(object)
    continued = Signal(object)

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._frames: Sequence[Frame] = ()
        self.curve = Curve()
        self.curve.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.curve.valueChanged.connect(self._choose)
        self.curve.touched.connect(self.touched)
        self.setFocusProxy(self.curve)
        self._words = QLabel(textFormat=Qt.TextFormat.RichText)
        self._words.setToolTip(tr("Loss that the optimiser minimises"))
        longest = tr("Loss {loss}").format(loss=written(1.234e-10))
        self._words.setMinimumWidth(self.fontMetrics().horizontalAdvance(longest))
        tip = tr(
            "Restore the design of this iteration and continue from it; Undo restores the later one"
        )
        go_on = tr("Continue from here")
        self._button = push_button(go_on, tip, lambda: self.continued.emit(self._chosen))
        # Over the curve, which falls from the left: a drag must not move what is under the pointer.
        over = filled(QHBoxLayout(self.curve), STRETCH, self._button, margins=_EDGE)
        over.setAlignment(self._button, Qt.AlignmentFlag.AlignTop)
        self._box.addLayout(
            filled(QHBoxLayout(), self._words, (self.curve, 1), margins=(8, 0, 0, 0))
        )
        self.show_frames(())

    def offer(self, actions: Sequence[QAction]) -> None:
        self.curve.addActions(actions)

    @property
    def empty(self) -> bool:
        return not (self.curve.losses.size or self.curve.others)

    def write(self, file: BinaryIO, format: str) -> None:
        write_figure(self._figure(), file, format)

    def data(self) -> list[Column]:
        return shown_data(self._figure())

    def figures(self) -> dict[str, Any]:
        return {}

    def show_runs(self, runs: Sequence[LossCourse]) -> None:
        self.curve.others = tuple(runs)
        self._ask()

    def show_verified(self, verified: Sequence[Verified]) -> None:
        self.curve.verified = tuple(verified)
        self._ask()

    def show_frames(self, frames: Sequence[Frame]) -> None:
        """Offer the recorded frames of a run, and show the last one as chosen."""
        self._frames = frames
        with QSignalBlocker(self.curve):
            self.curve.at = [iterations_before(frame) for frame in frames]
            self.curve.setMaximum(max(0, len(frames) - 1))
            self.curve.setValue(len(frames) - 1)
        tip = tr("Drag along the curve, or press arrows on it, to show an earlier iteration")
        self.curve.setToolTip(tip if len(frames) > 1 else "")
        self._offer()

    def allow(self, resting: bool, go_on: bool = False) -> None:
        super().allow(resting)
        self.curve.setEnabled(resting)
        self._button.setEnabled(go_on)
        self._ask()

    @property
    def _chosen(self) -> Frame:
        return self._frames[self.curve.value()]

    @property
    def _latest(self) -> Frame | None:
        """The frame with all losses of the run, also while an earlier one is shown."""
        return self._frames[-1] if self._frames else self._frame

    def _choose(self) -> None:
        self._offer()
        self.frame_chosen.emit(self._chosen)

    def _offer(self) -> None:
        self._button.setVisible(self.curve.value() < len(self._frames) - 1)
        self._ask()

    def _draw(self, session: Session, frame: Frame | None) -> None:
        curve, latest = self.curve, self._latest
        curve.losses = np.zeros(0)
        if frame is not None and latest is not None and latest.result.losses.size:
            first = next((f.state.loss for f in self._frames if not iterations_before(f)), np.nan)
            curve.losses = np.concatenate([[first], latest.result.losses])
            # The last look of a run states another loss than its last iteration.
            curve.losses[iterations_before(frame) :][:1] = frame.state.loss
            curve.stages = latest.result.stage_starts
        count = max(curve.losses.size - 1, *(other.losses.size for other in curve.others), 1)
        curve.length = count
        if not self._resting and latest is not None:
            ahead = latest.snapshot.iterations - latest.snapshot.iteration
            curve.length = min(next((n for n in _AXES if n >= 1.2 * count), count), count + ahead)
        self._words.setText(
            _words(frame.state.loss, iterations_before(frame))
            if frame is not None and curve.losses.size
            else ""
        )
        curve.update()

    def _figure(self) -> Figure:
        """The same as a plot with axes, for files and the clipboard."""
        from matplotlib.figure import Figure  # late: takes long to import

        figure, latest = Figure(layout="constrained"), self._latest
        if latest is not None:
            curve, axes = self.curve, figure.add_subplot()
            losses, stages = curve.losses[1:], latest.result.stage_starts
            draw_loss(axes, losses, stages, verified=curve.verified, others=curve.others)
        return figure


def _words(loss: float, iteration: int) -> str:
    at = tr("iteration {number}").format(number=iteration)
    return tr("Loss {loss}").format(loss=f"<b>{written(loss)}</b>") + f"<br>{at}"
