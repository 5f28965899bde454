"""Docks, image panel and strip of the window, and all parts of it that need no slow library."""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QModelIndex, QObject, QPersistentModelIndex, QSettings, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QUndoStack
from PySide6.QtWidgets import (
    QDockWidget,
    QLabel,
    QMainWindow,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QToolBar,
    QUndoView,
    QWidget,
)

from ui.commands.actions import Commands
from ui.commands.panes import PANES
from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.panels.forms import Forms
from ui.run.status import RunStatus
from ui.widgets.messages import LogView, Messages
from ui.widgets.native import Uncovered, application
from ui.widgets.shelf import Shelf, open_folder
from ui.window.edit_notices import RefusedFields
from ui.window.image_panel import ImagePanel
from ui.words import capitalised, later, tr
from workbench.files.session import Session

_STRIP = next(name for name, pane in PANES.items() if pane.strip)
# Of the height of the window, for a dock that is asked for.
_LEAST_SHARE = 0.4


class Panes:
    """Image panel, docks around it, strip below; the views come later: their libraries load slowly.

    `ui.window.workspaces.Workspaces` says where the docks are.
    """

    def __init__(
        self,
        window: QMainWindow,
        forms: Forms,
        messages: Messages,
        steps: QUndoStack,
        log: LogView,
    ) -> None:
        self._window = window
        self.images = ImagePanel(messages)
        window.setCentralWidget(self.images)
        for corner in (Qt.Corner.TopLeftCorner, Qt.Corner.BottomLeftCorner):
            window.setCorner(corner, Qt.DockWidgetArea.LeftDockWidgetArea)
        for corner in (Qt.Corner.TopRightCorner, Qt.Corner.BottomRightCorner):
            window.setCorner(corner, Qt.DockWidgetArea.RightDockWidgetArea)
        self.docks = {
            name: Dock(name, tr(pane.title), window)
            for name, pane in PANES.items()
            if not (pane.image or pane.strip)
        }
        self.strip = _Strip(window)
        # It cannot take a window of its own: a 3D view does not survive the change.
        self.docks["scene"].setFeatures(
            QDockWidget.DockWidgetFeature.DockWidgetMovable
            | QDockWidget.DockWidgetFeature.DockWidgetClosable
        )
        self.history = QUndoView(steps)
        self.history.setEmptyLabel(tr("As opened"))
        self.history.setItemDelegate(_Capitalised(self.history))
        self.history.setToolTip(tr("Click a step to restore it"))
        there: dict[str, QWidget] = {"design": forms, "history": self.history, "log": log}
        self._waiting = self.docks.keys() - there.keys()
        for name, dock in self.docks.items():
            placeholder = QLabel(tr("Loading…"), alignment=Qt.AlignmentFlag.AlignCenter)
            dock.setWidget(there.get(name, placeholder))

    def put_views(self, views: Mapping[str, QWidget]) -> None:
        """Put views into their docks and into the image panel, by the names of their panes."""
        awaited = self._waiting | {*self.images.names, _STRIP}
        if awaited != views.keys():
            wrong = sorted(awaited ^ views.keys())
            raise ValueError(f"no place, or nothing for it: {wrong}")
        Uncovered(self._window.window())
        for name in self._waiting:
            placeholder = self.docks[name].widget()
            self.docks[name].setWidget(views[name])
            placeholder.deleteLater()
        self.images.put({name: views[name] for name in self.images.names})
        self.strip.put(views[_STRIP])

    def name_light(self, session: Session) -> None:
        self.images.rename("irradiance", tr(session.scene.receiver.density.capitalize()))

    def place(self, name: str) -> QWidget:
        """The dock of a pane, the image panel or the strip."""
        if PANES[name].strip:
            return self.strip
        return self.images if PANES[name].image else self.docks[name]

    def seen(self, name: str) -> bool:
        """Whether a pane can be seen now."""
        if PANES[name].strip:
            return self.strip.isVisible()
        return name == self.images.name if PANES[name].image else self.docks[name].seen

    def covers(self, widget: QWidget) -> bool:
        """Whether a widget is in a dock behind another one."""
        return any(d.isAncestorOf(widget) and not d.seen for d in self.docks.values())

    def show(self, name: str) -> None:
        """Show a pane, in whatever workspace."""
        if PANES[name].image:
            self.images.choose(name)
        elif PANES[name].strip:
            self.strip.show()
        else:
            self.docks[name].show()
            QTimer.singleShot(0, self._window, partial(self._bring, self.docks[name]))

    def _bring(self, dock: QDockWidget) -> None:
        """Raise a dock, as soon as it has a place, and give it enough of it."""
        dock.raise_()
        least = round(_LEAST_SHARE * self._window.height())
        if dock.height() < least:
            self._window.resizeDocks([dock], [least], Qt.Orientation.Vertical)


