"""Entries of a form: edits that are refused wait, and each reason stands beside its row."""

from collections.abc import Callable, Iterable, Sequence
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QWidget

from ui.panels.edits import Edit, put
from ui.panels.fields import Row
from ui.words import tr
from workbench.errors import Refused
from workbench.messages import Message


@dataclass(frozen=True)
class Waiting:
    """An edit that was refused, and why."""

    edit: Edit
    refused: Refused


Attempt = Callable[[list[Edit]], None]
"""Makes edits, or raises `Refused`."""


class Entries:
    """Makes edits, each together with those that were refused before."""

    def __init__(self, attempt: Attempt) -> None:
        self._attempt = attempt
        self.waiting: dict[str, Waiting] = {}

    def make(self, edit: Edit) -> Refused | None:
        """Make an edit with refused ones, which may be possible now, or alone; or keep it."""
        self.waiting.pop(edit.path, None)
        others = [waiting.edit for waiting in self.waiting.values()]
        refused = self._refusal([*others, edit])
        if refused is None:
            self.waiting.clear()
            return None
        refused = self._refusal([edit]) if others else refused
        if refused is not None and edit.waits and not edit.drag:
            self.waiting[edit.path] = Waiting(edit, refused)
        return refused

    def show(self, whole: Any, rows: Iterable[Row], present: Sequence[Row]) -> dict[Row, str]:
        """Show the values of a whole, and refused entries as typed with their reasons."""
        reasons, shown = self._reasons(present), set(present)
        for row in rows:
            if row in shown:
                row.show_scene(whole, self.waiting.keys())
            else:
                row.forget()  # before it is hidden, which enters what is typed
            row.refuse(reasons.get(row, ""))
        return reasons

    def _reasons(self, present: Sequence[Row]) -> dict[Row, str]:
        """Return why entries are refused, for the rows of edits and those that are to blame."""
        reasons: dict[Row, str] = {}
        for path, waiting in self.waiting.items():
            refused, edited = row_of(waiting.refused.path, present), row_of(path, present)
            reason = waiting.refused.reason
            if refused is not None and isinstance(reason, Message):
                reason = reason.times(refused.field.times)  # as the row shows its numbers
            reason = tr(reason)
            if refused is not None:
                reasons[refused] = reason
            if edited is not None and edited is not refused:
                where = refused.name if refused is not None else waiting.refused.path
                reasons[edited] = f"{where}: {reason}"
        return reasons

    def _refusal(self, edits: list[Edit]) -> Refused | None:
        try:
            self._attempt(edits)
        except Refused as refused:
            return refused
        return None


def row_of(path: str, rows: Sequence[Row]) -> Row | None:
    """Return the last row of a path, which holds the value."""
    return next((row for row in reversed(rows) if row.concerns(path)), None)


_GAP = 5  # pixels between rows


class RowForm(QWidget):
    """Rows that edit one whole, such as a job or plain data."""

    changed = Signal()
    asked = Signal(str)  # for a file, by the path of the row

    def __init__(self, rows: Iterable[Row], whole: Callable[[], Any], attempt: Attempt) -> None:
        super().__init__()
        self.rows, self._whole = [*rows], whole
        self._entries = Entries(attempt)
        for row in self.rows:
            row.edited.connect(self.edit)
            row.reverted.connect(self._revert)
            row.asked.connect(self.asked)

    def in_form(self, rows: Sequence[Row]) -> QFormLayout:
        """Return a layout with some of the rows below each other."""
        form = QFormLayout()
        form.setVerticalSpacing(_GAP)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for row in rows:
            form.addRow(row.label, row)
        return form

    @property
    def refused(self) -> bool:
        return bool(self._entries.waiting)

    def row(self, path: str) -> Row:
        return next(row for row in self.rows if row.concerns(path))

    def commit(self) -> None:
        for row in self.rows:
            row.commit()

    def edit(self, edit: Edit) -> None:
        """Make an edit, or keep it waiting if it is refused."""
        self._entries.make(edit)
        self._show_change()

    def forget(self) -> None:
        self._entries.waiting.clear()

    def show_rows(self) -> None:
        """Show the whole, and refused entries as typed."""
        whole = self._whole()
        present = [row for row in self.rows if row.present(whole)]
        self._entries.show(whole, self.rows, present)
        for row in self.rows:
            for part in (row, row.label):
                part.setVisible(row in present)

    def _show_change(self) -> None:
        self.show_rows()
        self.changed.emit()

    def _revert(self, path: str) -> None:
        self._entries.waiting.pop(path, None)
        self._show_change()


class DataForm(RowForm):
    """Rows that edit plain data with a unit; ``check`` raises `Refused` where they are wrong."""

    def __init__(
        self, rows: Iterable[Row], data: dict[str, Any], check: Callable[[dict[str, Any]], object]
    ) -> None:
        super().__init__(rows, lambda: self.data, self._enter)
        self.data, self._check = data, check

    def _enter(self, edits: list[Edit]) -> None:
        data = deepcopy(self.data)
        for edit in edits:
            put(edit, data)
        self._check(data)
        self.data = data
