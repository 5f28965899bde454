"""A veil over what is out of date."""

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.words import later, tr

OUTDATED = later("Outdated: this is the design before the change")

_GREY = 165  # of 255: what lies below is seen, and seen to be faint
_MARGIN = 6  # pixels around the words


class Veil(QWidget):
    """Greys the widget that it lies on and says why; mouse and keyboard pass through.

    Parameters
    ----------
    below : QWidget
        What is covered; it owns this.
    """

    def __init__(self, below: QWidget) -> None:
        super().__init__(below)
        self._below = below
        self.setObjectName("veil")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAccessibleName(tr(OUTDATED))
        self.hide()
        below.installEventFilter(self)

    def cover(self, covered: bool) -> None:
        """Cover what lies below, or uncover it."""
        if covered:
            self.setGeometry(self._below.rect())
            self.raise_()
        self.setVisible(covered)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay as large as what lies below."""
        if event.type() == QEvent.Type.Resize and self.isVisible():
            self.setGeometry(self._below.rect())
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the ground's colour over all, and the words at the top."""
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
