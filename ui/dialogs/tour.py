"""Tour of the window: native windows, since the 3D view lies above everything that Qt paints."""

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QPalette, QRegion
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import make_native
from ui.words import later, tr


@dataclass(frozen=True)
class Stop:
    """A step of the tour: its target and text."""

    place: str
    title: str
    text: str


STOPS = later(
    (
        Stop(
            "design",
            "Describe the task",
            (
                "Enter target image, lens, source and screen here. An impossible value is refused "
                "beside its field, with the allowed range. Drop a picture onto the window to use "
                "it as the target."
            ),
        ),
        Stop(
            "toolbar",
            "Start",
            (
                "Start (F5) designs the lens. Pause (F6) interrupts the run, Stop (F7) ends it "
                "with the best lens so far, Continue resumes from that lens."
            ),
        ),
        Stop(
            "scene",
            "3D scene",
            (
                "Lens, rays and screen. Drag to rotate, Shift-drag to move, scroll to zoom, or "
                "use arrow keys, + and −. Ctrl+Alt+1 fits the lens, Ctrl+Alt+2 the screen, Ctrl+0 "
                "everything; Ctrl+D compresses distances."
            ),
        ),
        Stop(
            "irradiance",
            "Image of light",
            (
                "Flux per area, updated during the run. The buttons above show the target, the "
                "difference (red is too much light, blue too little), a photo and the face; "
                "Compare shows two of them with a handle between."
            ),
        ),
        Stop(
            "loss",
            "Course of the run",
            (
                "The loss falls while the lens improves. Drag along the curve to show an earlier "
                "iteration; you can continue from any of them."
            ),
        ),
        Stop(
            "history",
            "Undo and recovery",
            (
                "Every edit and every run is a step. Undo with Ctrl+Z, or click a step. Unsaved "
                "work is backed up every minute."
            ),
        ),
        Stop(
            "menus",
            "Commands",
            "Ctrl+Shift+P finds a command by parts of its name. File > New from gallery shows the "
            "examples, File > Export writes the lens for other programs.",
        ),
    )
)


class Tour(QObject):
    """Moves from step to step by buttons or keys."""

    ended = Signal()

    def __init__(
        self,
        window: QWidget,
        place: Callable[[str], QWidget],
        show: Callable[[str], object],
        hide: Callable[[str], object],
    ) -> None:
        super().__init__(window)
        self._window, self._place, self._show, self._hide = window, place, show, hide
        self._at = -1
        self._hidden = ""  # the place of this stop, if the tour has brought it into sight
        self._target: QWidget | None = None
        self._frame, self._bubble = _Frame(window), Bubble(window)
        self._bubble.back.clicked.connect(lambda: self._go(self._at - 1))
        self._bubble.on.clicked.connect(lambda: self._go(self._at + 1))
        self._bubble.left.connect(self.end)
        self._follow = QTimer(self, singleShot=True, interval=0)
        self._follow.timeout.connect(self._point)
        window.installEventFilter(self)
        self._go(0)

    def end(self) -> None:
        self._go(len(STOPS))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show):
            self._follow.start()
        return False

    def _go(self, number: int) -> None:
        if self._target is not None:
            self._target.removeEventFilter(self)
        if self._hidden:
            self._hide(self._hidden)
            self._hidden = ""
        if not 0 <= number < len(STOPS):
            self._finish()
            return
        self._at = number
        stop = STOPS[number]
        target = self._place(stop.place)
        if target.visibleRegion().isEmpty():
            self._hidden = stop.place
            self._show(stop.place)
        self._target = target
        target.installEventFilter(self)
        self._bubble.show_stop(stop, number, len(STOPS))
        self._follow.start()

    def _finish(self) -> None:
        self._window.removeEventFilter(self)
        self._follow.stop()
        for widget in (self._frame, self._bubble):
            widget.hide()
            widget.deleteLater()
        self._window.setFocus()
        self.ended.emit()
        self.deleteLater()

    def _point(self) -> None:
        if self._target is None:
            return
        corner = self._target.mapTo(self._window, QPoint(0, 0))
        around = QRect(corner, self._target.size())
        self._frame.surround(around & self._window.rect())
        self._bubble.stand_beside(around, self._window.rect())


class Bubble(QFrame):
    """Text of a step, with buttons."""

    left = Signal()

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        make_native(self)
        self.setObjectName("bubble")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.Base)
        self._title, self._text, self._count = QLabel(), WrappedLabel(), QLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._count.setEnabled(False)
        self.end, self.back, self.on = (
            QPushButton(tr("&End")),
            QPushButton(tr("&Back")),
            QPushButton(),
        )
        self.end.setToolTip(tr("End the tour (Esc); Help > Tour starts it again"))
        self.end.clicked.connect(self.left)
        buttons = QHBoxLayout()
        buttons.addWidget(self._count, 1)
        for button in (self.end, self.back, self.on):
            button.setAutoDefault(True)  # Enter presses the one with the focus
            buttons.addWidget(button)
        self._column = filled(
            QVBoxLayout(self), self._title, self._text, buttons, margins=(14, 12, 14, 12)
        )

    def show_stop(self, stop: Stop, number: int, count: int) -> None:
        title, text = tr(stop.title), tr(stop.text)
        self._title.setText(title)
        self._text.setText(text)
        self._count.setText(tr("{number} of {count}").format(number=number + 1, count=count))
        self.setAccessibleName(f"{title}. {text}")
        last = number + 1 == count
        self.back.setEnabled(number > 0)
        self.on.setText(tr("&Done") if last else tr("&Next"))
        self.end.setVisible(not last)

    def stand_beside(self, target: QRect, bounds: QRect) -> None:
        """Move beside the target if there is space, else into its middle."""
        self._text.setMinimumWidth(44 * self.fontMetrics().averageCharWidth())
        width = self.sizeHint().width()
        own = QRect(0, 0, width, self._column.totalHeightForWidth(width))
        gap = self.fontMetrics().averageCharWidth()
        middle = target.center() - own.center()
        places = (
            QPoint(target.right() + gap, middle.y()),
            QPoint(target.left() - own.width() - gap, middle.y()),
            QPoint(middle.x(), target.bottom() + gap),
            QPoint(middle.x(), target.top() - own.height() - gap),
            middle,
        )
        inner = bounds.adjusted(gap, gap, -gap, -gap)
        for place in places:
            own.moveTo(place)
            _push_into(own, inner)
            if not own.intersects(target):
                break
        self.setGeometry(own)
        self.show()
        self.raise_()
        if not self.isAncestorOf(self.window().focusWidget() or self.window()):
            self.on.setFocus()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        else:
            super().keyPressEvent(event)


class _Frame(QWidget):
    _WIDTH = 3

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        make_native(self)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def surround(self, place: QRect) -> None:
        self.setGeometry(place)
        inner = self.rect().adjusted(self._WIDTH, self._WIDTH, -self._WIDTH, -self._WIDTH)
        self.setMask(QRegion(self.rect()) - QRegion(inner))
        self.show()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().highlight())
        painter.end()


def _push_into(own: QRect, bounds: QRect) -> None:
    own.moveLeft(max(bounds.left(), min(own.left(), bounds.right() - own.width())))
    own.moveTop(max(bounds.top(), min(own.top(), bounds.bottom() - own.height())))
