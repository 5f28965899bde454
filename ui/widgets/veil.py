"""Overlay over outdated content."""

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.words import later, tr

OUTDATED = later("Outdated: this is the design before the change")

_GREY = 165  # of 255: what lies below is seen, and seen to be faint
_MARGIN = 6  # pixels around the words


class Veil(QWidget):
    """Greys a widget and says why; mouse and keyboard pass through."""

    def __init__(self, below: QWidget) -> None:
        super().__init__(below)
        self._below = below
        self.setObjectName("veil")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAccessibleName(tr(OUTDATED))
        self.hide()
        below.installEventFilter(self)

    def cover(self, covered: bool) -> None:
        """Show or hide the overlay."""
        if covered:
            self.setGeometry(self._below.rect())
            self.raise_()
        self.setVisible(covered)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep the size of the covered widget."""
        if event.type() == QEvent.Type.Resize and self.isVisible():
            self.setGeometry(self._below.rect())
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the overlay and its text."""
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
