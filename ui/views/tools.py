"""Input of the 3D view: keys, camera steering, and events of tools.

1. The left button goes to the tool. If the tool does not use the press, the camera gets press,
   moves and release; all or none.
2. Without a tool, a press and a release at one point select; of the right button, with or without
   a tool, they open the menu.
3. A held key of a tool is one drag; another key or button, or a loss of focus, ends it. X11 may
   report an auto-repeated key as released and pressed, so a release counts only if no press
   follows.
4. Other keys go to the view and the window. Other buttons go to the camera, the wheel to the view.
"""

from collections.abc import Sequence, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from workbench.arrays import Array
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.pictures.camera import FittedCamera

_Key = Qt.Key

ARROWS: dict[int, tuple[int, int]] = {
    _Key.Key_Left: (-1, 0),
    _Key.Key_Right: (1, 0),
    _Key.Key_Down: (0, -1),
    _Key.Key_Up: (0, 1),
}
"""Steps to the right and up, by key."""

ZOOMS: dict[int, int] = {_Key.Key_Plus: 1, _Key.Key_Equal: 1, _Key.Key_Minus: -1}
"""Steps nearer, by key."""

COMMANDS = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
"""With either of these, a key is for the window."""


@dataclass(frozen=True)
class Pointer:
    """Position of the mouse, and modifier keys."""

    x: float
    y: float
    fine: bool = False
    along: bool = False


class Tool(QObject):
    """Tool that uses the left button, and some keys; what it does not override does nothing."""

    cursor = Qt.CursorShape.ArrowCursor
    shows_net = False
    shows_handles = False
    dragged: Scene | None = None  # to which a drag has come, before it is traced
    keys: Set[int] = frozenset()

    @property
    def ruled(self) -> Sequence[Array]:
        """Points (3,) that a line joins."""
        return ()

    @property
    def hint(self) -> str:
        """What the tool does, in one line."""
        return ""

    def press(self, at: Pointer) -> bool:
        """Begin a drag; False leaves the button to the camera."""
        return False

    def drag(self, at: Pointer) -> None:
        """Continue a drag."""

    def press_key(self, key: int) -> None:
        """Begin the action of a key, as a drag."""

    def repeat_key(self, key: int, fine: bool) -> None:
        """Apply the action of a key: after the press, and repeatedly while it is held."""

    def release(self) -> None:
        """End a drag, or the action of a key."""

    def cancel(self) -> None:
        """Cancel a drag, if there is one."""

    def hover(self, at: Pointer | None) -> None:
        """Highlight what a press would grab; None when the pointer left."""

    def turn_wheel(self, steps: int) -> None:
        """Change the size of the tool, if it has one."""


_TURN = 5.0  # degrees
_MOVE = 0.05  # of the height of what is seen
_ZOOM = 1.25


def steer(camera: "FittedCamera", event: QKeyEvent) -> bool:
    """Rotate, shift, zoom or reset the camera by a key; whether the key was used."""
    key, keys = event.key(), event.modifiers()
    if keys & COMMANDS:
        return False
    if key in ARROWS:
        right, up = ARROWS[key]
        if keys & Qt.KeyboardModifier.ShiftModifier:
            camera.move(_MOVE * right, _MOVE * up)
        else:
            camera.turn(_TURN * right, _TURN * up)
    elif key in ZOOMS:
        camera.zoom(_ZOOM ** ZOOMS[key])
    elif key == Qt.Key.Key_Home:
        camera.fit("")
    else:
        return False
    return True


_LEFT = Qt.MouseButton.LeftButton
_BEHIND = 100  # milliseconds; a server under load takes as long, fingers seldom are as fast
_NOTCH = 120  # Qt's measure of the wheel's smallest turn

# VTK and pyvista do things at a key that the window knows nothing of: wireframe, picking, the end.
_KEY_EVENTS = QEvent.Type.KeyPress, QEvent.Type.KeyRelease


