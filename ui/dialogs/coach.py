"""Coach marks: bubbles beside parts of the window, which say what these are for.

They are native windows, since the 3D view lies above everything that Qt paints.
"""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QPalette, QRegion
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from ui.widgets.controls import STRETCH, filled
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import make_native
from ui.words import later, tr

_WIDE, _GAP, _BORDER = 320, 10, 3  # pixels

MARKS = later(
    (
        (
            "Describe the task",
            "Picture, light, lens and screen. Drag a label to change its value; Ctrl+Z undoes.",
        ),
        (
            "Start the design",
            "Start (F5) designs the lens. Stop (F7) ends the run with the best lens so far.",
        ),
        (
            "Image of light",
            "The light on the screen, updated during the run. The buttons above show target, "
            "difference and photo.",
        ),
        (
            "From task to part",
            "Task, Design, Check, Make: verify the image, then export the lens for making.",
        ),
    )
)


class CoachMarks(QFrame):
    """Shows `MARKS` one after the other, each beside its widget."""

    ended = Signal()

    def __init__(self, window: QWidget, places: Sequence[QWidget]) -> None:
        super().__init__(window)
        self._places, self._at = places, 0
        self._frame = QFrame(window)
        self._frame.setObjectName("handle")  # as bright as a handle
        for each in (self, self._frame):
            make_native(each)
        self.setObjectName("note")
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.Base)
        self._title, self._text, self._count = QLabel(), WrappedLabel(), QLabel()
        self._title.setObjectName("title")
        self._count.setEnabled(False)
        self.on, end = QPushButton(), QPushButton(tr("&End"))
        self.on.clicked.connect(self._step)
        end.clicked.connect(self.end)
        for button in (self.on, end):
            button.setAutoDefault(True)  # Enter presses the one with the focus
        row = filled(QHBoxLayout(), self._count, STRETCH, end, self.on)
        self._column = filled(QVBoxLayout(self), self._title, self._text, row, margins=12)
        self._text.setFixedWidth(_WIDE)
        self._follow = QTimer(self, singleShot=True, interval=0)
        self._follow.timeout.connect(self._point)
        self._watched: set[QWidget] = {window, *places}
        for part in self._watched:
            part.installEventFilter(self)
        self._show()

    @property
    def title(self) -> str:
        return self._title.text()

    def end(self) -> None:
        for part in self._watched:
            part.removeEventFilter(self)
        self._follow.stop()
        for each in (self, self._frame):
            each.hide()
            each.deleteLater()
        self.ended.emit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self._follow.start()
        return False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.end()
        else:
            super().keyPressEvent(event)

    def _step(self) -> None:
        if self._at + 1 < len(MARKS):
            self._at += 1
            self._show()
        else:
            self.end()

    def _show(self) -> None:
        title, text = MARKS[self._at]
        self._title.setText(tr(title))
        self._text.setText(tr(text))
        self._count.setText(tr("{number} of {count}").format(number=self._at + 1, count=len(MARKS)))
        self.on.setText(tr("&Next") if self._at + 1 < len(MARKS) else tr("&Done"))
        self.setAccessibleName(f"{self.title}. {self._text.text()}")
        self._follow.start()

    def _point(self) -> None:
        place, bounds = self._places[self._at], self.window().rect()
        target = QRect(place.mapTo(self.window(), QPoint()), place.size()) & bounds
        around = target.adjusted(-_BORDER, -_BORDER, _BORDER, _BORDER)
        self._frame.setGeometry(around)
        hole = QRect(QPoint(_BORDER, _BORDER), target.size())
        self._frame.setMask(QRegion(self._frame.rect()) - QRegion(hole))
        self.adjustSize()
        own, middle = self.rect(), target.center() - self.rect().center()
        inner = bounds.adjusted(_GAP, _GAP, -_GAP, -_GAP)
        beside = (
            QPoint(middle.x(), target.bottom() + 2 * _GAP),
            QPoint(target.right() + 2 * _GAP, middle.y()),
            QPoint(target.left() - own.width() - 2 * _GAP, middle.y()),
            middle,
        )
        for corner in beside:
            own.moveLeft(max(inner.left(), min(corner.x(), inner.right() - own.width())))
            own.moveTop(max(inner.top(), min(corner.y(), inner.bottom() - own.height())))
            if not own.intersects(target):
                break
        self.move(own.topLeft())
        for each in (self._frame, self):
            each.show()
            each.raise_()
        self.on.setFocus()
