"""Panels: rows under a heading that folds them away, and lists of parts."""

import re
from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import replace
from functools import partial
from itertools import count
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QFormLayout,
    QHBoxLayout,
    QListWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.panels.editors import Remark
from ui.panels.edits import Edit
from ui.panels.fields import Row
from ui.panels.rows import Make, Rows, at_least
from ui.widgets.controls import STRETCH, filled, named, tool_button
from ui.widgets.folds import Fold, Section, form_in
from ui.words import in_sentence, tr
from workbench.files.session import Session
from workbench.levels import Level
from workbench.scene import FieldDescription, Kinds, Part, Scene
from workbench.scene.paths import value_at


class Panel(Fold):
    """Rows under a heading; independent of other panels and of the document.

    Rows of `Level.LIMITS` and `Level.EXPERT` stand in `deeper`, which has a place in the form.
    """

    edited = Signal(object)
    reverted = Signal(object)
    asked = Signal(str)
    session: Session  # from `prepare` on, before anything can be edited

    def __init__(self, title: str, rows: Sequence[Row], level: Level = Level.JOB) -> None:
        super().__init__(title)
        self.rows: list[Row] = []
        self._level = level
        self._form = form_in(self.body)
        self.deeper = {each: Section(title) for each in (Level.LIMITS, Level.EXPERT)}
        for section in self.deeper.values():
            section.setParent(self)
            section.hide()
        self._add_rows(rows, title)

    def prepare(self, session: Session) -> None:
        """Make the rows that a session needs."""
        self.session = session

    def show_rows(self, shown: Set[Row]) -> None:
        """Show some rows, and no heading without any."""
        for row in self.rows:
            form = self._form_of(row)
            if form.isRowVisible(row) != (row in shown):
                form.setRowVisible(row, row in shown)
        levels = {row.level for row in self.rows if row in shown}
        self.setVisible(Level.JOB in levels)
        for level, section in self.deeper.items():
            section.setVisible(level in levels)

    def select(self, path: str) -> None:
        """Show the rows of the part at a path, where the panel has several parts."""

    def _form_of(self, row: Row) -> QFormLayout:
        return self.deeper[row.level].form if row.level in self.deeper else self._form

    def _add_rows(self, rows: Sequence[Row], name: str) -> None:
        self._name_rows(rows, name)
        for row in at_least(self._level, list(rows)):
            if isinstance(row, ListRow):
                self._form_of(row).addRow(row)
            else:
                self._form_of(row).addRow(row.label, row)
            row.leave_undo()
            row.edited.connect(self.edited)
            row.reverted.connect(self.reverted)
            row.asked.connect(self.asked)
            self.rows.append(row)

    def _name_rows(self, rows: Sequence[Row], name: str) -> None:
        for row in rows:
            row.name = name
            for part in filter(None, (row.of, row.label.text())):
                row.name = tr("{panel} {field}").format(panel=row.name, field=in_sentence(part))

    def _remove_rows(self, rows: Sequence[Row]) -> None:
        for row in rows:
            row.blockSignals(True)  # an editor that loses the focus enters its text
            self.rows.remove(row)
            self._form_of(row).takeRow(row)
            for widget in (row.label, row):
                widget.hide()
                widget.deleteLater()


class PartPanel(Panel):
    """Rows generated from the fields of a part; ``own`` makes those of some fields."""

    def __init__(
        self, field: FieldDescription, path: str = "", own: Mapping[str, Make] | None = None
    ) -> None:
        self.path = path or field.name
        rows, kinds = Rows(lambda: self.session.scene, own), field.mark(Kinds)
        super().__init__(
            tr(field.title),
            rows.of_kinds(field, self.path, kinds.title)
            if kinds
            else rows.of_part(field.parts[0], self.path),
            field.level,
        )


_MOST_SEEN = 6  # parts; more are scrolled to

AnyPart = TypeVar("AnyPart", bound=Part)


