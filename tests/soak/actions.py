"""What a monkey does to a window: each draws all its choices from a generator of its own."""

from collections.abc import Callable
from pathlib import Path
from random import Random

from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QDockWidget,
    QLineEdit,
    QWidget,
)

from tests.soak.dialogs import LEAVING
from ui.main_window import MainWindow

MOST_WINDOWS = 3
_NO, _SHIFT, _CTRL, _ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)
_LEFT, _RIGHT, _MIDDLE = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.RightButton,
    Qt.MouseButton.MiddleButton,
)
# Possible or refused; nothing that is possible and takes minutes.
_TEXTS = (
    *("1", "2", "0.5", "3", "7", "12", "24", "40", "64", "-0.2"),
    *("0", "", "-3", "1e30", "nan", "x"),
)
_KEYS = (
    *(Qt.Key.Key_Tab, Qt.Key.Key_Backtab, Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Escape),
    *(Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Delete),
    *(Qt.Key.Key_BracketLeft, Qt.Key.Key_BracketRight, Qt.Key.Key_F2, Qt.Key.Key_F6),
)


def type_text(window: MainWindow, rng: Random, folder: Path) -> str:
    """Type into a field, and enter it, leave it or take it back."""
    fields = _seen(window.forms, QLineEdit)
    if not fields:
        return "no field"
    field = rng.choice(fields)
    text = rng.choice(_TEXTS)
    field.setFocus()
    field.selectAll()
    QTest.keyClick(field, Qt.Key.Key_Delete)
    QTest.keyClicks(field, text)
    keys = [Qt.Key.Key_Return, Qt.Key.Key_Return, Qt.Key.Key_Tab, Qt.Key.Key_Escape]
    # A search for what is in no field would leave no other to type into.
    QTest.keyClick(field, Qt.Key.Key_Escape if field is window.forms.search else rng.choice(keys))
    return f"{text!r} into {_label(field)}"


def choose(window: MainWindow, rng: Random, folder: Path) -> str:
    """Choose another entry of a combo box."""
    boxes = _seen(window, QComboBox)
    if not boxes:
        return "no combo box"
    box = rng.choice(boxes)
    for _ in range(rng.randint(1, 4)):
        QTest.keyClick(box, rng.choice([Qt.Key.Key_Down, Qt.Key.Key_Up]))
    return f"{box.currentText()!r} of {_label(box)}"


def press(window: MainWindow, rng: Random, folder: Path) -> str:
    """Press a button, wherever it is; those of docks are for `arrange`."""
    buttons = _seen(window, QAbstractButton)
    buttons = [b for b in buttons if not b.objectName().startswith("qt_dockwidget")]
    if not buttons:
        return "no button"
    button = rng.choice(buttons)
    reported = button.text() or button.accessibleName() or button.toolTip() or button.objectName()
    QTest.mouseClick(button, _LEFT)
    return f"{reported!r}"


def command(window: MainWindow, rng: Random, folder: Path) -> str:
    """Do any command of the menus, but none that closes a window."""
    able = [entry for entry in window.commands.entries() if entry[1].isEnabled()]
    able = [(name, action) for name, action in able if not any(word in name for word in LEAVING)]
    if len(windows()) >= MOST_WINDOWS:
        able = [entry for entry in able if "window" not in entry[0].lower()]
    name, action = rng.choice(able)
    action.trigger()
    return name


def run(window: MainWindow, rng: Random, folder: Path) -> str:
    """Start, hold, continue or stop a run."""
    name = rng.choice(["start", "start", "continue", "pause", "pause", "stop", "stop", "check"])
    able = window.commands[name].isEnabled()
    window.commands[name].trigger()
    return name if able else f"{name}, which is not possible"


def undo(window: MainWindow, rng: Random, folder: Path) -> str:
    """Some steps back or forth."""
    name, times = rng.choice(["undo", "redo"]), rng.randint(1, 6)
    for _ in range(times):
        window.commands[name].trigger()
    return f"{name} × {times}"


def jump(window: MainWindow, rng: Random, folder: Path) -> str:
    """Click a step in the history."""
    view = window.panes.history
    window.panes.docks["history"].show()
    window.panes.docks["history"].raise_()
    row = rng.randrange(view.model().rowCount())
    index = view.model().index(row, 0)
    view.scrollTo(index)
    QTest.mouseClick(view.viewport(), _LEFT, pos=view.visualRect(index).center())
    return f"step {row}"


def slide(window: MainWindow, rng: Random, folder: Path) -> str:
    """Move a slider: look back at a moment of the run, say."""
    sliders = [s for s in _seen(window, QAbstractSlider) if s.maximum() > s.minimum()]
    if not sliders:
        return "no slider"
    slider = rng.choice(sliders)
    slider.setValue(rng.randint(slider.minimum(), slider.maximum()))
    return f"{slider.value()} of {slider.maximum()} in {_label(slider)}"


def arrange(window: MainWindow, rng: Random, folder: Path) -> str:
    """Show, hide, float or dock a dock."""
    dock = rng.choice(window.findChildren(QDockWidget))
    what = rng.choice(["toggle", "toggle", "show", "float", "dock"])
    if what == "toggle":
        dock.toggleViewAction().trigger()
    elif what == "show":
        dock.show()
        dock.raise_()
    else:
        dock.setFloating(what == "float")
    return f"{what} {dock.windowTitle()}"


