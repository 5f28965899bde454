"""Message bar and log of the window."""

from collections.abc import Callable, Sequence
from datetime import datetime
from typing import TypeVar

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QPlainTextEdit,
    QPushButton,
    QSizePolicy,
    QStyle,
    QToolButton,
    QWidget,
)

from ui.widgets import theme
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import make_native
from ui.words import tr

Value = TypeVar("Value")

Offer = tuple[str, Callable[[], object]]
"""Text and action of a button beside a message."""


class MessageBar(QFrame):
    """Shows failures and notes without blocking the user; hidden while empty."""

    message = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAutoFillBackground(True)
        make_native(self)
        self._icon = QLabel()
        self._text = WrappedLabel()
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._text.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.buttons: list[QPushButton] = []
        self._done = False  # whether it reports a success
        self._lasts = False  # whether it is as true when a run begins
        close = QToolButton()
        close.setText("✕")
        close.setAutoRaise(True)
        close.setToolTip(tr("Close this message"))
        close.setAccessibleName(tr("Close this message"))
        close.clicked.connect(self.clear)
        self._row = row = QHBoxLayout(self)
        row.setContentsMargins(10, 6, 6, 6)
        row.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._text, 1)
        row.addWidget(close, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    @property
    def text(self) -> str:
        """The message; empty while hidden."""
        return self._text.text()

    @property
    def taken(self) -> bool:
        """Whether a message must be read first; a report of success may be replaced."""
        return bool(self.text) and not self._done

    def warn(self, text: str, *offers: Offer) -> None:
        self._show("warning", QStyle.StandardPixmap.SP_MessageBoxWarning, text, offers)

    def note(self, text: str, *offers: Offer, lasts: bool = False) -> None:
        """Show a note, with buttons; ``lasts`` keeps it when a run begins."""
        self._show("note", QStyle.StandardPixmap.SP_MessageBoxInformation, text, offers)
        self._lasts = lasts

    def done(self, text: str) -> None:
        """Show that something is finished, such as a written file."""
        self.note(text, lasts=True)
        self._done = True

    def amend(self, beginning: str, text: str) -> None:
        """Replace a message that has this beginning, as for progress."""
        if beginning and self.text.startswith(beginning):
            self._text.setText(text)
            self.setAccessibleName(text)

    def withdraw(self, text: str) -> None:
        if text and text == self.text:
            self.clear()

    def make_way(self) -> None:
        """Remove messages about the lens before a run."""
        if not self._lasts:
            self.clear()

    def clear(self) -> None:
        self._set_buttons(())
        self._text.clear()
        self.hide()

    def _show(
        self, kind: str, icon: QStyle.StandardPixmap, text: str, offers: Sequence[Offer]
    ) -> None:
        self._done = self._lasts = False
        self._set_buttons(offers)
        self.setObjectName(kind)
        theme.restyle(self)
        side = self.style().pixelMetric(QStyle.PixelMetric.PM_SmallIconSize)
        self._icon.setPixmap(self.style().standardIcon(icon).pixmap(side, side))
        self._text.setText(text)
        self.setAccessibleName(text)
        self.show()
        self.raise_()
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.Alert))
        self.message.emit(text)

    def _set_buttons(self, offers: Sequence[Offer]) -> None:
        for button in self.buttons:
            button.hide()
            button.deleteLater()  # its own click may have led here
        self.buttons = []
        for words, act in offers:
            button = QPushButton(words)
            button.clicked.connect(lambda _=False, act=act: act())
            self._row.insertWidget(self._row.count() - 1, button, 0, Qt.AlignmentFlag.AlignTop)
            self.buttons.append(button)


def question(
    window: QWidget,
    icon: QMessageBox.Icon,
    texts: tuple[str, str, str],
    answers: Sequence[tuple[str, QMessageBox.ButtonRole, Value]],
) -> Value:
    """Ask by title, text and details; return the value of the pressed button.

    The button that accepts is the default; Escape presses the last one.
    """
    box = QMessageBox(window)
    box.setIcon(icon)
    box.setTextFormat(Qt.TextFormat.PlainText)  # names of files may look like markup
    box.setWindowTitle(texts[0])
    box.setText(texts[1])
    box.setInformativeText(texts[2])
    buttons = [box.addButton(text, role) for text, role, _ in answers]
    for button, (_, role, _) in zip(buttons, answers, strict=True):
        if role is QMessageBox.ButtonRole.AcceptRole:
            box.setDefaultButton(button)
    box.setEscapeButton(buttons[-1])
    box.exec()
    pressed = box.clickedButton()
    box.deleteLater()
    number = buttons.index(pressed) if pressed in buttons else -1
    return answers[number][2]


_LINES = 2000  # of which the oldest are dropped


class LogView(QPlainTextEdit):
    """Read-only text that stays at its end unless the user scrolls."""

    def __init__(self) -> None:
        super().__init__()
        self.setReadOnly(True)
        self.setUndoRedoEnabled(False)
        self.setMaximumBlockCount(_LINES)
        self.setFrameShape(QPlainTextEdit.Shape.NoFrame)
        self.setPlaceholderText(tr("Messages of runs, checks and exports appear here."))
        self.setAccessibleName(tr("Log"))
        self._at_end = True
        bar = self.verticalScrollBar()
        bar.rangeChanged.connect(lambda _, end: bar.setValue(end) if self._at_end else None)
        bar.valueChanged.connect(self._note_place)

    def resizeEvent(self, event: QResizeEvent) -> None:
        at_end = self._at_end
        super().resizeEvent(event)
        if at_end:
            bar = self.verticalScrollBar()
            bar.setValue(bar.maximum())
            self._at_end = True

    def add(self, sentence: str) -> None:
        self.appendPlainText(f"{datetime.now():%H:%M:%S}  {' '.join(sentence.split())}")

    def add_details(self, text: str) -> None:
        """Write lines below the others, as they are."""
        self.appendPlainText(text.rstrip())

    def _note_place(self, value: int) -> None:
        self._at_end = value == self.verticalScrollBar().maximum()
