"""Between the mouse over the 3D scene and its tools.

1. The left button goes to the tool. If the tool has nothing to do there, the camera gets press,
   moves and release; all of them or none, or it would believe the button still pressed.
2. Without a tool a press and a release at one place are a click, which picks.
3. Keys that no tool takes are for the window.
4. Other buttons, and the wheel without Ctrl, are the camera's with any tool.
"""

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from ui.views.tools.tool import Pointer, Tool

_LEFT = Qt.MouseButton.LeftButton
_NOTCH = 120  # Qt's measure of the wheel's smallest turn

# VTK and pyvista do things at a key that the window knows nothing of: wireframe, picking, the end.
_KEYS = QEvent.Type.KeyPress, QEvent.Type.KeyRelease


class Hand(QObject):
    """Watches the plotter for what concerns the tool.

    Attributes
    ----------
    clicked : Signal(Pointer)
        Without a tool.
    let_go : Signal()
        Esc, while nothing was dragged.
    """

    clicked = Signal(object)
    let_go = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._tool: Tool | None = None
        self._dragging = False
        self._pressed_at: QPointF | None = None

    def take(self, tool: Tool | None) -> None:
        """Take another tool; what the one before has under way is taken back."""
        if self._tool is not None:
            self.drop()
            self._tool.hover(None)
        self._tool = tool

    def drop(self) -> None:
        """Take back what is under way; until the next press, movements do nothing."""
        if self._tool is not None and self._dragging:
            self._dragging = False
            self._tool.cancel()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Whether the event is kept from the plotter."""
        assert isinstance(watched, QWidget)
        tool = self._tool
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.KeyPress:
                event.setAccepted(self._escape())  # or it is the window's
            return True
        if event.type() in _KEYS:
            event.ignore()  # for the window
            return True
        if tool is not None and event.type() == QEvent.Type.Leave:
            tool.hover(None)
        if isinstance(event, QWheelEvent):
            return self._turn_wheel(event)
        if isinstance(event, QMouseEvent):
            if tool is None:
                return self._click(watched, event)
            return self._use(tool, watched, event)
        return False

    def _use(self, tool: Tool, plotter: QWidget, event: QMouseEvent) -> bool:
        kind, at = event.type(), _pointer(plotter, event)
        if kind == QEvent.Type.MouseButtonPress and event.button() is _LEFT:
            self._dragging = tool.press(at)
            return self._dragging
        if kind == QEvent.Type.MouseMove:
            if self._dragging:
                tool.drag(at)
                return True
            if not event.buttons():
                tool.hover(at)
        if kind == QEvent.Type.MouseButtonRelease and event.button() is _LEFT and self._dragging:
            self._dragging = False
            tool.release()
            return True
        return False

    def _click(self, plotter: QWidget, event: QMouseEvent) -> bool:
        if event.button() is _LEFT and event.type() == QEvent.Type.MouseButtonPress:
            self._pressed_at = event.position()
        elif event.button() is _LEFT and self._pressed_at is not None:
            moved = (event.position() - self._pressed_at).manhattanLength()
            self._pressed_at = None
            if moved < QApplication.startDragDistance():
                self.clicked.emit(_pointer(plotter, event))
        return False

    def _turn_wheel(self, event: QWheelEvent) -> bool:
        held = event.modifiers() & Qt.KeyboardModifier.ControlModifier
        if self._tool is None or not held:
            return False
        self._tool.turn_wheel(round(event.angleDelta().y() / _NOTCH))
        return True

    def _escape(self) -> bool:
        """Whether there was anything to leave."""
        if self._dragging:
            self.drop()
            return True
        if self._tool is not None:
            self.let_go.emit()
            return True
        return False


def _pointer(plotter: QWidget, event: QMouseEvent) -> Pointer:
    scale, place, keys = plotter.devicePixelRatioF(), event.position(), event.modifiers()
    along = Qt.KeyboardModifier.AltModifier | Qt.KeyboardModifier.ControlModifier
    return Pointer(
        x=place.x() * scale,
        y=(plotter.height() - 1 - place.y()) * scale,
        fine=bool(keys & Qt.KeyboardModifier.ShiftModifier),
        along=bool(keys & along),
    )
