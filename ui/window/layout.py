"""Where the window stands and how its docks are laid out."""

import base64
import binascii

from PySide6.QtCore import QByteArray, QSettings, QSize, Qt, QTimer
from PySide6.QtWidgets import QMainWindow

from ui.window.workspace import DockWorkspace

_SHARE_OF_SCREEN = 0.85
_SIZE = QSize(1280, 800)  # below which panes have little room
_FRAME = QSize(16, 64)  # that a desktop may put around a window
_GEOMETRY, _DOCKS = "window/geometry", "window/result-first"


class Layout:
    """As at first, as it was when a window was last closed, or as a design brings it.

    Parameters
    ----------
    window : QMainWindow
        With all its docks; it is given a size here.
    workspace : DockWorkspace
        Shares the window out among the docks.
    settings : QSettings
        Where size, place and docks outlive the window.
    """

    def __init__(self, window: QMainWindow, workspace: DockWorkspace, settings: QSettings) -> None:
        self._window, self._workspace, self._settings = window, workspace, settings
        room = window.screen().availableSize()
        window.resize((room * _SHARE_OF_SCREEN).expandedTo(_SIZE).boundedTo(room))
        framed = window.size() + _FRAME
        if framed.boundedTo(room) != framed:  # the desktop knows best what fits in
            window.setWindowState(Qt.WindowState.WindowMaximized)
        workspace.arrange()
        self._first = window.saveState()
        for key, restore in ((_GEOMETRY, window.restoreGeometry), (_DOCKS, window.restoreState)):
            kept = settings.value(key)
            if isinstance(kept, QByteArray):
                restore(kept)

    def reset(self) -> None:
        """All docks as at first; a window that they made larger than the screen fits again."""
        self._window.restoreState(self._first)
        room = self._window.screen().availableSize()
        self._window.resize(self._window.size().boundedTo(room))
        # Docks that were hidden just now have a share of the room until all are laid out.
        QTimer.singleShot(0, self._window, self._workspace.arrange)

    def keep(self) -> None:
        """Remember size, place and docks for the next window."""
        self._settings.setValue(_GEOMETRY, self._window.saveGeometry())
        self._settings.setValue(_DOCKS, self._window.saveState())

    def to_text(self) -> str:
        """The docks of now."""
        return base64.b64encode(self._window.saveState().data()).decode("ascii")

    def restore(self, text: str) -> None:
        """Lay the docks out as `to_text` describes.

        Raises
        ------
        ValueError
            If the text is none of its.
        """
        try:
            state = base64.b64decode(text, validate=True)
        except binascii.Error as error:
            raise ValueError("the layout of the docks is no base64") from error
        if not self._window.restoreState(QByteArray(state)):
            raise ValueError("the layout of the docks is none of this program's")
