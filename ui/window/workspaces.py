"""Workspaces of a window: which panes it shows where, and how a design is looked at."""

import base64
import binascii
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QByteArray, QEvent, QObject, QSettings, QSize, Qt, QTimer, Signal
from PySide6.QtWidgets import QMainWindow

from ui.commands.actions import LOOK, Commands
from ui.commands.panes import WORKSPACES, Tabs, Workspace
from ui.widgets.native import available_size
from ui.window.docks import Dock, Panes
from ui.words import tr
from workbench.files.session import Session

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

CUSTOM = "custom"
"""The workspace whose docks have title bars, to be arranged by hand."""

_FIRST = "task"
_SHARE_OF_SCREEN = 0.85
_SIZE = QSize(1280, 800)  # below which panes are too small
_DESKTOP_FRAME = QSize(16, 64)  # that a desktop may put around a window
_GEOMETRY, _KEPT = "window/geometry", "window/workspaces"
_VERSION = 2  # of the docks' names; Qt refuses a layout of another one
# Logical pixels, and shares of the window, for the forms and for what stands at the right.
_FORMS, _FORMS_SHARE = 340, 0.3
_RIGHT, _RIGHT_SHARE = 380, 0.35
_BESIDE_IMAGE = 76  # buttons above the image and figures below it
_SCENE_ABOVE = 0.42  # of the height
_LEAST_BELOW = 0.28  # of the height, however wide the image is
_SCENE = ("scene",)
_IMAGE_SHARE = 0.34  # of the width, at least, whatever the docks would like
# The 3D scene stands beside images that are narrower than this, in widths for each height; below
# wider ones.
_WIDE = 1.4

_LEFT_AREA = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT_AREA = Qt.DockWidgetArea.RightDockWidgetArea
_BOTTOM_AREA = Qt.DockWidgetArea.BottomDockWidgetArea
_ACROSS, _DOWNWARDS = Qt.Orientation.Horizontal, Qt.Orientation.Vertical