class ListedPanel(Panel, Generic[AnyPart]):
    """A list of parts, with buttons; below it the rows of the selected part.

    ``field`` is that of the parts at ``path``; ``adding`` has the buttons that add parts, with
    their tips.
    """

    _CALLED = ""  # a part, in the texts of steps
    _NAMED = ""  # a part by its number
    _NONE = ""  # in place of the list
    _KIND = ""  # label of the row of a part's kind
    _OWN: Mapping[str, Make] = {}  # rows of some fields

    def __init__(
        self, field: FieldDescription, adding: Mapping[str, str], path: str = "", listed: str = ""
    ) -> None:
        self._field, self.path = field, path or field.name
        self._parts: tuple[AnyPart, ...] = ()
        self._bound = -1  # the part whose rows are there
        self._called = ""  # in their names
        self._list, self._rest = QListWidget(), Remark()
        self._list.setTextElideMode(Qt.TextElideMode.ElideRight)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        adders = [
            _button(text, tip, partial(self._append, which))
            for which, (text, tip) in enumerate(adding.items())
        ]
        self._of_chosen = [
            _button(tr("Duplicate"), tr("Add a copy of the selected one"), self._duplicate),
            _button(tr("Remove"), tr("Remove the selected one"), self._drop),
            _button(tr("Up"), tr("Move the selected one up"), partial(self._move, -1)),
            _button(tr("Down"), tr("Move the selected one down"), partial(self._move, 1)),
        ]
        self._fewest = 1 if len(adders) > 1 else 0  # parts but one, among which to choose
        content = QWidget()
        column = filled(QVBoxLayout(content), self._list, self._rest, margins=0, spacing=4)
        for line in (adders, self._of_chosen):
            column.addLayout(filled(QHBoxLayout(), *line, STRETCH, spacing=4))
        row = ListRow(replace(field, title=listed or field.title), self.path, content)
        row.label.setBuddy(named(self._list, row.label.text()))
        super().__init__(tr(field.title), [row], field.level)
        self._list.currentRowChanged.connect(self._choose)

    @property
    def current(self) -> int:
        """Index of the selected part; −1 for none."""
        return self._list.currentRow()

    def prepare(self, session: Session) -> None:
        super().prepare(session)
        parts: tuple[AnyPart, ...] = value_at(session.scene, self.path)
        self._show_parts(parts, self.remark(session.scene) if parts else tr(self._NONE))
        self.note(f"{len(parts)}" if parts else "")
        self._bind()

    def select(self, path: str) -> None:
        if number := re.match(rf"{self.path}\[(\d+)\]", path):
            self._list.setCurrentRow(int(number[1]))

    def remark(self, scene: Scene) -> str:
        """Return a sentence below the list of some parts."""
        return ""

    @abstractmethod
    def new(self, which: int) -> AnyPart | None:
        """Return the part that an add button appends; None if the user asks for none."""

    @abstractmethod
    def summary(self, part: AnyPart) -> str:
        """Return a description of a part in one line."""

    def name_of(self, number: int) -> str:
        """Return the title of a part."""
        return tr(self._NAMED).format(number=number + 1)

    def rows_of(self, number: int) -> list[Row]:
        """Return the rows of a part; those of each kind, if parts are of several."""
        rows = Rows(lambda: self.session.scene, self._OWN)
        return rows.of_kinds(self._field, f"{self.path}[{number}]", tr(self._KIND))

    def copy(self, part: AnyPart) -> AnyPart:
        return part

    def place_of_copy(self) -> int:
        return self.current + 1

    def exchanged(self, first: AnyPart, second: AnyPart) -> tuple[AnyPart, AnyPart]:
        return second, first

    def chosen_among(self, before: tuple[AnyPart, ...], parts: tuple[AnyPart, ...]) -> int:
        """Return the part to select when the parts have changed."""
        return min(max(self.current, 0), len(parts) - 1)

    def _choose(self) -> None:
        self._bind()
        self.reverted.emit(self.path)

    def _bind(self) -> None:
        number = self.current
        name = self.name_of(number) if number >= 0 else ""
        if number != self._bound:
            self._remove_rows(list(self.rows[1:]))
            self._bound = number
            if number >= 0:
                self._add_rows(self.rows_of(number), name)
        elif name != self._called:
            self._name_rows(self.rows[1:], name)
        self._called = name
        for section in self.deeper.values():
            section.heading.setText(f"{self.title} · {name}" if name else self.title)

    def _show_parts(self, parts: tuple[AnyPart, ...], remark: str) -> None:
        if parts != self._parts:
            with QSignalBlocker(self._list):
                chosen = self.chosen_among(self._parts, parts)
                self._parts = parts
                self._list.clear()
                for number, part in enumerate(parts, start=1):
                    self._list.addItem(f"{number}.  {self.summary(part)}")
                    self._list.item(number - 1).setToolTip(self.summary(part))
                self._list.setCurrentRow(chosen)
        if parts:
            rows = min(len(parts), _MOST_SEEN)
            frame = 2 * self._list.frameWidth()
            self._list.setFixedHeight(rows * self._list.sizeHintForRow(0) + frame)
        self._rest.show_text(remark)
        self._list.setVisible(bool(parts))
        last = len(parts) - 1
        for button in self._of_chosen:
            button.setVisible(last >= self._fewest)
        *_, up, down = self._of_chosen
        up.setEnabled(self.current > 0)
        down.setEnabled(0 <= self.current < last)

    def _append(self, which: int) -> None:
        part = self.new(which)
        if part is not None:
            self._put([*self._parts, part], tr("new {part}"), len(self._parts))

    def _duplicate(self) -> None:
        place, parts = self.place_of_copy(), list(self._parts)
        parts.insert(place, self.copy(parts[self.current]))
        self._put(parts, tr("copy of {part} {number}"), place)

    def _drop(self) -> None:
        rest = [part for number, part in enumerate(self._parts) if number != self.current]
        self._put(rest, tr("removal of {part} {number}"), self.current)

    def _move(self, step: int) -> None:
        current, parts = self.current, list(self._parts)
        first = min(current, current + step)
        parts[first : first + 2] = self.exchanged(*parts[first : first + 2])
        self._put(parts, tr("move of {part} {number}"), current + step)

    def _put(self, parts: list[AnyPart], text: str, chosen: int) -> None:
        data = _data(parts)
        text = text.format(part=tr(self._CALLED), number=self.current + 1)
        self.edited.emit(Edit(self.path, text, {self.path: data}, alone=True))
        if _data(self._parts) == data:  # not refused
            self._list.setCurrentRow(min(chosen, len(parts) - 1))


class ListRow(Row):
    """The row of a list of parts, over the whole width."""

    def __init__(self, field: FieldDescription, path: str, content: QWidget) -> None:
        super().__init__(field, path)
        self.label.setParent(self)
        self.label.hide()
        self._add(content)

    def concerns(self, path: str) -> bool:
        """Whether a refusal concerns the whole list."""
        return path == self.path


def another_name(name: str, taken: Iterable[str], between: str) -> str:
    """Return an unused name: the given one with the next free number."""
    stem = re.sub(rf"{between}\d+$", "", name)
    names = set(taken)
    return next(new for k in count(2) if (new := f"{stem}{between}{k}") not in names)


def _data(parts: Iterable[Part]) -> list[dict[str, Any]]:
    return [part.model_dump(mode="json", exclude_none=True) for part in parts]


def _button(text: str, tip: str, act: Callable[[], None]) -> QToolButton:
    button = tool_button(text, tip, act)
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # typed text is entered before it acts
    return button
