"""Log of the window, with the time of day."""

from datetime import datetime

from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QPlainTextEdit

from ui.words import tr

_LINES = 2000  # of which the oldest give way


class LogView(QPlainTextEdit):
    """Read-only text that stays at its end unless the user scrolls."""

    def __init__(self) -> None:
        super().__init__()
        self.setReadOnly(True)
        self.setUndoRedoEnabled(False)
        self.setMaximumBlockCount(_LINES)
        self.setFrameShape(QPlainTextEdit.Shape.NoFrame)
        self.setPlaceholderText(tr("What runs, checks and exports tell is written here."))
        self.setAccessibleName(tr("Log"))
        self._at_end = True
        bar = self.verticalScrollBar()
        bar.rangeChanged.connect(lambda _, end: bar.setValue(end) if self._at_end else None)
        bar.valueChanged.connect(self._note_place)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Stay at the end, which moves when lines are wrapped differently."""
        at_end = self._at_end
        super().resizeEvent(event)
        if at_end:
            bar = self.verticalScrollBar()
            bar.setValue(bar.maximum())
            self._at_end = True

    def add(self, sentence: str) -> None:
        """Write a line below the others."""
        self.appendPlainText(f"{datetime.now():%H:%M:%S}  {' '.join(sentence.split())}")

    def add_details(self, text: str) -> None:
        """Write lines below the others, as they are."""
        self.appendPlainText(text.rstrip())

    def _note_place(self, value: int) -> None:
        self._at_end = value == self.verticalScrollBar().maximum()
