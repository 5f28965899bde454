"""Opens the start page over a window, and takes its job into the window's design."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from ui.files.actions import FileActions
from ui.files.dialogs import FileDialogs
from ui.jobs.page import StartPage

if TYPE_CHECKING:
    from workbench.files.session import Session


class Start(QObject):
    """Has at most one start page open.

    Parameters
    ----------
    files : FileActions
        Take the new design, or open a file in its place.
    show_examples : callable
        Shows the gallery of examples.
    dialogs : FileDialogs
        Ask for files.
    window : QWidget
        The page stands over it.

    Attributes
    ----------
    open_changed : Signal(bool)
        Whether the page is there.
    """

    open_changed = Signal(bool)

    def __init__(
        self,
        files: FileActions,
        show_examples: Callable[[], object],
        dialogs: FileDialogs,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._files, self._show_examples = files, show_examples
        self._dialogs, self._window = dialogs, window
        self.page: StartPage | None = None

    def show(self) -> None:
        """Show the page, unless it is there."""
        if self.page is not None:
            return
        self.page = page = StartPage(self._dialogs, self._window)
        page.begun.connect(self._begin)
        page.open_asked.connect(self._files.choose_and_open)
        page.examples_asked.connect(self._show_examples)
        page.finished.connect(self._forget)
        self.open_changed.emit(True)
        page.open()

    def close(self) -> None:
        """Close the page, if it is there."""
        if self.page is not None:
            self.page.reject()

    def _begin(self, session: "Session", name: str) -> None:
        """Take the job into the window; the page stays where that is not wanted after all."""
        if self._files.begin(session, name) and self.page is not None:
            self.page.accept()

    def _forget(self) -> None:
        self.page = None
        self.open_changed.emit(False)
