"""What a window shows: its design, and the latest frame of a run, a preview or the history."""

from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import QObject, Signal

from ui.document.document import Document

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session


class FrameView(Protocol):
    """Something that shows designs and their frames."""

    def show_design(self, session: "Session") -> None:
        """Take note of another scene or target."""

    def show_frame(self, frame: "Frame") -> None:
        """Show a frame."""

    def show_nothing(self, session: "Session") -> None:
        """Show a design of which there is no frame."""


class ShownLens(QObject):
    """Passes frames from those that make them to those that show them; neither knows the other.

    Attributes
    ----------
    frame_changed : Signal(Frame)
        Another frame is shown.
    emptied : Signal(Session)
        There is no frame of this design.
    """

    frame_changed = Signal(object)
    emptied = Signal(object)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document

    def add(self, view: FrameView) -> None:
        """Let a view show the design of now, and from then on whatever is shown."""
        view.show_design(self._document.session)
        self._document.session_changed.connect(view.show_design)
        self.frame_changed.connect(view.show_frame)
        self.emptied.connect(view.show_nothing)
