"""Labels that elide, wrap or are dragged, and the overlay over outdated content."""

import re
from typing import Any

from PySide6.QtCore import QEvent, QObject, QRect, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHideEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from ui.words import later, tr
from workbench.units import METRES


class ElidedLabel(QLabel):
    """Label that cuts its text with an ellipsis and shows all of it as a tip."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    @property
    def shown(self) -> str:
        return self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, self.width())

    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        shown = self.shown
        self.setToolTip("" if shown == self.text() else self.text())
        painter = QPainter(self)
        painter.drawText(self.rect(), self.alignment(), shown)
        painter.end()


def text_label(text: str, style: str = "", tip: str = "") -> QLabel:
    """Return a label in a style of the style sheet, with a tip that wraps."""
    made = QLabel(text)
    made.setObjectName(style)
    made.setToolTip(tip and f"<p>{tip}</p>")
    return made


_SPACE = "\N{NO-BREAK SPACE}"
_UNIT = rf"(?:%|{'|'.join(('lm', 'lx', 'cd', 'µm', 'nm', 's', *METRES))})(?![a-z])"
_BETWEEN = re.compile(rf"(?<=[\d⁰¹²³⁴⁵⁶⁷⁸⁹])( / | )(?={_UNIT})|(?<=\d) · (?=10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])")


def kept_together(text: str) -> str:
    """Return a text with no-break spaces between numbers and their units.

    Examples
    --------
    >>> kept_together("50 mm away, 2.5 · 10⁻⁶ / mm²").replace(chr(160), "_")
    '50_mm away, 2.5_·_10⁻⁶_/_mm²'
    """
    return _BETWEEN.sub(lambda found: found[0].replace(" ", _SPACE), text)


class WrappedLabel(QLabel):
    """Label that wraps its text and keeps numbers with their units."""

    def __init__(self, text: str = "", **properties: Any) -> None:
        super().__init__(wordWrap=True, **properties)
        self.setText(text)

    def text(self) -> str:
        return self._original

    def setText(self, text: str) -> None:
        self._original = text
        super().setText(kept_together(text))

    def clear(self) -> None:
        self.setText("")


OUTDATED = later("Outdated: the design has changed")

_GREY = 165  # of 255: what lies below is seen, and seen to be faint
_MARGIN = 6  # pixels around the words


class Veil(QWidget):
    """Greys a widget and shows why; mouse and keyboard pass through."""

    def __init__(self, below: QWidget) -> None:
        super().__init__(below)
        self._below = below
        self.setObjectName("veil")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAccessibleName(tr(OUTDATED))
        self.hide()
        below.installEventFilter(self)

    def cover(self, covered: bool) -> None:
        if covered:
            self.setGeometry(self._below.rect())
            self.raise_()
        self.setVisible(covered)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and self.isVisible():
            self.setGeometry(self._below.rect())
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        ground = QColor(self.palette().window().color())
        words = QRect(self.rect())
        words.adjust(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
        flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
        box = painter.boundingRect(words, flags, tr(OUTDATED))
        ground.setAlpha(_GREY)
        painter.fillRect(self.rect(), ground)
        frame = box.adjusted(-_MARGIN, -_MARGIN // 2, _MARGIN, _MARGIN // 2)
        painter.fillRect(frame, self.palette().toolTipBase())
        painter.setPen(self.palette().toolTipText().color())
        painter.drawText(words, flags, tr(OUTDATED))
        painter.end()


_SLACK = 4  # pixels that a hand moves without meaning to
_FINE = 1 / 10  # of the movement, with Shift


class DragLabel(QLabel):
    """Label of a number, which a horizontal drag on it changes; Escape ends the drag."""

    begun = Signal()
    dragged = Signal(float)  # pixels from where the drag began, fewer with Shift
    cancelled = Signal()

    # Of the class: Qt still sends events to a label whose own attributes Python has cleared.
    _last: float | None = None  # where the pointer was, while the button is down
    _gone, _moving = 0.0, False

    def allow_drag(self) -> None:
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.begun.connect(self.grabKeyboard)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        buddy = self.buddy()
        if buddy is not None:
            buddy.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() == Qt.MouseButton.LeftButton:
            self._last, self._gone = event.position().x(), 0.0

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._last is None or self.cursor().shape() != Qt.CursorShape.SizeHorCursor:
            return
        x = event.position().x()
        if not self._moving and abs(x - self._last) < _SLACK:
            return
        if not self._moving:
            self._moving, self._last = True, x
            self.begun.emit()
        fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        self._gone += (x - self._last) * (_FINE if fine else 1.0)
        self._last = x
        self.dragged.emit(self._gone)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._end()

    def hideEvent(self, event: QHideEvent) -> None:
        self._end()

    def event(self, event: QEvent) -> bool:
        if self._moving and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() != QEvent.Type.ShortcutOverride:
                self._end()
                self.cancelled.emit()
            event.accept()
            return True
        return super().event(event)

    def _end(self) -> None:
        self._last = None
        if self._moving:
            self._moving = False
            self.releaseKeyboard()
