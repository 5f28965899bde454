"""Rows of a part of the scene, from the descriptions of its fields."""

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import replace
from typing import Any

from ui.panels.edits import holder_of
from ui.panels.fields import (
    AutoRow,
    Changes,
    CheckRow,
    ChoiceRow,
    Condition,
    NumberRow,
    Row,
    described,
)
from ui.panels.text_rows import NumbersRow, PairsRow, TextRow
from ui.words import in_sentence, tr
from workbench.design.task import LARGEST_PICTURE
from workbench.levels import Level
from workbench.scene import FieldDescription, Kinds, Part, Scene
from workbench.scene.fields import ForMethod, NamesFile
from workbench.scene.part import summary_of, title_of
from workbench.scene.paths import value_at

Make = Callable[[FieldDescription, str], list[Row]]


class Rows:
    """Makes rows from the descriptions of fields."""

    def __init__(
        self,
        task: Callable[[], Scene],
        own: Mapping[str, Make] | None = None,
        stage: str = "",
        place: str = "",
    ) -> None:
        self._task, self._own = task, own or {}
        self._stage, self._place = stage, place

    def of_part(self, part: type[Part], path: str) -> list[Row]:
        return [
            row for field in part.fields() for row in self.of_field(field, f"{path}.{field.name}")
        ]

    def of_field(self, field: FieldDescription, path: str) -> list[Row]:
        rows = at_least(field.level, self._own.get(field.name, self._of_field)(field, path))
        if method := field.mark(ForMethod):
            for row in rows:
                row.only_if(lambda scene: self._method(scene) == method.method)
        return rows

    def of_kinds(self, field: FieldDescription, path: str, label: str = "") -> list[Row]:
        """Return the row of the kind, and the rows of each kind, of a field that has several."""
        kinds = field.mark(Kinds)
        if kinds is None:
            raise TypeError(f"{path} has parts of one kind only")
        named = replace(field, title=tr(label or field.title))
        choice = KindRow(path, named, kinds, lambda kind: self._first_of(kinds, kind, path))
        rows: list[Row] = at_least(kinds.level, [choice])
        for own, having in self.fields_of(field.parts):
            if own.name != kinds.field:
                for row in self.of_field(own, f"{path}.{own.name}"):
                    row.only_if(_is_of(path, having))
                    rows.append(row)
        return rows

    def fields_of(
        self, kinds: Sequence[type[Part]]
    ) -> list[tuple[FieldDescription, list[type[Part]]]]:
        return _merged(kinds)

    def _of_field(self, field: FieldDescription, path: str) -> list[Row]:
        if field.listed:
            return []  # their panel has rows for one of them
        if field.members:
            return [
                row
                for number in range(len(field.members))
                for row in self._of_member(field, number, path)
            ]
        if field.mark(Kinds):
            choice, *rows = self.of_kinds(field, path)
            for row in rows:
                if row.level >= choice.level:  # else it stands elsewhere
                    row.put_under(choice)
            return [choice, *rows]
        if field.parts:
            return self.of_part(field.parts[0], path)
        return [value_row(field, path)]

    def _of_member(self, field: FieldDescription, number: int, path: str) -> list[Row]:
        member = field.members[number]
        choice, *rows = self.of_field(member, f"{path}[{number}]")
        for row in rows:
            row.of = tr(member.title)
            if row.level < choice.level:
                field_of = {"panel": row.of, "field": in_sentence(row.label.text())}
                row.label.setText(tr("{panel} {field}").format(**field_of))
                row.of = ""
        return [choice, *rows]

    def _first_of(self, kinds: Kinds, kind: type[Part], path: str) -> Part | None:
        task = self._task()
        before = value_at(task, f"{self._place}{path.removeprefix(self._stage)}".removeprefix("."))
        return kinds.exchanged(before, kind, task)

    def _method(self, scene: Scene) -> str:
        own = value_at(scene, f"{self._stage}.method") if self._stage else None
        return str(own or scene.run.method)


def value_row(field: FieldDescription, path: str) -> Row:
    """The row of a field that holds numbers, a choice, a yes or no, a file's name, or text."""
    if field.choices:
        return ChoiceRow(field, path)
    if field.type is bool:
        return CheckRow(field, path)
    if field.mark(NamesFile):
        kept = tr("The design keeps files of up to {largest} MB.")
        tip = f"{tr(field.tip)} {kept.format(largest=LARGEST_PICTURE >> 20)}"
        return TextRow(replace(field, tip=tip), path, tr("Choose a file"))
    if field.number is None:
        return PairsRow(field, path) if field.several else TextRow(field, path)
    if field.several:
        return NumbersRow(field, path)
    return AutoRow(field, path) if field.auto else NumberRow(field, path)


class KindRow(ChoiceRow):
    """The kind of a part of the scene."""

    def __init__(
        self,
        part: str,
        field: FieldDescription,
        kinds: Kinds,
        begin: Callable[[type[Part]], Part | None],
    ) -> None:
        self._part, self._kinds, self._begin = part, kinds, begin
        self._named = {kinds.name_of(kind): kind for kind in field.parts}
        tip = " ".join([tr(field.tip), *map(_sentence, field.parts)])
        super().__init__(
            described(field.title, tip, str, *field.marks, optional=field.optional),
            f"{part}.{kinds.field}",
            [(name, tr(title_of(kind))) for name, kind in self._named.items()],
            read=self._read_kind,
            changes=self._change,
        )
        self._shown = ""

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        super().show_scene(scene, pending)
        self._shown = self._read_kind(scene)
        whole, name = holder_of(scene, self._part)
        self.changed = isinstance(whole, Part) and whole.differs(str(name))

    def forget(self) -> None:
        super().forget()
        self._shown = ""

    def concerns(self, path: str) -> bool:
        """Whether a refusal of ``path`` belongs to this row; one of the whole part does."""
        return path == self._part or super().concerns(path)

    def _is_there(self, scene: Any) -> bool:
        return holder_of(scene, self._part)[0] is not None

    def _read_kind(self, scene: Any) -> str:
        part = value_at(scene, self._part)
        return "" if part is None else self._kinds.name_of(type(part))

    def _change(self, name: str) -> Changes | None:
        if not name:
            return {self._part: None} if self._shown else None
        if not (self._shown or self._optional):  # the part went while its choices were open
            return None
        first = self._begin(self._named[name])
        if first is None:
            self.asked.emit(self.path)
            return None
        if name == self._shown:
            return None
        return {self._part: first.model_dump(mode="json", exclude_none=True)}


def at_least(level: Level, rows: list[Row]) -> list[Row]:
    """Return rows, each at this level or a deeper one."""
    for row in rows:
        row.level = max(row.level, level)
    return rows


def _sentence(kind: type[Part]) -> str:
    return f"{tr(title_of(kind))}: {in_sentence(tr(summary_of(kind)))}"


def _merged(kinds: Sequence[type[Part]]) -> list[tuple[FieldDescription, list[type[Part]]]]:
    """Fields of all kinds in order, each with the kinds that have it; equal fields are merged."""
    merged: list[tuple[FieldDescription, list[type[Part]]]] = []
    for kind in kinds:
        place = 0
        for field in kind.fields():
            known = next((k for k, (other, _) in enumerate(merged) if other == field), None)
            if known is None:
                merged.insert(place, (field, [kind]))
            else:
                merged[known][1].append(kind)
                place = known
            place += 1
    return merged


def _is_of(path: str, kinds: Sequence[type[Part]]) -> Condition:
    return lambda scene: type(value_at(scene, path)) in kinds