def size(window: MainWindow, rng: Random, folder: Path) -> str:
    """Give the window another size, or none for a while."""
    what = rng.choice(["resize", "resize", "minimise", "maximise", "normal"])
    if what == "resize":
        window.resize(rng.randint(700, 1600), rng.randint(500, 1000))
        return f"resize to {window.width()} × {window.height()}"
    shown = {
        "minimise": window.showMinimized,
        "maximise": window.showMaximized,
        "normal": window.showNormal,
    }
    shown[what]()
    return what


def poke(window: MainWindow, rng: Random, folder: Path) -> str:
    """Click, drag, turn the wheel or press a key anywhere."""
    widgets = [w for w in _seen(window, QWidget) if w.width() > 8 and w.height() > 8]
    if not widgets:
        return "nothing to poke"
    return _poke(rng.choice(widgets), rng)


def poke_scene(window: MainWindow, rng: Random, folder: Path) -> str:
    """The same in the 3D view: with its tools, lens and source are in the way."""
    if window.loaded is None or not window.loaded.views.scene.isVisible():
        return "no 3D view"
    inner = [w for w in window.loaded.views.scene.findChildren(QWidget) if w.isVisible()]
    return _poke(rng.choice(inner), rng) if inner else "no 3D view"


def drop(window: MainWindow, rng: Random, folder: Path) -> str:
    """Drop a file onto the window."""
    path = rng.choice(sorted(folder.iterdir()))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    event = QDropEvent(QPointF(9, 9), Qt.DropAction.CopyAction, data, _LEFT, _NO)
    window.dropEvent(event)
    return path.name


def recolour(window: MainWindow, rng: Random, folder: Path) -> str:
    """Light or dark."""
    scheme = rng.choice([Qt.ColorScheme.Light, Qt.ColorScheme.Dark])
    QGuiApplication.styleHints().setColorScheme(scheme)
    return scheme.name


def close(window: MainWindow, rng: Random, folder: Path) -> str:
    """Close one of several windows."""
    if len(windows()) < 2:
        return "the last window stays"
    window.close()
    return "close"


def rest(window: MainWindow, rng: Random, folder: Path) -> str:
    """Do nothing for once."""
    return ""


ACTIONS: dict[Callable[[MainWindow, Random, Path], str], int] = {
    type_text: 20,
    choose: 6,
    press: 8,
    command: 14,
    run: 16,
    undo: 5,
    jump: 3,
    slide: 4,
    arrange: 6,
    size: 4,
    poke: 10,
    poke_scene: 8,
    drop: 4,
    recolour: 1,
    close: 2,
    rest: 12,
}
"""Each with how often it is done."""


def windows() -> list[MainWindow]:
    """Windows that are open, minimised ones included."""
    tops = QApplication.topLevelWidgets()
    return [w for w in tops if isinstance(w, MainWindow) and not w.isHidden()]


def _poke(widget: QWidget, rng: Random) -> str:
    place, where = _place(widget, rng), f"{type(widget).__name__} {_label(widget)}"
    keys = rng.choice([_NO, _NO, _NO, _SHIFT, _CTRL, _ALT])
    what = rng.choice(["click", "click", "drag", "drag", "wheel", "double", "menu", "key"])
    if what == "click":
        QTest.mouseClick(widget, rng.choice([_LEFT, _LEFT, _MIDDLE]), keys, place)
    elif what == "double":
        QTest.mouseDClick(widget, _LEFT, keys, place)
    elif what == "menu":
        QTest.mouseClick(widget, _RIGHT, keys, place)
    elif what == "drag":
        button = rng.choice([_LEFT, _LEFT, _LEFT, _MIDDLE, _RIGHT])
        QTest.mousePress(widget, button, keys, place)
        for _ in range(rng.randint(1, 8)):
            place = _place(widget, rng)
            QTest.mouseMove(widget, place)
        QTest.mouseRelease(widget, button, keys, place)
    elif what == "wheel":
        turn = QPoint(0, rng.choice([-120, 120]))
        at, button = QPointF(place), Qt.MouseButton.NoButton
        phase = Qt.ScrollPhase.NoScrollPhase
        wheel = QWheelEvent(at, widget.mapToGlobal(at), QPoint(), turn, button, keys, phase, False)
        QApplication.sendEvent(widget, wheel)
    else:
        QTest.keyClick(widget, rng.choice(_KEYS), keys)
    return f"{what} on {where}"


def _place(widget: QWidget, rng: Random) -> QPoint:
    width, height = max(widget.width(), 1), max(widget.height(), 1)  # a splitter closes panes
    return QPoint(rng.randrange(width), rng.randrange(height))


def _seen(within: QWidget, kind: type) -> list:
    """Widgets that can be used now and stand for themselves."""
    return [
        each
        for each in within.findChildren(kind)
        if each.isVisible() and each.isEnabled() and each.window() is within.window()
    ]


def _label(widget: QWidget) -> str:
    """What to call a widget: that of the nearest parent that has a name."""
    while widget is not None:
        name = getattr(widget, "path", "") or widget.accessibleName() or widget.objectName()
        if isinstance(name, str) and name and not name.startswith("qt_"):
            return name
        widget = widget.parentWidget()
    return "?"
