"""Rows of a form: editors for one thing in the scene, its unit, and why an edit was refused.

A row shows what the scene holds and tells of what a person asks for; it never judges. Text that
was refused stays as typed until it is corrected, or taken back with Escape.
"""

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QLabel,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.panels.editors import Chooser, NumberEditor, Refusal, TextEditor
from ui.panels.edits import LENGTH as LENGTH  # to be had from here, too
from ui.panels.edits import Edit, value_at
from ui.widgets import theme

Changes = dict[str, object]


class Row(QWidget):
    """Editors side by side, their unit behind them and a refusal below.

    Parameters
    ----------
    path : str
        Field of the scene that the row shows.
    label : str
        What stands before the row.
    tip : str
        What the value is and why one would change it.
    unit : str
        Stands behind the editors; `LENGTH` for the scene's unit.
    present : callable, optional
        Whether a scene (as plain data) has such a value; by default whether the path exists.
    """

    edited = Signal(object)
    reverted = Signal(object)

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        unit: str = "",
        present: Callable[[dict[str, Any]], bool] | None = None,
    ) -> None:
        super().__init__()
        self.path = path
        self.label = QLabel(label)
        self.name = label  # told apart from those of other panels by the panel
        self._unit_kind = unit
        self._present = present
        self._unit = QLabel()
        self._unit.setVisible(bool(unit))
        self._refusal = Refusal()
        self._editors = QHBoxLayout()
        self._editors.addWidget(self._unit)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addLayout(self._editors)
        column.addWidget(self._refusal)
        for widget in (self.label, self):
            widget.setToolTip(f"<p>{tip}</p>")  # rich text, because only that wraps

    @property
    def is_length(self) -> bool:
        """Whether its numbers are in the scene's unit."""
        return self._unit_kind == LENGTH

    def present(self, data: dict[str, Any]) -> bool:
        """Whether a scene, as plain data, has this field."""
        if self._present is not None:
            return self._present(data)
        return value_at(data, self.path) is not None

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show what the scene holds, except where a refused edit still stands."""
        if self._unit_kind:
            self.set_unit(data["unit"] if self._unit_kind == LENGTH else self._unit_kind)

    def set_unit(self, text: str) -> None:
        """What stands behind the editors."""
        self._unit.setText(text)
        self._unit.setVisible(bool(text))

    def commit(self) -> None:
        """Tell of text that is typed but not yet entered."""
        for editor in self.findChildren(TextEditor):
            editor.commit()

    def forget(self) -> None:
        """Drop what is typed: a scene without this field is shown."""
        for editor in self.findChildren(TextEditor):
            editor.show_value("")

    def concerns(self, path: str) -> bool:
        """Whether a refusal of ``path`` belongs to this row."""
        return path == self.path or path.startswith((self.path + "[", self.path + "."))

    def refuse(self, reason: str) -> None:
        """Show why the edit is not possible; an empty reason clears it."""
        if reason or self.refusal:
            self._refusal.say(f"\N{WARNING SIGN} {reason}" if reason else "")
            self.setProperty("refused", bool(reason))
            theme.restyle(self)

    @property
    def refusal(self) -> str:
        """The text shown below the editors."""
        return self._refusal.text()

    def _add(self, widget: QWidget, stretch: int = 1) -> None:
        self._editors.insertWidget(self._editors.count() - 1, widget, stretch)
        if not widget.accessibleName():
            widget.setAccessibleName(self.label.text())
        if self.focusProxy() is None:
            self.setFocusProxy(widget)
            self.label.setBuddy(widget)

    def _tell(self, path: str, changes: Changes) -> None:
        self.edited.emit(Edit(path, f"change of {self.name.lower()}", changes))


class NumberRow(Row):
    """One number, or some with a word between them.

    Parameters
    ----------
    between : str
        What stands between numbers; without it there is one.
    count : int
        How many numbers there are with something between them.
    whole : bool
        Whether only whole numbers make sense.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        unit: str = "",
        *,
        between: str = "",
        count: int = 2,
        whole: bool = False,
        present: Callable[[dict[str, Any]], bool] | None = None,
    ) -> None:
        super().__init__(path, label, tip, unit, present)
        paths = [f"{path}[{k}]" for k in range(count)] if between else [path]
        self.editors = {p: NumberEditor(unit, whole, narrow=len(paths) > 2) for p in paths}
        for number, (place, editor) in enumerate(self.editors.items()):
            if number:
                self._add(QLabel(between), 0)
            if between:
                editor.setAccessibleName(f"{label}, {number + 1} of {count}")
            self._add(editor)
            editor.committed.connect(lambda text, p=place: self._commit(p, text))
            editor.reverted.connect(lambda p=place: self.reverted.emit(p))

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's numbers, short but exact."""
        super().show_scene(data, pending)
        for path, editor in self.editors.items():
            if path not in pending:
                editor.show_value(format(value_at(data, path), ".12g"))

    def _commit(self, path: str, text: str) -> None:
        self._tell(path, {path: self.editors[path].typed(text)})


