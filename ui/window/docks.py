"""Docks of the window and their layout, and all parts of it that need no slow library."""

import base64
import binascii
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import (
    QByteArray,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSettings,
    QSize,
    Qt,
    QTimer,
)
from PySide6.QtGui import QCloseEvent, QUndoStack
from PySide6.QtWidgets import (
    QDockWidget,
    QFrame,
    QGridLayout,
    QLabel,
    QMainWindow,
    QStackedWidget,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QUndoView,
    QWidget,
)

from ui.commands.actions import LOOK, Commands
from ui.commands.panes import PANES
from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.panels.forms import Forms
from ui.run.status import RunStatus
from ui.widgets.messages import LogView, MessageBar
from ui.widgets.native import Uncovered
from ui.window.edit_notices import RefusedFields
from ui.words import in_sentence, later, tr

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView
    from workbench.files.session import Session


_FRAME = 2  # pixels around the 3D scene, highlighted when it has the keyboard

# Shares of the window for forms, images of light, and what stands beside the 3D scene. The images
# have a third of the window: 0.75 of its width and 0.49 of its height.
_FORMS_SHARE = 0.25
_IMAGES_SHARE = 0.49
_BESIDE_SHARE = 0.27
_IMAGES = ("irradiance", "target", "error")


class DockWorkspace:
    """Docks around the 3D scene; the views come later, because their libraries load slowly."""

    def __init__(
        self,
        window: QMainWindow,
        forms: Forms,
        messages: MessageBar,
        steps: QUndoStack,
        log: LogView,
    ) -> None:
        self._window = window
        self._stage = QStackedWidget()
        self._placeholder = QLabel(
            tr("Loading the 3D scene…"), alignment=Qt.AlignmentFlag.AlignCenter
        )
        self._placeholder.setWordWrap(True)  # or no window could be narrower than its words
        self._stage.addWidget(self._placeholder)
        self.centre = centre = QFrame()
        centre.setObjectName("centre")  # for the style sheet
        # One over the other: a message that comes or goes leaves the picture as it is.
        over = QGridLayout(centre)
        over.setContentsMargins(*4 * [_FRAME])
        over.addWidget(self._stage, 0, 0)
        over.addWidget(messages, 0, 0, Qt.AlignmentFlag.AlignTop)
        window.setCentralWidget(centre)
        window.setCorner(Qt.Corner.BottomLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea)
        window.setCorner(Qt.Corner.TopLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea)
        window.setCorner(Qt.Corner.TopRightCorner, Qt.DockWidgetArea.TopDockWidgetArea)
        window.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)
        self.docks = {
            name: self._dock(name, tr(pane.title), pane.area)
            for name, pane in PANES.items()
            if pane.area is not None
        }
        self.history = QUndoView(steps)
        self.history.setEmptyLabel(tr("As opened"))
        self.history.setItemDelegate(_Capitalised(self.history))
        self.history.setToolTip(tr("Click a step to restore it"))
        there: dict[str, QWidget] = {"design": forms, "history": self.history, "log": log}
        self._waiting = self.docks.keys() - there.keys()
        for name, dock in self.docks.items():
            placeholder = QLabel(tr("Loading…"), alignment=Qt.AlignmentFlag.AlignCenter)
            dock.setWidget(there.get(name, placeholder))
        self._stack()
        # A dock that comes between others gets no more than it cannot do without.
        shown = self.docks["target"].toggleViewAction().toggled
        shown.connect(lambda shown: QTimer.singleShot(0, window, self._share) if shown else None)

    def arrange(self) -> None:
        docks, width, height = self.docks, self._window.width(), self._window.height()
        across, up = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        self._window.resizeDocks(
            [docks["design"], docks["loss"]],
            [int(_FORMS_SHARE * width), int(_BESIDE_SHARE * width)],
            across,
        )
        self._window.resizeDocks([docks["irradiance"]], [int(_IMAGES_SHARE * height)], up)
        self._window.resizeDocks([docks[name] for name in _IMAGES], [1, 1, 1], across)

    def put_views(self, scene_view: QWidget, others: Mapping[str, QWidget]) -> None:
        if self._waiting != others.keys():
            wrong = sorted(self._waiting ^ others.keys())
            raise ValueError(f"no dock, or nothing for it: {wrong}")
        Uncovered(self._window)
        self._stage.addWidget(scene_view)
        self._stage.setCurrentWidget(scene_view)
        for name, view in others.items():
            placeholder = self.docks[name].widget()
            self.docks[name].setWidget(view)
            placeholder.deleteLater()
        self._placeholder.setText(tr("The 3D scene is hidden. View > 3D scene shows it again."))

    def name_light(self, session: "Session") -> None:
        density = tr(session.scene.receiver.density.capitalize())
        self.docks["irradiance"].setWindowTitle(density)
        self.docks["error"].setWindowTitle(f"{density} − {in_sentence(tr(PANES['target'].title))}")

    def show_dock(self, name: str) -> None:
        self.docks[name].show()
        self.docks[name].raise_()

    def show_scene_view(self, shown: bool) -> None:
        """Show or hide the 3D scene; a hidden one costs no time in a run."""
        self._stage.setCurrentIndex(1 if shown else 0)

    def _stack(self) -> None:
        """Arrange the docks as `PANES` specifies."""
        # Tabs of docks that are shown leave bars behind, which lie about until Qt deletes them.
        for name, dock in self.docks.items():
            dock.setVisible(PANES[name].shown and not PANES[name].behind)
        for name, dock in self.docks.items():
            if PANES[name].right_of:
                beside = self.docks[PANES[name].right_of]
                self._window.splitDockWidget(beside, dock, Qt.Orientation.Horizontal)
            if PANES[name].behind:
                front = self.docks[PANES[name].behind]
                self._window.tabifyDockWidget(front, dock)
                dock.setVisible(PANES[name].shown)
                front.raise_()

    def _share(self) -> None:
        """Give all images the same width if one has become too narrow."""
        images = [self.docks[name] for name in _IMAGES if self.docks[name].isVisible()]
        widths = [image.width() for image in images]
        if widths and min(widths) < max(widths) / 2:
            even = sum(widths) // len(images)  # less would make all as narrow as they can be
            self._window.resizeDocks(images, len(images) * [even], Qt.Orientation.Horizontal)

    def _dock(self, name: str, title: str, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = _Dock(title, self._window)
        dock.setObjectName(name)
        self._window.addDockWidget(area, dock)
        # Qt shows a tab of the menu's choice behind the other.
        dock.toggleViewAction().triggered.connect(lambda shown: dock.raise_() if shown else None)
        return dock


class _Dock(QDockWidget):
    """A dock that its menu entry raises above other tabs."""

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close a visible dock; raise one that is behind another tab."""
        if self.isVisible() and self.visibleRegion().isEmpty():
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
        text = option.text
        option.text = text[:1].upper() + text[1:]


_COMPILING = later(
    "The run waits for the compilation of its kernels (once after installation, half a minute)"
)


class EarlyParts(QObject):
    """Makes what needs no slow library, and puts it into the window."""

    def __init__(self, window: QMainWindow, document: Document, settings: QSettings) -> None:
        super().__init__(window)
        self.document = document
        self.commands = Commands(window)
        self.messages = messages = MessageBar()
        self.log = LogView()
        messages.message.connect(self.log.add)
        self.forms = Forms(document)
        self.forms.message.connect(self.log.add)
        self.forms.file_refused.connect(messages.warn)
        self._refused = RefusedFields(self.forms, messages, self)
        self.workspace = DockWorkspace(window, self.forms, messages, document.undo_stack, self.log)
        self.workspace.name_light(document.session)
        document.session_changed.connect(self.workspace.name_light)
        self.dialogs = FileDialogs(document, settings, window)
        self._bar = window.statusBar()
        self.status = RunStatus(self._bar)

    def begin(self, begin: Callable[[], None]) -> None:
        self.forms.commit()
        if self.forms.refused:
            self._refused.show()
        else:
            self.messages.make_way()
            begin()

    def show_waiting(self, waiting: bool) -> None:
        if waiting:
            self.log.add(tr(_COMPILING))
            self._bar.showMessage(tr(_COMPILING))
        else:
            self._bar.clearMessage()


_SHARE_OF_SCREEN = 0.85
_SIZE = QSize(1280, 800)  # below which panes are too small
_DESKTOP_FRAME = QSize(16, 64)  # that a desktop may put around a window
_GEOMETRY, _DOCKS = "window/geometry", "window/result-first"


class Layout:
    """Geometry of a window and arrangement of its docks."""

    def __init__(self, window: QMainWindow, workspace: DockWorkspace, settings: QSettings) -> None:
        self._window, self._workspace, self._settings = window, workspace, settings
        available = window.screen().availableSize()
        window.resize((available * _SHARE_OF_SCREEN).expandedTo(_SIZE).boundedTo(available))
        framed = window.size() + _DESKTOP_FRAME
        if framed.boundedTo(available) != framed:  # the desktop knows best what fits in
            window.setWindowState(Qt.WindowState.WindowMaximized)
        workspace.arrange()
        self._first = window.saveState()
        for key, restore in ((_GEOMETRY, window.restoreGeometry), (_DOCKS, window.restoreState)):
            kept = settings.value(key)
            if isinstance(kept, QByteArray):
                restore(kept)

    def reset(self) -> None:
        self._window.restoreState(self._first)
        available = self._window.screen().availableSize()
        self._window.resize(self._window.size().boundedTo(available))
        # Docks that were hidden just now take space until all are laid out.
        QTimer.singleShot(0, self._window, self._workspace.arrange)

    def keep(self) -> None:
        self._settings.setValue(_GEOMETRY, self._window.saveGeometry())
        self._settings.setValue(_DOCKS, self._window.saveState())

    def to_text(self) -> str:
        return base64.b64encode(self._window.saveState().data()).decode("ascii")

    def restore(self, text: str) -> None:
        try:
            state = base64.b64decode(text, validate=True)
        except binascii.Error as error:
            raise ValueError("the layout of the docks is no base64") from error
        if not self._window.restoreState(QByteArray(state)):
            raise ValueError("the layout of the docks is none of this program's")


_LAYOUT, _ON, _CAMERA = "layout", "on", "camera"


class ViewState:
    """How a design is shown (docks, options, camera), as plain data."""

    def __init__(self, commands: Commands, layout: Layout, log: Callable[[str], None]) -> None:
        self._commands, self._layout, self._log = commands, layout, log
        self._scene_view: SceneView | None = None
        self._waiting: Mapping[str, Any] | None = None  # for the views

    def to_data(self) -> dict[str, Any]:
        if self._waiting is not None:  # nobody has seen another
            return dict(self._waiting)
        on = [name for name in LOOK if self._commands[name].isChecked()]
        data: dict[str, Any] = {_LAYOUT: self._layout.to_text(), _ON: on}
        camera = None if self._scene_view is None else self._scene_view.camera()
        return data if camera is None else {**data, _CAMERA: camera}

    def restore(self, data: Mapping[str, Any] | None) -> None:
        """Restore the view as far as the data are valid."""
        self._waiting = None
        if data is None:
            return
        self._try("docks", lambda: self._layout.restore(_of_kind(data, _LAYOUT, str)))
        if self._scene_view is None:
            self._waiting = data
        else:
            self._restore_look(data, self._scene_view)

    def attach(self, scene_view: "SceneView") -> None:
        self._scene_view = scene_view
        if self._waiting is not None:
            self._restore_look(self._waiting, scene_view)
            self._waiting = None

    def _restore_look(self, data: Mapping[str, Any], scene_view: "SceneView") -> None:
        self._try("choices", lambda: self._switch(_of_kind(data, _ON, list)))
        if _CAMERA in data:
            self._try("camera", lambda: scene_view.set_camera(_of_kind(data, _CAMERA, dict)))

    def _switch(self, on: list[Any]) -> None:
        for name in LOOK:
            action = self._commands[name]
            only_one = action.actionGroup() is not None  # is switched off by another
            if not (only_one and action.isChecked()):
                action.setChecked(name in on)

    def _try(self, what: str, restore: Callable[[], None]) -> None:
        try:
            restore()
        except ValueError as error:
            self._log(
                tr("The view settings ({what}) of this design cannot be restored: {error}").format(
                    what=what, error=error
                )
            )


def _of_kind(data: Mapping[str, Any], key: str, kind: type[Any]) -> Any:
    value = data.get(key)
    if not isinstance(value, kind):
        raise ValueError(f"{key} is no {kind.__name__}")
    return value
