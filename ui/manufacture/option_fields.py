"""Fields of a group of export options, from its description, and what was chosen last."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any, Generic, Literal, TypeVar

from annotated_types import Ge, Le
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.background import Background, Work
from ui.panels.edits import Edit
from ui.panels.entries import DataForm
from ui.panels.fields import Row, described
from ui.panels.rows import value_row
from ui.widgets.controls import filled
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.labels import WrappedLabel
from ui.words import tr
from workbench.errors import Refused
from workbench.option_groups import DEGREES, FEED, LENGTH, PERCENT, Option, OptionGroup
from workbench.scene import LENGTH as OF_SCENE
from workbench.scene import Measure
from workbench.scene.fields import ANGLE, Choices, LeftOut

Group = TypeVar("Group", bound=OptionGroup)
_MEASURES = {LENGTH: OF_SCENE, DEGREES: ANGLE, PERCENT: Measure("%", "percent")}
_COLUMN, _LETTERS = 12, 46  # rows of a column, and letters across it


class OptionFields(DataForm, Generic[Group]):
    """A field for each option of a group."""

    def __init__(self, unit: str, begin_with: Group) -> None:
        self._group, self._usual = type(begin_with), type(begin_with)()
        data = {"unit": unit, **asdict(begin_with)}
        super().__init__(self._made(), data, self._group.of)
        for row in self.rows:
            row.reserve_unit(FEED)
        columns = filled(QHBoxLayout(self), margins=0, spacing=24)
        for first in range(0, len(self.rows), _COLUMN):
            columns.addLayout(self.in_form(self.rows[first : first + _COLUMN]), 1)
        letters = _LETTERS * self.fontMetrics().averageCharWidth()
        self.setMinimumWidth(letters * columns.count())
        self.show_rows()

    @property
    def options(self) -> Group:
        return self._group.of(self.data)

    def enter(self, **values: object) -> None:
        name = next(iter(values))
        self.edit(Edit(name, name, values))

    def _made(self) -> Iterator[Row]:
        for name, about in self._group.about():
            row = option_row(name, about, getattr(self._usual, name))
            if about.needs is not None:
                other, values = about.needs
                row.only_if(lambda data, o=other, v=values: data[o] in v)  # type: ignore[misc]
            yield row


class OptionDialog(Dialog):
    """Asks for the options of a format."""

    plan = None  # of a cut, which is planned when the file is written

    def __init__(
        self, unit: str, begin_with: Sequence[OptionGroup], title: str, window: QWidget
    ) -> None:
        super().__init__(title, window, Buttons.Ok | Buttons.Cancel)
        self.fields = [OptionFields(unit, each) for each in begin_with]
        self.fill(*self.fields)

    @property
    def options(self) -> tuple[OptionGroup, ...]:
        return tuple(each.options for each in self.fields)

    def accept(self) -> None:
        if not any(each.refused for each in self.fields):
            super().accept()


class WorkDialog(Dialog):
    """Fields of work in a thread; its progress and its outcome stand below them."""

    def __init__(self, title: str, name: str, window: QWidget) -> None:
        super().__init__(title, window, Buttons.Cancel)
        self.state, self._working = WrappedLabel(), ""  # a text with the percentage that is done
        self.state.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.background = Background(name, self)
        self.background.progressed.connect(self._show_progress)
        self.background.done.connect(self._show_outcome)
        self.background.failed.connect(self._show_failure)
        self.finished.connect(self.background.close)

    def _begin(self, working: str, work: Work) -> None:
        self._working = working
        self._show_progress(None, 0.0)
        self.background.begin(work)

    def _show_progress(self, _: object, done: float) -> None:
        self.state.setText(self._working.format(percent=round(100 * done)))

    def _show_outcome(self, _: object, found: Any) -> None: ...

    def _show_failure(self, reason: str) -> None:
        self.state.setText(f"\N{WARNING SIGN} {reason}")


def option_row(name: str, about: Option, usual: Any) -> Row:
    """Return the row of an option; ``usual`` is its default."""
    marks: list[object] = [_MEASURES.get(about.unit) or Measure(about.unit)]
    kind: Any = about.kind
    if about.choices:
        kind = Literal[tuple(about.choices)]
        marks.append(Choices(tuple((each, tr(title)) for each, title in about.choices.items())))
    elif about.kind is not bool:
        marks += [Ge(about.least), Le(about.most)]
    optional = usual is None or not (about.choices or about.kind is bool)
    if optional and (about.empty or usual is not None):
        marks.append(LeftOut(about.empty or format(usual, "g")))
    return value_row(
        described(tr(about.title), tr(about.tip), kind, *marks, optional=optional), name
    )


def kept_options(settings: QSettings, unit: str, group: type[Group]) -> Group:
    """Return what was chosen last for designs of this unit, or the defaults."""
    try:
        return group.of(json.loads(str(settings.value(_key(unit, group), "{}"))))
    except (ValueError, TypeError, Refused):  # not this program's, or not this version's
        return group()


def keep_options(settings: QSettings, unit: str, options: OptionGroup) -> None:
    """Keep what was chosen, for the next dialog and the next start."""
    settings.setValue(_key(unit, type(options)), json.dumps(asdict(options)))


def _key(unit: str, group: type[OptionGroup]) -> str:
    return f"{group.__name__.lower()}/{unit}"
