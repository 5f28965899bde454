"""Messages over the image, questions, and the log of the window."""

from collections.abc import Callable, Sequence
from datetime import datetime
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QPropertyAnimation, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QGraphicsOpacityEffect,
    QHBoxLayout,
    QMessageBox,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ui.widgets.controls import STRETCH, filled, tool_button
from ui.widgets.labels import WrappedLabel
from ui.widgets.marks import Mark, Sign
from ui.words import tr

Value = TypeVar("Value")

Offer = tuple[str, Callable[[], object]]
"""Text and action of a button beside a message."""


_MOST = 3  # messages at once
_WIDTH, _GAP = 380, 8  # pixels
_READ_MS, _LETTER_MS = 4000, 60  # to notice a message, and to read each of its letters
_FADE_MS = 400


_MARKS: dict[str, Sign] = {"warning": "attention", "note": "note", "done": "good"}


class Notice(QFrame):
    """A message with buttons; one that fades waits while the pointer or the focus is on it."""

    closed = Signal()

    def __init__(self, kind: str, text: str, offers: Sequence[Offer], fades: bool) -> None:
        super().__init__()
        self.setObjectName(kind)  # for the style sheet
        self.setAccessibleName(text)
        self.kind, self.text, self.fades = kind, text, fades
        mark = Mark(_MARKS[kind])
        words = WrappedLabel(text, textFormat=Qt.TextFormat.PlainText)
        words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        name = tr("Close this message")
        close = tool_button("✕", name, self.closed.emit, name)
        close.setAutoRaise(True)
        self.buttons = [QPushButton(words) for words, _ in offers]
        for button, (_, act) in zip(self.buttons, offers, strict=True):
            button.clicked.connect(self.closed)
            button.clicked.connect(lambda _=False, act=act: act())
        top = Qt.AlignmentFlag.AlignTop
        row = filled(QHBoxLayout(), mark, (words, 1), close, spacing=8)
        row.setAlignment(mark, top)
        row.setAlignment(close, top)
        box = filled(QVBoxLayout(self), row, margins=(10, 8, 8, 8), spacing=6)
        if offers:
            box.addLayout(filled(QHBoxLayout(), STRETCH, *self.buttons, spacing=6))
        self._read = QTimer(self, singleShot=True, interval=_READ_MS + _LETTER_MS * len(text))
        self._read.timeout.connect(self._fade)
        if fades:
            self._read.start()

    def _fade(self) -> None:
        if self.underMouse() or self.isAncestorOf(self.window().focusWidget()):
            self._read.start()
            return
        effect = QGraphicsOpacityEffect(self)
        self.setGraphicsEffect(effect)
        fading = QPropertyAnimation(effect, b"opacity", self)
        fading.setDuration(_FADE_MS)
        fading.setStartValue(1.0)
        fading.setEndValue(0.0)
        fading.finished.connect(self.closed)
        fading.start()


class Messages(QWidget):
    """Failures and notes as a few notices, the latest below, without blocking the user.

    Reports of success, and notes without a question, fade; others stay until they are closed.
    """

    message = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.notices: list[Notice] = []
        self._column = filled(QVBoxLayout(self), margins=0, spacing=_GAP)
        self.setMaximumWidth(_WIDTH)
        self.hide()

    def sizeHint(self) -> QSize:
        return QSize(_WIDTH, self.heightForWidth(_WIDTH))

    @property
    def text(self) -> str:
        """The latest message; empty if there is none."""
        return self.notices[-1].text if self.notices else ""

    @property
    def buttons(self) -> list[QPushButton]:
        """Buttons of the latest message."""
        return self.notices[-1].buttons if self.notices else []

    def warn(self, text: str, *offers: Offer) -> None:
        self._show("warning", text, offers)

    def note(self, text: str, *offers: Offer) -> None:
        self._show("note", text, offers, fades=not offers)

    def done(self, text: str, *offers: Offer) -> None:
        """Report what is finished, such as a written file."""
        self._show("done", text, offers, fades=True)

    def withdraw(self, text: str) -> None:
        for notice in [notice for notice in self.notices if notice.text == text]:
            self._remove(notice)

    def make_way(self) -> None:
        """Remove messages about the lens before a run."""
        for notice in [notice for notice in self.notices if notice.kind != "done"]:
            self._remove(notice)

    def clear(self) -> None:
        for notice in list(self.notices):
            self._remove(notice)

    def _show(self, kind: str, text: str, offers: Sequence[Offer], fades: bool = False) -> None:
        self.withdraw(text)
        if len(self.notices) >= _MOST:  # notes go first, warnings last
            self._remove(min(self.notices, key=lambda each: (not each.fades, each.kind)))
        notice = Notice(kind, text, offers, fades)
        notice.closed.connect(partial(self._remove, notice))
        self.notices.append(notice)
        self._column.addWidget(notice)
        self.show()
        self.raise_()
        QAccessible.updateAccessibility(QAccessibleEvent(notice, QAccessible.Event.Alert))
        self.message.emit(text)

    def _remove(self, notice: Notice) -> None:
        if notice in self.notices:
            self.notices.remove(notice)
            notice.hide()
            notice.deleteLater()  # its own click may have led here
            self.setVisible(bool(self.notices))


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