class _Strip(QToolBar):
    """A view along the bottom of the window, across its whole width."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(tr(PANES[_STRIP].title), window)
        self.setObjectName("strip")
        self.setMovable(False)
        window.addToolBar(Qt.ToolBarArea.BottomToolBarArea, self)

    def put(self, view: QWidget) -> None:
        view.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.addWidget(view)


class Dock(QDockWidget):
    """A dock that its menu entry raises above other tabs."""

    def __init__(self, name: str, title: str, window: QMainWindow) -> None:
        super().__init__(title, window)
        self.setObjectName(name)
        self.hide()
        self._no_title = QWidget(self)
        self.seen = False  # neither hidden nor behind another tab
        self.visibilityChanged.connect(self._note)
        # Qt shows a tab of the menu's choice behind the other.
        self.toggleViewAction().triggered.connect(lambda shown: self.raise_() if shown else None)

    def show_title(self, shown: bool) -> None:
        """Show the title bar, or none: then the dock stays where it is."""
        bar = None if shown else self._no_title
        self.setTitleBarWidget(bar)  # type: ignore[arg-type]  # None restores Qt's own

    def _note(self, seen: bool) -> None:
        self.seen = seen

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close a visible dock; raise one that is behind another tab."""
        if self.isVisible() and not self.seen:
            event.ignore()
            self.toggleViewAction().setChecked(True)
            self.raise_()
        else:
            super().closeEvent(event)


class _Capitalised(QStyledItemDelegate):
    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        option.text = capitalised(option.text)


class PaneFocus(QObject):
    """Moves the focus between panes and toolbar, and marks the active pane."""

    def __init__(self, panes: Panes, toolbar: QToolBar, parent: QObject) -> None:
        super().__init__(parent)
        self._panes, self._toolbar = panes, toolbar
        self._marked: QWidget | None = None
        application().focusChanged.connect(self._mark)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            **{f"go_{name}": partial(self.go, name) for name in PANES},
            "next_pane": partial(self._step, 1),
            "previous_pane": partial(self._step, -1),
        }

    def go(self, name: str) -> None:
        self._panes.show(name)
        _enter(self._panes.place(name))

    def _step(self, by: int) -> None:
        seen = [*map(self._panes.place, filter(self._panes.seen, PANES)), self._toolbar]
        focused = application().focusWidget()
        at = next((k for k, pane in enumerate(seen) if _holds(pane, focused)), -1 if by > 0 else 0)
        _enter(seen[(at + by) % len(seen)])

    def _mark(self, _: QWidget | None, focused: QWidget | None) -> None:
        pane = next((pane for pane in map(self._panes.place, PANES) if _holds(pane, focused)), None)
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


_COMPILING = later(
    "The run waits for the compilation of its kernels (once after installation, half a minute)"
)


class EarlyParts(QObject):
    """Makes what needs no slow library, and puts it into the window."""

    def __init__(
        self, window: QMainWindow, desk: QMainWindow, document: Document, settings: QSettings
    ) -> None:
        super().__init__(window)
        self.document = document
        self.commands = Commands(window)
        self.messages = messages = Messages()
        self.log = LogView()
        messages.message.connect(self.log.add)
        self.forms = Forms(document)
        self.forms.message.connect(self.log.add)
        self.forms.file_refused.connect(messages.warn)
        self._refused = RefusedFields(self.forms, messages, self)
        self.panes = Panes(desk, self.forms, messages, document.undo_stack, self.log)
        self.panes.name_light(document.session)
        document.session_changed.connect(self.panes.name_light)
        self.dialogs = FileDialogs(document, messages, settings, window)
        self._bar = window.statusBar()
        self.shelf = shelf = Shelf()
        shelf.written.connect(self._announce)
        self.status = RunStatus(self._bar, shelf)

    def begin(self, begin: Callable[[], None]) -> None:
        self.forms.commit()
        if self.forms.refused:
            self._refused.show()
        else:
            self.messages.make_way()
            begin()

    def _announce(self, outcome: str, path: Path) -> None:
        self.messages.done(outcome, (tr("Open folder"), partial(open_folder, path)))

    def show_waiting(self, waiting: bool) -> None:
        if waiting:
            self.log.add(tr(_COMPILING))
            self._bar.showMessage(tr(_COMPILING))
        else:
            self._bar.clearMessage()
