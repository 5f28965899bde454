"""Rows of text: one line, or numbers written as one."""

from collections.abc import Set
from typing import Any

from ui.panels.editors import TextEditor
from ui.panels.edits import Typed
from ui.panels.fields import Row
from ui.widgets.controls import tool_button
from workbench.scene import FieldDescription
from workbench.scene.paths import value_at


class TextRow(Row):
    """One line of text, with an optional button that asks for a file."""

    def __init__(self, field: FieldDescription, path: str, button_tip: str = "") -> None:
        super().__init__(field, path)
        self.editor = TextEditor()
        self._add(self.editor)
        if button_tip:
            ask = tool_button("…", button_tip, lambda: self.asked.emit(path), button_tip)
            self._add(ask, 0)
        self.editor.committed.connect(
            lambda text: self._emit_edit(path, {path: self.value_of(text)})
        )
        self.editor.reverted.connect(lambda: self.reverted.emit(path))

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        if self.path not in pending:
            self.editor.show_value(self.text_of(value_at(scene, self.path)))
            self.editor.end(False)

    def text_of(self, value: Any) -> str:
        text: str = value or ""
        return text

    def value_of(self, text: str) -> object:
        return None if self.field.optional and not text.strip() else text


class NumbersRow(TextRow):
    """Numbers in one line, separated by semicolons."""

    def text_of(self, value: Any) -> str:
        return "; ".join(format(number, ".12g") for number in value)

    def value_of(self, text: str) -> object:
        return [Typed(each, self.measure) for each in text.split(";") if text.strip()]


class PairsRow(TextRow):
    """Any number of pairs of numbers as one line, with a semicolon between pairs."""

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        if self.path not in pending:
            self.editor.home(False)

    def text_of(self, value: Any) -> str:
        return "; ".join(f"{x:.6g}, {y:.6g}" for x, y in value or ())

    def value_of(self, text: str) -> object:
        """The pairs; the text itself where it has others, which the scene refuses."""
        try:
            return [[float(number) for number in pair.split(",")] for pair in text.split(";")]
        except ValueError:
            return super().value_of(text)
