"""Rows of a form: editors of one field, its unit, and the reason of a refusal.

A row shows the scene and emits edits; it does not validate. Refused text stays until it is
corrected, or reverted with Escape.
"""

from collections.abc import Callable, Mapping, Sequence, Set
from itertools import count
from operator import attrgetter
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from ui.panels.editors import NumberEditor, Remark, TextEditor
from ui.panels.edits import Edit, holder_of
from ui.widgets import theme
from ui.widgets.controls import Chooser, filled
from ui.widgets.labels import DragLabel
from ui.widgets.search import holds
from ui.words import in_sentence, tr
from workbench.powers import rounded
from workbench.scene import AutoNet, Element, FieldDescription, Measure, Part
from workbench.scene.fields import AUTO, Fallback, LeftOut
from workbench.scene.paths import value_at

Changes = dict[str, object]
Condition = Callable[[Any], bool]
_INDENT = 10  # logical pixels
_PART = 1.01  # by which a number grows with each pixel of a drag
_STEP, _WHOLE_STEP = 0.01, 0.1  # by which 0 does
_DIGITS, _FINE_DIGITS = 3, 4
_drags = count()


def described(
    title: str, tip: str, kind: Any = str, *marks: object, optional: bool = False
) -> FieldDescription:
    """Return a description for a row that stands for no field of a scene."""
    return FieldDescription("", title, tip, kind, optional, False, marks)


class Row(QWidget):
    """Editors of a field side by side, with their unit and a refusal below."""

    edited = Signal(object)
    reverted = Signal(object)
    asked = Signal(str)  # for a file of the part that it belongs to, by its path

    def __init__(self, field: FieldDescription, path: str) -> None:
        super().__init__()
        field = field.in_window
        self.field, self.path, self.measure, self.level = field, path, field.measure, field.level
        label = tr(field.title)
        self.label = DragLabel(label)
        self.changed = False  # whether its value is another than by default
        self.above: Row | None = None
        self.of = ""  # the part whose field it is, where a panel has several of a kind
        self.name = label  # distinguished from those of other panels by the panel
        self._conditions: list[Condition] = []
        self._unit = QLabel()
        if self.measure == Measure():
            self._unit.hide()
        self._refusal = Remark("refusal")
        self._editors = QHBoxLayout()
        self._editors.addWidget(self._unit)
        filled(QVBoxLayout(self), self._editors, self._refusal, margins=0, spacing=2)
        sentence, *ends = field.bounds(field.times)
        self.explain(f"{tr(field.tip)} {tr(sentence).format(*ends)}".rstrip())

    def explain(self, tip: str) -> None:
        self._tip = tip
        for widget in (self.label, self):
            widget.setToolTip(f"<p>{tip}</p>")  # rich text, because only that wraps

    def reserve_unit(self, longest: str) -> None:
        """Keep space for a unit, so that the editors of a form end at one line."""
        self._unit.setMinimumWidth(self._unit.fontMetrics().horizontalAdvance(longest))

    def put_under(self, above: "Row") -> None:
        """Move the label to the right: the field belongs to one above, which is shown with it."""
        self.above = self.above or above
        self.label.setIndent(self.label.indent() + _INDENT if self.label.indent() > 0 else _INDENT)

    def leave_undo(self) -> None:
        """Leave undo of entered text to the window."""
        for editor in self.findChildren(TextEditor):
            editor.of_design = True

    def only_if(self, condition: Condition) -> None:
        """Show the row only for scenes that meet a condition."""
        self._conditions.append(condition)

    def matches(self, words: Sequence[str]) -> bool:
        """Whether all words, which are `folded`, occur in its name, its tip or its path."""
        return holds(f"{self.name} {self._tip} {self.path}", words)

    def present(self, scene: Any) -> bool:
        return self._is_there(scene) and all(condition(scene) for condition in self._conditions)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        """Show the values of a scene or of plain data, except refused edits."""
        part, name = holder_of(scene, self.path)
        self.changed = isinstance(part, Part) and part.differs(str(name))
        if isinstance(part, Element):
            part = part.lit(scene.source.wavelength)
        remarks = part.remarks() if isinstance(part, Part) else {}
        unit = self.measure.sign_in(value_at(scene, "unit"))
        self._unit.setText(tr(remarks.get(str(name), unit)))
        self._unit.setVisible(bool(self._unit.text()))

    def commit(self) -> None:
        for editor in self.findChildren(TextEditor):
            editor.commit()

    @property
    def unentered(self) -> bool:
        return any(editor.unentered for editor in self.findChildren(TextEditor))

    def forget(self) -> None:
        """Drop typed text: the scene has no such field."""
        for editor in self.findChildren(TextEditor):
            editor.show_value("")

    def concerns(self, path: str) -> bool:
        """Whether a refusal of ``path`` belongs to this row."""
        return path == self.path or path.startswith((self.path + "[", self.path + "."))

    def refuse(self, reason: str) -> None:
        """Show why the edit is not possible; an empty reason clears it."""
        if reason or self.refusal:
            self._refusal.show_text(f"\N{WARNING SIGN} {reason}" if reason else "")
            self.setProperty("refused", bool(reason))
            theme.restyle(self)

    @property
    def refusal(self) -> str:
        return self._refusal.text()

    def _is_there(self, scene: Any) -> bool:
        if self.field.optional:
            return holder_of(scene, self.path)[0] is not None
        return value_at(scene, self.path) is not None

    def _add(self, widget: QWidget, stretch: int = 1) -> None:
        self._editors.insertWidget(self._editors.count() - 1, widget, stretch)
        if not widget.accessibleName():
            widget.setAccessibleName(self.label.text())
        if self.label.buddy() is None:
            self.label.setBuddy(widget)

    def _emit_edit(self, path: str, changes: Changes, drag: str = "") -> None:
        name = in_sentence(self.name)
        text = tr("change of {name}").format(name=name)
        self.edited.emit(Edit(path, text, changes, name=name, drag=drag))


