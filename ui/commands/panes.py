"""Panes of the window (title, key, initial position), and moving the focus between them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDockWidget, QToolBar, QWidget

from ui.widgets.native import application


@dataclass(frozen=True)
class Pane:
    """A dock, or the centre."""

    title: str
    area: Qt.DockWidgetArea | None
    key: str = ""
    behind: str = ""
    right_of: str = ""
    shown: bool = True


_LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
_TOP = Qt.DockWidgetArea.TopDockWidgetArea

PANES = {
    "design": Pane("Design", _LEFT, "1"),
    "scene": Pane("3D scene", None, "2"),
    "irradiance": Pane("Irradiance", _TOP, "3"),
    "target": Pane("Target", _TOP, right_of="irradiance"),
    "error": Pane("Irradiance − target", _TOP, "4", right_of="target"),
    "derivative": Pane("Derivative", _TOP, behind="error", shown=False),
    "surface": Pane("Surface", _TOP, "5", behind="error", shown=False),
    "manufacture": Pane("Manufacture", _TOP, behind="error", shown=False),
    "tolerances": Pane("Tolerances", _TOP, behind="error", shown=False),
    "focus": Pane("Through focus", _TOP, behind="error", shown=False),
    "photo": Pane("Predicted photo", _TOP, behind="error", shown=False),
    "check": Pane("Check", _TOP, behind="error", shown=False),
    "loss": Pane("Loss", _RIGHT, "6"),
    "section": Pane("Cross-section", _RIGHT, "7", behind="loss", shown=False),
    "light": Pane("Light account", _RIGHT, behind="loss"),
    "runs": Pane("Runs", _RIGHT, behind="loss"),
    "history": Pane("History", _LEFT, "8", behind="design", shown=False),
    "log": Pane("Log", _RIGHT, "9", behind="loss", shown=False),
}
"""By name, in the order in which menus list them and the focus goes.

What a dock holds is made where its libraries are loaded: see `Workspace.put_views`, which
refuses a table and widgets that do not agree.
"""


class PaneFocus(QObject):
    """Moves the focus between docks, centre and toolbar, and marks the active pane."""

    def __init__(
        self, centre: QWidget, docks: Mapping[str, QDockWidget], toolbar: QToolBar, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._centre, self._docks, self._toolbar = centre, docks, toolbar
        self._marked: QWidget | None = None
        application().focusChanged.connect(self._mark)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            **{f"go_{name}": partial(self.go, name) for name in PANES},
            "next_pane": partial(self._step, 1),
            "previous_pane": partial(self._step, -1),
        }

    def place(self, name: str) -> QWidget:
        found = self._docks.get(name)
        return self._centre if found is None else found

    def show(self, name: str) -> None:
        if name in self._docks:
            self._docks[name].show()
            self._docks[name].raise_()

    def go(self, name: str) -> None:
        self.show(name)
        _enter(self.place(name))

    def _step(self, by: int) -> None:
        panes = [*map(self.place, PANES), self._toolbar]
        seen = [pane for pane in panes if not pane.visibleRegion().isEmpty()]
        focused = application().focusWidget()
        at = next((k for k, pane in enumerate(seen) if _holds(pane, focused)), -1 if by > 0 else 0)
        _enter(seen[(at + by) % len(seen)])

    def _mark(self, _: QWidget | None, focused: QWidget | None) -> None:
        pane = next((pane for pane in map(self.place, PANES) if _holds(pane, focused)), None)
        if focused is None or pane is self._marked:  # no focus: another window is active
            return
        for each, active in ((self._marked, False), (pane, True)):
            if each is not None:
                each.setProperty("active", active)
                each.style().unpolish(each)
                each.style().polish(each)
                each.update()  # which polishing does not see to
        self._marked = pane


def _holds(pane: QWidget, widget: QWidget | None) -> bool:
    return widget is not None and (pane is widget or pane.isAncestorOf(widget))


def _enter(pane: QWidget) -> None:
    inner = pane.widget() if isinstance(pane, QDockWidget) else pane
    last = inner.focusWidget()
    children = [w for w in inner.findChildren(QWidget) if w.focusPolicy() & Qt.FocusPolicy.TabFocus]
    for widget in (last, inner, *children):
        if widget is None or not (widget.isVisible() and widget.isEnabled()):
            continue
        if widget.focusPolicy() & Qt.FocusPolicy.TabFocus:
            widget.setFocus(Qt.FocusReason.TabFocusReason)
            return
    inner.setFocus(Qt.FocusReason.OtherFocusReason)
