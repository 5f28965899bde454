"""Geometry and docks of the window, and the view state that a design keeps."""

import base64
import binascii
from collections.abc import Callable, Mapping
from typing import Any, Protocol

from PySide6.QtCore import QByteArray, QSettings, QSize, Qt, QTimer
from PySide6.QtWidgets import QMainWindow

from ui.commands.actions import LOOK, Commands
from ui.window.workspace import DockWorkspace
from ui.words import tr

_SHARE_OF_SCREEN = 0.85
_SIZE = QSize(1280, 800)  # below which panes are too small
_FRAME = QSize(16, 64)  # that a desktop may put around a window
_GEOMETRY, _DOCKS = "window/geometry", "window/result-first"


class Layout:
    """Geometry of a window and arrangement of its docks."""

    def __init__(self, window: QMainWindow, workspace: DockWorkspace, settings: QSettings) -> None:
        self._window, self._workspace, self._settings = window, workspace, settings
        available = window.screen().availableSize()
        window.resize((available * _SHARE_OF_SCREEN).expandedTo(_SIZE).boundedTo(available))
        framed = window.size() + _FRAME
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


class CameraView(Protocol):
    """A view with a camera."""

    def camera(self) -> dict[str, Any] | None:
        """Camera as plain data; None before the first drawing."""

    def set_camera(self, camera: dict[str, Any]) -> None:
        """Restore the camera; raise ValueError if it is invalid."""


class ViewState:
    """How a design is shown (docks, options, camera), as plain data."""

    def __init__(self, commands: Commands, layout: Layout, tell: Callable[[str], None]) -> None:
        self._commands, self._layout, self._tell = commands, layout, tell
        self._eye: CameraView | None = None
        self._waiting: Mapping[str, Any] | None = None  # for the views

    def to_data(self) -> dict[str, Any]:
        if self._waiting is not None:  # nobody has seen another
            return dict(self._waiting)
        on = [name for name in LOOK if self._commands[name].isChecked()]
        data: dict[str, Any] = {_LAYOUT: self._layout.to_text(), _ON: on}
        camera = None if self._eye is None else self._eye.camera()
        return data if camera is None else {**data, _CAMERA: camera}

    def restore(self, data: Mapping[str, Any] | None) -> None:
        """Restore the view as far as the data are valid."""
        self._waiting = None
        if data is None:
            return
        self._try("docks", lambda: self._layout.restore(_of_kind(data, _LAYOUT, str)))
        if self._eye is None:
            self._waiting = data
        else:
            self._restore_look(data, self._eye)

    def attach(self, eye: CameraView) -> None:
        self._eye = eye
        if self._waiting is not None:
            self._restore_look(self._waiting, eye)
            self._waiting = None

    def _restore_look(self, data: Mapping[str, Any], eye: CameraView) -> None:
        self._try("choices", lambda: self._switch(_of_kind(data, _ON, list)))
        if _CAMERA in data:
            self._try("camera", lambda: eye.set_camera(_of_kind(data, _CAMERA, dict)))

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
            self._tell(
                tr("The view settings ({what}) of this design cannot be restored: {error}").format(
                    what=what, error=error
                )
            )


def _of_kind(data: Mapping[str, Any], key: str, kind: type[Any]) -> Any:
    value = data.get(key)
    if not isinstance(value, kind):
        raise ValueError(f"{key} is no {kind.__name__}")
    return value
