"""Shown lens: the latest frame of a run, a preview or the history."""

from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import QObject, QTimer, Signal

from ui.document.document import Document
from ui.shown.frame import lit_alike, shows

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session

_AT_ONCE_MS = 250  # for a person; most frames of an edited design come sooner, and nothing flickers


class FrameView(Protocol):
    """Something that shows designs and their frames."""

    def show_design(self, session: "Session") -> None:
        """Store another scene or target."""

    def show_frame(self, frame: "Frame") -> None:
        """Show a frame."""

    def show_nothing(self, session: "Session") -> None:
        """Show a design without a frame."""

    def show_outdated(self, outdated: bool) -> None:
        """Mark the shown frame as that of another design, or remove the mark."""


class ShownLens(QObject):
    """Passes frames from their producers to the views; neither knows the other."""

    frame_changed = Signal(object)
    emptied = Signal(object)
    outdated_changed = Signal(bool)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._frame: Frame | None = None
        self._outdated = False
        self._wait = QTimer(self, singleShot=True, interval=_AT_ONCE_MS)
        self._wait.timeout.connect(lambda: self._mark(True))
        document.session_changed.connect(self._follow)
        self.frame_changed.connect(self._take)
        self.emptied.connect(self._empty)

    def add(self, view: FrameView) -> None:
        """Show the present design in a view, and all later frames."""
        view.show_design(self._document.session)
        self._document.session_changed.connect(view.show_design)
        self.frame_changed.connect(view.show_frame)
        self.emptied.connect(view.show_nothing)
        self.outdated_changed.connect(view.show_outdated)

    def _follow(self, session: "Session") -> None:
        self._judge(self._frame is None or shows(self._frame, session))

    def _take(self, frame: "Frame") -> None:
        self._frame = frame
        self._mark(False)
        self._judge(lit_alike(frame.session, self._document.session))

    def _empty(self, session: "Session") -> None:
        self._frame = None
        self._judge(True)

    def _judge(self, up_to_date: bool) -> None:
        if up_to_date:
            self._wait.stop()
            self._mark(False)
        elif not self._wait.isActive():
            self._wait.start()

    def _mark(self, outdated: bool) -> None:
        if outdated != self._outdated:
            self._outdated = outdated
            self.outdated_changed.emit(outdated)
