"""Opens the dialog of sweeps, one for each window."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from ui.document.document import Document

if TYPE_CHECKING:
    from ui.dialogs.sweep import SweepDialog
    from workbench.files.session import Session


class Sweeps(QObject):
    """Knows the dialog, once it was asked for."""

    def __init__(
        self, document: Document, open_file: Callable[[Path], object], window: QWidget
    ) -> None:
        super().__init__(window)
        self._document, self._open, self._window = document, open_file, window
        self.dialog: SweepDialog | None = None

    def show(self) -> None:
        """Show the dialog, with the fields of the design as it is."""
        if self.dialog is None:
            from ui.dialogs.sweep import SweepDialog  # late: it draws with matplotlib

            self.dialog = SweepDialog(self._design, self._window)
            self.dialog.open_asked.connect(self._open)
        self.dialog.show_design()
        self.dialog.show()
        self.dialog.raise_()
        self.dialog.activateWindow()

    def _design(self) -> "tuple[Path, Session]":
        return self._document.suggested_path, self._document.session

    def close(self) -> None:
        """Leave a sweep that is under way; safe to call twice."""
        if self.dialog is not None:
            self.dialog.close_thread()
            self.dialog.close()