class ToolInput(QObject):
    """Passes events of the plotter to the tool."""

    clicked = Signal(object)
    menu_asked = Signal(object)  # QPoint of the screen
    wheeled = Signal(object, float)
    escaped = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._tool: Tool | None = None
        self._held: Qt.MouseButton | int | None = None  # a button or key that the tool has taken
        self._works = False  # the tool, by what is held
        self._lifted = False  # what is held, unless a press comes right behind
        self._behind = QTimer(self, singleShot=True, interval=_BEHIND)
        # Queued: a press that waits because the window was busy is handled before.
        self._behind.timeout.connect(self._find_released, Qt.ConnectionType.QueuedConnection)
        self._pressed_at: QPointF | None = None

    def take(self, tool: Tool | None) -> None:
        """Use another tool; cancel that before."""
        self._find_released()
        if self._tool is not None:
            self.drop()
            self._tool.hover(None)
        self._tool, self._held, self._lifted = tool, None, False

    def drop(self) -> None:
        """Cancel the present drag; movements and held keys do nothing until the next press."""
        if self._tool is not None and self._works:
            self._works = False
            self._tool.cancel()

    def keeps(self, plotter: QWidget, event: QEvent) -> bool:
        """Whether an event is kept from the plotter."""
        tool = self._tool
        if isinstance(event, QKeyEvent) and event.key() != self._held:
            self._find_released()
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.KeyPress:
                event.setAccepted(self._escape())  # or it is the window's
            return True
        if isinstance(event, QKeyEvent) and event.type() in _KEY_EVENTS:
            event.setAccepted(tool is not None and self._use_key(tool, event))
            return True
        if event.type() == QEvent.Type.FocusOut and self._held is not _LEFT:
            self._let_go()
        if tool is not None and event.type() == QEvent.Type.Leave and self._held is None:
            tool.hover(None)
        if isinstance(event, QWheelEvent):
            self._turn_wheel(plotter, event)
            return True
        if isinstance(event, QMouseEvent):
            self._note_click(plotter, event)
            return tool is not None and self._use(tool, plotter, event)
        return False

    def _use(self, tool: Tool, plotter: QWidget, event: QMouseEvent) -> bool:
        kind, at = event.type(), pointer_at(plotter, event)
        if kind == QEvent.Type.MouseButtonPress and event.button() is _LEFT:
            self._let_go()  # of a key
            self._works = tool.press(at)
            self._held = _LEFT if self._works else None
            return self._works
        if kind == QEvent.Type.MouseMove:
            if self._held is _LEFT:
                if self._works:
                    tool.drag(at)
                return True
            if self._held is None and not event.buttons():
                tool.hover(at)
        if kind == QEvent.Type.MouseButtonRelease and event.button() is self._held:
            self._let_go()
            return True
        return False

    def _use_key(self, tool: Tool, event: QKeyEvent) -> bool:
        key, again, keys = event.key(), event.isAutoRepeat(), event.modifiers()
        if event.type() == QEvent.Type.KeyRelease:
            if key == self._held and not again:
                self._lifted = True
                self._behind.start()
            return key in tool.keys
        if key not in tool.keys or keys & COMMANDS or self._held is _LEFT:
            return False
        if not again and not self._lifted:
            self._let_go()  # of another key
            tool.press_key(key)
            self._held, self._works = key, True
        self._lifted = False
        if key == self._held and self._works:
            tool.repeat_key(key, fine=bool(keys & Qt.KeyboardModifier.ShiftModifier))
        return True

    def _find_released(self) -> None:
        if self._lifted:
            self._let_go()

    def _let_go(self) -> None:
        self._held, self._lifted = None, False
        if self._tool is not None and self._works:
            self._works = False
            self._tool.release()

    def _note_click(self, plotter: QWidget, event: QMouseEvent) -> None:
        button = event.button()
        if event.type() == QEvent.Type.MouseButtonPress:
            self._pressed_at = event.position()
        elif button is not Qt.MouseButton.NoButton and self._pressed_at is not None:
            moved = (event.position() - self._pressed_at).manhattanLength()
            self._pressed_at = None
            if moved >= QApplication.startDragDistance():
                return
            if button is Qt.MouseButton.RightButton:
                self.menu_asked.emit(event.globalPosition().toPoint())
            elif button is _LEFT and self._tool is None:
                self.clicked.emit(pointer_at(plotter, event))

    def _turn_wheel(self, plotter: QWidget, event: QWheelEvent) -> None:
        notches = event.angleDelta().y() / _NOTCH
        if self._tool is not None and event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self._tool.turn_wheel(round(notches))
        else:
            self.wheeled.emit(pointer_at(plotter, event), notches)

    def _escape(self) -> bool:
        if self._works:
            self.drop()
            return True
        if self._tool is not None:
            self.escaped.emit()
            return True
        return False


def pointer_at(plotter: QWidget, event: QMouseEvent | QWheelEvent) -> Pointer:
    """Where the mouse is on a plotter, in its pixels from the lower left."""
    keys = event.modifiers()
    return Pointer(
        *pixel_at(plotter, event.position()),
        fine=bool(keys & Qt.KeyboardModifier.ShiftModifier),
        along=bool(keys & COMMANDS),
    )


def pixel_at(plotter: QWidget, place: QPointF) -> tuple[float, float]:
    """Return the pixel, from the lower left, of a place on a plotter."""
    scale = plotter.devicePixelRatioF()
    return place.x() * scale, (plotter.height() - 1 - place.y()) * scale