class TextRow(Row):
    """One line of text, with a button behind it that helps to find the text.

    Parameters
    ----------
    button_tip : str
        What the button does.
    """

    asked = Signal()

    def __init__(self, path: str, label: str, tip: str, button_tip: str) -> None:
        super().__init__(path, label, tip)
        self.editor = TextEditor()
        button = QToolButton()
        button.setText("…")
        button.setToolTip(button_tip)
        button.setAccessibleName(button_tip)
        button.clicked.connect(self.asked)
        self._add(self.editor)
        self._add(button, 0)
        self.editor.committed.connect(lambda text: self._tell(path, {path: text}))
        self.editor.reverted.connect(lambda: self.reverted.emit(path))

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's text, its end first, which in a path says most."""
        super().show_scene(data, pending)
        if self.path not in pending:
            self.editor.show_value(value_at(data, self.path))
            self.editor.end(False)


class ChoiceRow(Row):
    """One of a few, entered at once.

    Parameters
    ----------
    choices : sequence of (str, str)
        What the scene calls it and what a person reads.
    read : callable, optional
        The scene's choice; by default the value at the path.
    changes : callable, optional
        What choosing brings with it, or None to leave all as it is; by default the path's value.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        choices: Sequence[tuple[str, str]],
        read: Callable[[dict[str, Any]], str] | None = None,
        changes: Callable[[str], Changes | None] | None = None,
    ) -> None:
        super().__init__(path, label, tip)
        self._read = read or (lambda data: str(value_at(data, path)))
        self._changes = changes or (lambda choice: {path: choice})
        self.chooser = Chooser()
        for value, text in choices:
            self.chooser.addItem(text, value)
        self._add(self.chooser)
        self.chooser.activated.connect(self._choose)

    def present(self, data: dict[str, Any]) -> bool:
        """Whether a scene, as plain data, has this choice."""
        return self._read(data) != "None"

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's choice."""
        super().show_scene(data, pending)
        if self.path not in pending:
            self.chooser.setCurrentIndex(self.chooser.findData(self._read(data)))

    def _choose(self, index: int) -> None:
        changes = self._changes(self.chooser.itemData(index))
        if changes is None:
            self.reverted.emit(self.path)
        else:
            self._tell(self.path, changes)


class CheckRow(Row):
    """Yes or no."""

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        present: Callable[[dict[str, Any]], bool] | None = None,
    ) -> None:
        super().__init__(path, label, tip, present=present)
        self.box = QCheckBox()
        self._add(self.box)
        self.box.clicked.connect(lambda checked: self._tell(path, {path: checked}))

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's answer."""
        super().show_scene(data, pending)
        if self.path not in pending:
            self.box.setChecked(value_at(data, self.path))