class NumberRow(Row):
    """One or several numbers; where they may be left out, a placeholder shows what counts then.

    Drags on the label change all numbers but zeros in proportion, the last one if all are zeros.
    """

    def __init__(self, field: FieldDescription, path: str) -> None:
        super().__init__(field, path)
        count = field.count
        paths = [f"{path}[{k}]" for k in range(count)] if count > 1 else [path]
        self.editors = {p: NumberEditor(field) for p in paths}
        self._values: dict[str, float] = {}  # of the scene
        self._drag, self._start = "", dict[str, float]()  # name of the drag, and values before it
        self.label.allow_drag()
        self.label.begun.connect(self._begin_drag)
        self.label.dragged.connect(self._drag_by)
        self.label.cancelled.connect(lambda: self._put(self._start))
        for number, (place, editor) in enumerate(self.editors.items()):
            if number:
                self._add(QLabel(tr(self.field.between)), 0)
            if count > 1:
                editor.setAccessibleName(
                    tr("{label}, {number} of {count}").format(
                        label=self.label.text(), number=number + 1, count=count
                    )
                )
            self._add(editor)
            editor.committed.connect(lambda text, p=place: self._commit(p, text))
            editor.reverted.connect(lambda p=place: self.reverted.emit(p))

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        values = {path: value_at(scene, path) for path in self.editors}
        self._values = {path: value for path, value in values.items() if value is not None}
        for (path, editor), value in zip(self.editors.items(), values.values(), strict=True):
            if not pending & {path, self.path}:
                text = "" if value is None else format(self.field.times * value, ".12g")
                editor.show_value(text)
        if self._may_be_empty:
            for editor, stand_in in zip(self.editors.values(), self._stand_ins(scene), strict=True):
                text = stand_in if isinstance(stand_in, str) else format(stand_in, "g")
                editor.setPlaceholderText(text)

    @property
    def _may_be_empty(self) -> bool:
        return self.field.optional or self.field.auto

    def _begin_drag(self) -> None:
        self._drag, values = f"label {next(_drags)}", self._values
        changing = [path for path, value in values.items() if value] or list(values)[-1:]
        self._start = {path: values[path] for path in changing}

    def _drag_by(self, pixels: float) -> None:
        start = self._start.items()
        self._put({path: dragged(value, pixels, self.field) for path, value in start})

    def _put(self, values: Mapping[str, float]) -> None:
        if values:
            self._emit_edit(self.path, {**values}, self._drag)

    def _stand_ins(self, scene: Any) -> Sequence[float | str]:
        if left_out := self.field.mark(LeftOut):
            return [tr(left_out.title)] * len(self.editors)
        fallback = self.field.mark(Fallback)
        if fallback is None:
            return [tr("none")] * len(self.editors)
        found = attrgetter(fallback.path)(scene)
        return found if self.field.count > 1 else [found]

    def _commit(self, path: str, text: str) -> None:
        texts = [editor.text().strip() for editor in self.editors.values()]
        if self._may_be_empty and not text.strip():
            self._emit_edit(self.path, {self.path: AUTO if self.field.auto else None})
        elif self.field.count == 1 or not self._may_be_empty or (self._values and all(texts)):
            self._emit_edit(path, {path: self.editors[path].typed(text)})
        else:  # a number alone counts for both
            values = [e.typed(t or text) for e, t in zip(self.editors.values(), texts, strict=True)]
            self._emit_edit(self.path, {self.path: values})