class Workspaces(QObject):
    """Arranges the panes of a window for one part of the work, and keeps what a hand changed."""

    changed = Signal(str)

    def __init__(self, desk: QMainWindow, panes: Panes, settings: QSettings) -> None:
        super().__init__(desk)
        self._desk, self._panes, self._settings = desk, panes, settings
        self._unseen = True  # arranged while the desk is hidden, and not laid out yet
        desk.installEventFilter(self)
        window = desk.window()
        self._aspect = 1.0  # width over height of the image of light
        available = available_size(window)
        window.resize((available * _SHARE_OF_SCREEN).expandedTo(_SIZE).boundedTo(available))
        framed = window.size() + _DESKTOP_FRAME
        if framed.boundedTo(available) != framed:  # the desktop knows best what fits in
            window.setWindowState(Qt.WindowState.WindowMaximized)
        kept = settings.value(_GEOMETRY)
        if isinstance(kept, QByteArray):
            window.restoreGeometry(kept)
        desk.resize(window.size())
        self.name = ""
        self.choose(_FIRST)

    def choose(self, name: str) -> None:
        """Show a workspace as it was left, or as it is from the start."""
        if name == self.name:
            return
        if self.name:
            self.keep()
        self.name = name
        self._show()
        if name in WORKSPACES:
            self._panes.images.choose(WORKSPACES[name].image)
        self.changed.emit(name)

    def reset(self) -> None:
        """Arrange the workspace as it is from the start; the custom one as *Design*."""
        self._settings.remove(self._key)
        window = self._desk.window()
        window.resize(window.size().boundedTo(available_size(window)))
        self._arrange()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Share the space of a desk that has another size, or was hidden until now."""
        if event.type() == QEvent.Type.Show and self._unseen:
            self._unseen = False
            if self._settings.value(self._key) is None:
                QTimer.singleShot(0, self, self._share)
        if event.type() == QEvent.Type.Resize:
            QTimer.singleShot(0, self, self._give_way)
        return False

    def follow(self, session: Session) -> None:
        """Arrange the panes anew where an image of another shape needs another place."""
        across, up = session.scene.receiver.half_extent
        before, self._aspect = self._wide, across / up
        if self._wide is not before and self.name in WORKSPACES:
            self._show()

    def reveal(self, name: str, workspace: str) -> None:
        """Show a pane: in its workspace if it is not shown, unless docks are arranged by hand."""
        if self.name != CUSTOM and not self._panes.place(name).isVisible():
            self.choose(workspace)
        self._panes.show(name)

    def keep(self) -> None:
        """Keep the arrangement for the next time."""
        self._settings.setValue(_GEOMETRY, self._desk.window().saveGeometry())
        if not self._unseen:
            self._settings.setValue(self._key, self._desk.saveState(_VERSION))

    def to_text(self) -> str:
        return base64.b64encode(self._desk.saveState(_VERSION).data()).decode("ascii")

    def restore(self, name: str, text: str) -> None:
        """Show a workspace with an arrangement of `to_text`."""
        try:
            state = base64.b64decode(text, validate=True)
        except binascii.Error as error:
            raise ValueError("the layout of the docks is no base64") from error
        if name not in (*WORKSPACES, CUSTOM):
            raise ValueError(f"there is no workspace {name!r}")
        self.choose(name)
        if not self._desk.restoreState(QByteArray(state), _VERSION):
            raise ValueError("the layout of the docks is none of this program's")

    @property
    def _key(self) -> str:
        shape = "-wide" if self._wide and self.name != CUSTOM else ""
        return f"{_KEPT}/{self.name}{shape}"

    @property
    def _workspace(self) -> Workspace:
        return WORKSPACES.get(self.name, WORKSPACES["design"])

    @property
    def _wide(self) -> bool:
        return self._aspect > _WIDE

    def _show(self) -> None:
        for dock in self._panes.docks.values():
            dock.show_title(self.name == CUSTOM)
        self._panes.strip.setVisible(self._workspace.strip)
        kept = self._settings.value(self._key)
        if not (isinstance(kept, QByteArray) and self._desk.restoreState(kept, _VERSION)):
            self._arrange()
        QTimer.singleShot(0, self, self._give_way)

    def _arrange(self) -> None:
        window, docks = self._desk, self._panes.docks
        self._unseen = not window.isVisible()
        self._panes.strip.setVisible(self._workspace.strip)
        for dock in docks.values():
            window.removeDockWidget(dock)
        places = self._places()
        shown = {name for groups in places.values() for group in groups for name in group}
        # Others come as tabs behind the last ones at the right, when they are asked for.
        others = tuple(name for name in docks if name not in shown)
        right = [*places[_RIGHT_AREA]]
        last = right.pop() if right and right[-1] != _SCENE else ()
        places = {**places, _RIGHT_AREA: (*right, (*last, *others))}
        for area, groups in places.items():
            for group in groups:
                for name in group:
                    along = _ACROSS if area == _BOTTOM_AREA else _DOWNWARDS
                    window.addDockWidget(area, docks[name], along)
                    if name != group[0]:
                        window.tabifyDockWidget(docks[group[0]], docks[name])
        # Only then: one below the other, docks would need a larger window.
        for name, dock in docks.items():
            dock.setVisible(name in shown)
        for groups in places.values():
            for front, *_ in groups:
                docks[front].raise_()
        self._share()
        # Docks that were hidden just now take space until all are laid out.
        QTimer.singleShot(0, self, self._share)

    def _places(self) -> dict[Qt.DockWidgetArea, tuple[Tabs, ...]]:
        """Groups of docks by areas."""
        shown = self._workspace
        if not self._wide:
            return {_LEFT_AREA: shown.left, _RIGHT_AREA: shown.right}
        # Beside a form, a wide image would have too little width between two columns.
        below = tuple(group for group in shown.right if shown.left or group == _SCENE)
        right = tuple(group for group in shown.right if group not in below)
        return {_LEFT_AREA: shown.left, _RIGHT_AREA: right, _BOTTOM_AREA: below}

    def _give_way(self) -> None:
        """Narrow the docks beside an image that has less than its part of the window."""
        lacking = round(_IMAGE_SHARE * self._desk.width()) - self._panes.images.width()
        docks = [dock for dock in self._panes.docks.values() if self._beside_image(dock)]
        spare: dict[int, int] = {}  # by the left edges of columns
        for dock in docks:
            more = dock.width() - dock.minimumSizeHint().width()
            spare[dock.x()] = min(more, spare.get(dock.x(), more))
        if lacking > 0 and any(spare.values()):
            part = min(lacking / sum(spare.values()), 1.0)
            widths = [dock.width() - round(part * spare[dock.x()]) for dock in docks]
            self._desk.resizeDocks(docks, widths, Qt.Orientation.Horizontal)

    def _beside_image(self, dock: Dock) -> bool:
        area = self._desk.dockWidgetArea(dock)
        return dock.seen and not dock.isFloating() and area != _BOTTOM_AREA

    def _share(self) -> None:
        """Give the image of light as much as it can use."""
        window, docks, places = self._desk, self._panes.docks, self._places()
        width, height = window.width(), window.height()
        left = min(_FORMS, round(_FORMS_SHARE * width)) if places[_LEFT_AREA] else 0
        right = min(_RIGHT, round(_RIGHT_SHARE * width)) if places[_RIGHT_AREA] else 0
        if _BOTTOM_AREA not in places:
            tall = self._panes.images.height() - _BESIDE_IMAGE
            right = max(right, width - left - round(tall * self._aspect))
        widths = {_LEFT_AREA: left, _RIGHT_AREA: right}
        beside = {docks[places[area][0][0]]: widths[area] for area in widths if places[area]}
        window.resizeDocks(list(beside), list(beside.values()), Qt.Orientation.Horizontal)
        column = [docks[front] for front, *_ in places[_RIGHT_AREA]]
        if len(column) > 1:
            parts = [_SCENE_ABOVE, *(len(column) - 1) * [(1 - _SCENE_ABOVE) / (len(column) - 1)]]
            window.resizeDocks(column, [round(part * height) for part in parts], _DOWNWARDS)
        row = [docks[front] for front, *_ in places.get(_BOTTOM_AREA, ())]
        if row:
            needed = round((width - left - right) / self._aspect) + _BESIDE_IMAGE
            below = max(height - needed, round(_LEAST_BELOW * height))
            window.resizeDocks(row, len(row) * [below], _DOWNWARDS)
            window.resizeDocks(row, len(row) * [(width - left) // len(row)], _ACROSS)


_WORKSPACE, _LAYOUT, _ON, _CAMERA = "workspace", "layout", "on", "camera"


class ViewState:
    """How a design is shown (docks, options, camera), as plain data."""

    def __init__(
        self, commands: Commands, workspaces: Workspaces, log: Callable[[str], None]
    ) -> None:
        self._commands, self._workspaces, self._log = commands, workspaces, log
        self._scene_view: SceneView | None = None
        self._waiting: Mapping[str, Any] | None = None  # for the views

    def to_data(self) -> dict[str, Any]:
        if self._waiting is not None:  # nobody has seen another
            return dict(self._waiting)
        on = [name for name in LOOK if self._commands[name].isChecked()]
        workspaces = self._workspaces
        data = {_WORKSPACE: workspaces.name, _LAYOUT: workspaces.to_text(), _ON: on}
        camera = None if self._scene_view is None else self._scene_view.camera()
        return data if camera is None else {**data, _CAMERA: camera}

    def restore(self, data: Mapping[str, Any] | None) -> None:
        """Restore the view as far as the data are valid."""
        self._waiting = None
        if data is None:
            return
        if _WORKSPACE in data:  # else of a program that had none
            places = (_of_kind(data, key, str) for key in (_WORKSPACE, _LAYOUT))
            self._try("docks", lambda: self._workspaces.restore(*places))
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
