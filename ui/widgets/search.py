"""Search by words, whatever their case and accents are."""

import unicodedata
from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit


def folded(text: str) -> str:
    """Return a text in small letters without accents."""
    apart = unicodedata.normalize("NFKD", text.casefold())
    return "".join(sign for sign in apart if not unicodedata.combining(sign))


def holds(text: str, words: Sequence[str]) -> bool:
    """Whether all words, which are `folded`, occur in a text."""
    found = folded(text) if words else ""
    return all(word in found for word in words)


class SearchLine(QLineEdit):
    """A line that searches; Escape clears it."""

    def __init__(self, placeholder: str, tip: str) -> None:
        super().__init__()
        self.setPlaceholderText(placeholder)
        self.setAccessibleName(placeholder)
        self.setToolTip(tip)
        self.setClearButtonEnabled(True)

    @property
    def words(self) -> list[str]:
        """What is searched, `folded`."""
        return folded(self.text()).split()

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
