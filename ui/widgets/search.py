"""A line that searches; Escape clears it."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit


class SearchLine(QLineEdit):
    """A line that searches."""

    def __init__(self, placeholder: str, tip: str) -> None:
        super().__init__()
        self.setPlaceholderText(placeholder)
        self.setAccessibleName(placeholder)
        self.setToolTip(tip)
        self.setClearButtonEnabled(True)

    @property
    def words(self) -> list[str]:
        """What is searched, in small letters."""
        return self.text().casefold().split()

    def begin(self) -> None:
        """Move the keyboard focus here, to search for something else."""
        self.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.selectAll()

    def event(self, event: QEvent) -> bool:
        """Take Escape from the window while there is text."""
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape and self.text():
            if event.type() != QEvent.Type.ShortcutOverride:
                self.clear()
            event.accept()
            return True
        return super().event(event)
