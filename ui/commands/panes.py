"""Panes of the window, workspaces that show some of them, and moving the focus between panes."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Protocol

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDockWidget, QToolBar, QWidget

from ui.widgets.native import application


@dataclass(frozen=True)
class Pane:
    """A dock, a view of the image panel in the middle of the window, or the strip at its bottom."""

    title: str
    key: str = ""
    image: bool = False
    strip: bool = False


PANES = {
    "design": Pane("Design", "1"),
    "scene": Pane("3D scene", "2"),
    "irradiance": Pane("Irradiance", "3", image=True),
    "target": Pane("Target", image=True),
    "error": Pane("Difference", "4", image=True),
    "photo": Pane("Photo", image=True),
    "surface": Pane("Surface", "5", image=True),
    "derivative": Pane("Derivative", image=True),
    "focus": Pane("Through focus", image=True),
    "pinned": Pane("Pinned", image=True),
    "check": Pane("Check"),
    "manufacture": Pane("Manufacture"),
    "tolerances": Pane("Tolerances"),
    "result": Pane("Result"),
    "light": Pane("Light account"),
    "loss": Pane("Loss", "6", strip=True),
    "section": Pane("Cross-section", "7"),
    "runs": Pane("Runs"),
    "history": Pane("History", "8"),
    "log": Pane("Log", "9"),
}
"""By name, in the order in which menus list them and the focus goes.

What a pane holds is made where its libraries are loaded: `ui.window.docks.Panes.put_views` refuses
a table and widgets that do not agree.
"""


Tabs = tuple[str, ...]
"""Docks one behind the other, the front one first."""


@dataclass(frozen=True)
class Workspace:
    """What a window shows for one part of the work.

    `image`: the view of the image panel; `left`, `right`: docks beside it, from top to bottom;
    `strip`: whether the strip below them is shown. The 3D scene stands at the right of a narrow
    image, and below a wide one.
    """

    title: str
    tip: str
    image: str
    left: tuple[Tabs, ...]
    right: tuple[Tabs, ...]
    strip: bool = False


WORKSPACES = {
    "task": Workspace(
        "Task",
        "Describe the light, the element and the image",
        "target",
        (("design",),),
        (("scene",),),
    ),
    "design": Workspace(
        "Design",
        "Run the design and watch the image",
        "irradiance",
        (("design",),),
        (("scene",), ("result", "light", "runs", "log")),
        strip=True,
    ),
    "check": Workspace(
        "Check",
        "Verify the image: errors, cross-sections, through focus",
        "error",
        (),
        (("check", "light", "runs"), ("section",)),
    ),
    "make": Workspace(
        "Make",
        "Make the part: cutters, tolerances, exports",
        "surface",
        (),
        (("scene",), ("manufacture", "tolerances")),
    ),
}
"""By name, in the order of the work."""


class Places(Protocol):
    """Where the panes of a window are."""

    def place(self, name: str) -> QWidget:
        """The dock of a pane, the image panel or the strip."""
        ...

    def seen(self, name: str) -> bool:
        """Whether a pane can be seen now."""
        ...

    def show(self, name: str) -> None:
        """Show a pane."""
        ...


class PaneFocus(QObject):
    """Moves the focus between panes and toolbar, and marks the active pane."""

    def __init__(self, places: Places, toolbar: QToolBar, parent: QObject) -> None:
        super().__init__(parent)
        self.place, self.show, self._seen = places.place, places.show, places.seen
        self._toolbar = toolbar
        self._marked: QWidget | None = None
        application().focusChanged.connect(self._mark)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            **{f"go_{name}": partial(self.go, name) for name in PANES},
            "next_pane": partial(self._step, 1),
            "previous_pane": partial(self._step, -1),
        }

    def go(self, name: str) -> None:
        self.show(name)
        _enter(self.place(name))

    def _step(self, by: int) -> None:
        seen = [*map(self.place, filter(self._seen, PANES)), self._toolbar]
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
