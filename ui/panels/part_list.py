"""Parts of the scene as a list, in their order, and what can be done with them."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QListWidget, QToolButton, QVBoxLayout, QWidget

from ui.panels.editors import Wrapped
from ui.panels.edits import Edit
from ui.panels.fields import Row
from ui.words import tr
from workbench.scene import Part

_MOST_SEEN = 6  # parts; more are scrolled to

AnyPart = TypeVar("AnyPart", bound=Part)


class PartListRow(Row, Generic[AnyPart]):
    """The parts one below the other, with buttons to add, remove and move them.

    Parameters
    ----------
    path : str
        Of the field that holds them.
    label, tip : str
        As for `Row`.
    called : str
        What undo steps call one of them.
    name : str
        What the list is called where it is read aloud.
    tips : sequence of str
        Of the buttons that add, remove, and move up and down.
    """

    chosen = Signal()

    def __init__(
        self, path: str, label: str, tip: str, called: str, name: str, tips: Sequence[str]
    ) -> None:
        super().__init__(path, label, tip)
        self._called = called
        self._parts: tuple[AnyPart, ...] = ()
        self._list = QListWidget()
        self._list.setAccessibleName(name)
        self._list.setTextElideMode(Qt.TextElideMode.ElideRight)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.currentRowChanged.connect(lambda _: self.chosen.emit())
        self._rest = Wrapped()
        self._buttons = [
            _button(text, tip)
            for text, tip in zip((tr("Add"), tr("Remove"), tr("Up"), tr("Down")), tips, strict=True)
        ]
        actions = (self._append, self._drop, lambda: self._move(-1), lambda: self._move(1))
        buttons = QHBoxLayout()
        buttons.setSpacing(2)
        for button, action in zip(self._buttons, actions, strict=True):
            button.clicked.connect(action)
            buttons.addWidget(button)
        buttons.addStretch()
        content = QWidget()
        column = QVBoxLayout(content)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        column.addWidget(self._list)
        column.addWidget(self._rest)
        column.addLayout(buttons)
        self._add(content)
        self.setFocusProxy(self._list)

    @property
    def current(self) -> int:
        """Number of the chosen part; −1 where there is none."""
        return self._list.currentRow()

    def concerns(self, path: str) -> bool:
        """Whether a refusal is about the parts as a whole; one part has rows of its own."""
        return path == self.path

    def _is_there(self, scene: Any) -> bool:
        return True

    def show_parts(self, parts: tuple[AnyPart, ...], remark: str) -> None:
        """Show the parts, and below them a remark."""
        if parts != self._parts:
            self._parts = parts
            with QSignalBlocker(self._list):
                chosen = min(max(self.current, 0), len(parts) - 1)
                self._list.clear()
                for number, part in enumerate(parts, start=1):
                    self._list.addItem(f"{number}.  {self._summary(part)}")
                    self._list.item(number - 1).setToolTip(self._summary(part))
                self._list.setCurrentRow(chosen)
        if parts:
            rows = min(len(parts), _MOST_SEEN)
            frame = 2 * self._list.frameWidth()
            self._list.setFixedHeight(rows * self._list.sizeHintForRow(0) + frame)
        self._rest.say(remark)
        self._list.setVisible(bool(parts))
        self._enable()

    @abstractmethod
    def _new(self) -> AnyPart:
        """What is added behind the others."""

    @abstractmethod
    def _summary(self, part: AnyPart) -> str:
        """What makes a part different, in one line."""

    def _enable(self) -> None:
        current, count = self.current, len(self._parts)
        _, remove, up, down = self._buttons
        remove.setEnabled(count > 0)
        up.setEnabled(current > 0)
        down.setEnabled(0 <= current < count - 1)

    def _append(self) -> None:
        self._put(
            [*self._parts, self._new()],
            tr("new {part}").format(part=self._called),
            len(self._parts),
        )

    def _drop(self) -> None:
        current = self.current
        rest = [part for number, part in enumerate(self._parts) if number != current]
        self._put(
            rest,
            tr("removal of {part} {number}").format(part=self._called, number=current + 1),
            current,
        )

    def _move(self, step: int) -> None:
        current, parts = self.current, list(self._parts)
        parts.insert(current + step, parts.pop(current))
        self._put(
            parts,
            tr("move of {part} {number}").format(part=self._called, number=current + 1),
            current + step,
        )

    def _put(self, parts: list[AnyPart], text: str, chosen: int) -> None:
        data = [part.model_dump(mode="json", exclude_none=True) for part in parts]
        self.edited.emit(Edit(self.path, text, {self.path: data}, alone=True))
        if self._parts == tuple(parts):  # not refused
            self._list.setCurrentRow(min(chosen, len(parts) - 1))


def _button(text: str, tip: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    button.setToolTip(tip)
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # typed text is entered before it acts
    return button
