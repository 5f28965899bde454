"""Moves the keyboard's focus from pane to pane, and shows which one has it."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDockWidget, QToolBar, QWidget

from ui.commands.panes import PANES
from ui.widgets.application import application


class PaneFocus(QObject):
    """Moves the focus between docks, centre and toolbar, and marks the active pane."""

    def __init__(
        self,
        centre: QWidget,
        docks: Mapping[str, QDockWidget],
        toolbar: QToolBar,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._centre, self._docks, self._toolbar = centre, docks, toolbar
        self._marked: QWidget | None = None
        application().focusChanged.connect(self._mark)

    def slots(self) -> dict[str, Callable[[], object]]:
        """Functions of commands."""
        return {
            **{f"go_{name}": partial(self.go, name) for name in PANES},
            "next_pane": partial(self._step, 1),
            "previous_pane": partial(self._step, -1),
        }

    def place(self, name: str) -> QWidget:
        """Return the pane of a name."""
        found = self._docks.get(name)
        return self._centre if found is None else found

    def show(self, name: str) -> None:
        """Make a pane visible."""
        if name in self._docks:
            self._docks[name].show()
            self._docks[name].raise_()

    def go(self, name: str) -> None:
        """Show and focus a pane."""
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