class ChoiceRow(Row):
    """A choice, committed at once; no value is one where the field has a text for that."""

    def __init__(
        self,
        field: FieldDescription,
        path: str,
        choices: Sequence[tuple[str, str]] = (),
        read: Callable[[Any], str] | None = None,
        changes: Callable[[str], Changes | None] | None = None,
    ) -> None:
        super().__init__(field, path)
        titles = dict(choices) or {value: tr(title) for value, title in field.choices}
        left_out = field.mark(LeftOut) if field.optional else None
        if left_out is not None:
            titles = {"": tr(left_out.title), **titles}
        self._optional = left_out is not None
        self._read = read or (lambda scene: str(value_at(scene, path) or ""))
        self._changes = changes or (lambda choice: {path: choice or None})
        self.chooser = Chooser(titles)
        self._add(self.chooser)
        self.chooser.activated.connect(self._choose)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        if self.path not in pending:
            self.chooser.choose(self._read(scene))

    def _is_there(self, scene: Any) -> bool:
        return super()._is_there(scene) and (self._optional or bool(self._read(scene)))

    def _choose(self, index: int) -> None:
        changes = self._changes(self.chooser.itemData(index))
        if changes is None:
            self.reverted.emit(self.path)
        else:
            self._emit_edit(self.path, changes)


class CheckRow(Row):
    """A check box."""

    def __init__(self, field: FieldDescription, path: str) -> None:
        super().__init__(field, path)
        self.box = QCheckBox()
        self._add(self.box)
        self.box.clicked.connect(lambda checked: self._emit_edit(path, {path: checked}))

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        if self.path not in pending:
            self.box.setChecked(value_at(scene, self.path))


class AutoRow(NumberRow):
    """Numbers, or a tick for automatic; typing clears the tick, an empty field sets it."""

    def __init__(self, field: FieldDescription, path: str) -> None:
        super().__init__(field, path)
        self.box = QCheckBox(tr("Auto"))
        self.box.setAccessibleName(tr("{label}, automatic").format(label=self.label.text()))
        self.box.setToolTip(self.toolTip())
        self._editors.addWidget(self.box)
        self._shape: tuple[int, ...] | None = None  # what counts now
        self.box.clicked.connect(self._choose)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        value = value_at(scene, self.path)
        auto = isinstance(value, AutoNet)
        # An entrance face takes what the exit face has.
        self._shape = (value.shape or scene.optic.known_shape) if auto else value
        super().show_scene(scene, pending)
        self._unit.hide()  # what was chosen stands in the fields
        if self.path not in pending:
            self.box.setChecked(auto)

    def _stand_ins(self, scene: Any) -> Sequence[float | str]:
        return self._shape or (tr("auto"),) * len(self.editors)

    def _choose(self, auto: bool) -> None:
        self._emit_edit(
            self.path, {self.path: AUTO if auto or self._shape is None else [*self._shape]}
        )


def dragged(value: float, by: float, field: FieldDescription) -> float:
    """Return a number of a field after a drag by some pixels."""
    if field.number is int:
        return round(field.clamped(value * _PART**by if value else _WHOLE_STEP * by))
    found = field.times * value * _PART**by if value else _STEP * by
    digits = _DIGITS if by.is_integer() else _FINE_DIGITS
    return field.clamped(rounded(found, digits) / field.times)
