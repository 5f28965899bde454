"""Labels that elide or wrap, and the overlay over outdated content."""

import re
from typing import Any

from PySide6.QtCore import QEvent, QObject, QRect, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
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
