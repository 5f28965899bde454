"""Editors of forms, and the labels for remarks and refusals."""

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QResizeEvent
from PySide6.QtWidgets import QLineEdit

from ui.panels.edits import Typed
from ui.widgets.labels import WrappedLabel
from workbench.scene import FieldDescription


class TextEditor(QLineEdit):
    """One value as text; committed by Enter or by losing the focus, reverted by Escape."""

    committed = Signal(str)
    reverted = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._settled = ""
        self.of_design = False
        # Files dropped here are for the window, which knows what to do with them.
        self.setAcceptDrops(False)
        self.editingFinished.connect(self.commit)

    def show_value(self, text: str) -> None:
        """Show the value of the scene; earlier typing can no longer be undone here."""
        self._settled = text
        cursor = self.cursorPosition() if self.hasFocus() else 0
        self.setText(text)
        self.setCursorPosition(cursor)

    @property
    def unentered(self) -> bool:
        """Whether there is typed text that is not entered."""
        return self.text() != self._settled

    def commit(self) -> None:
        if self.unentered:
            self._settled = self.text()
            self.committed.emit(self._settled)

    def event(self, event: QEvent) -> bool:
        """Leave undo to the window where all text is entered."""
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and (
                (self.of_design and self._undoes_entry(event))
                or (event.matches(QKeySequence.StandardKey.Redo) and not self.isRedoAvailable())
            )
        ):
            event.ignore()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape or self._undoes_entry(event):
            self.reverted.emit()
        else:
            super().keyPressEvent(event)

    def _undoes_entry(self, event: QKeyEvent) -> bool:
        return event.matches(QKeySequence.StandardKey.Undo) and not self.unentered


class NumberEditor(TextEditor):
    """A number as text, because spin boxes round and change under the mouse wheel."""

    def __init__(self, field: FieldDescription) -> None:
        super().__init__()
        self._field = field
        seen = "0000" if field.count > 2 else "00000"
        self.setMinimumWidth(self.fontMetrics().horizontalAdvance(seen))

    def typed(self, text: str) -> Typed:
        field = self._field
        return Typed(text, field.measure, field.number is int, field.times)


class Remark(WrappedLabel):
    """Wrapped text, hidden if empty, that is never cut off.

    Forms ask for its height before they know its width.
    """

    def __init__(self, style: str = "") -> None:
        super().__init__(textFormat=Qt.TextFormat.PlainText)
        self.setObjectName(style)
        self.hide()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._insist()

    def show_text(self, text: str) -> None:
        self.setText(text)
        self._insist()
        self.setVisible(bool(text))

    def _insist(self) -> None:
        self.setMinimumHeight(max(0, self.heightForWidth(self.width())))
