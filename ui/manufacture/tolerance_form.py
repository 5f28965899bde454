"""Fields for how far lenses may be off, and for how many of them are traced."""

import math
from collections.abc import Iterator, Sequence
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QPushButton, QWidget

from ui.panels.edits import Edit
from ui.panels.fields import NumberRow
from ui.words import error_text, later, tr
from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.errors import Refused
from workbench.scene import LENGTH, Measure, Scene, Unit
from workbench.scene.fields import ANGLE
from workbench.units import ratio, times

_MEASURES = {"": Measure(), "degrees": ANGLE, "length": LENGTH}
_MOST = 100_000  # lenses
# Of the lens, to begin with.
_DECENTRE, _SCALE = 0.005, 0.1


class ToleranceForm(QWidget):
    """Tolerances, number of lenses and seed, with refusals beside the fields."""

    toggled = Signal()
    save_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.obstacle = ""
        self._scene: Scene | None = None
        self._data: dict[str, Any] = {}
        self._rows = _make_rows()
        grid = QGridLayout(self)
        grid.setContentsMargins(6, 4, 6, 6)
        grid.setVerticalSpacing(3)
        lines = list(_lines(self._rows))
        for line, rows in enumerate(lines):
            for number, row in enumerate(rows):
                grid.addWidget(row.label, line, 2 * number)
                grid.addWidget(row, line, 2 * number + 1, 1, 3 if row.path in PAIRS else 1)
        self.begin = QPushButton()
        self.begin.clicked.connect(self.toggled)
        self.save = QPushButton(tr("Save…"))
        self.save.setToolTip(
            tr("Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)")
        )
        self.save.clicked.connect(self.save_asked)
        grid.setRowStretch(len(lines), 1)
        for row in self._rows:
            row.edited.connect(self._take)
            row.reverted.connect(self._revert)

    @property
    def within(self) -> Tolerances:
        return self._possible(self._data)

    @property
    def lenses(self) -> int:
        return int(self._data["lenses"])

    @property
    def seed(self) -> int:
        return int(self._data["seed"])

    def show_scene(self, scene: Scene) -> None:
        """Use the unit of a design, and default lengths for another lens size."""
        before, self._scene = self._scene, scene
        width = 2 * max(scene.optic.half_width)
        if before is not None and before.unit != scene.unit:
            before = self._convert(before, scene.unit)
        if before is None or before.optic.half_width != scene.optic.half_width:
            self._data = {
                **{name: [0.0, _SCALE * width] if name in PAIRS else 0.0 for name in ABOUT},
                "tilt": 0.1,
                "decentre": _DECENTRE * width,
                "index": 0.001,
                "lenses": 100,
                "seed": 1,
            }
        if before is None or (before.optic, before.source, before.receiver) != (
            scene.optic,
            scene.source,
            scene.receiver,
        ):
            for row in self._rows:  # what was refused may be possible now
                row.refuse("")
        self._show()

    def accepted(self) -> bool:
        """Whether all entries are possible; refused ones show why."""
        for row in self._rows:
            row.commit()
        self.obstacle = ""
        if not self._refused():
            self._judge(self._data)
        return not self._refused() and not self.obstacle

    def _convert(self, scene: Scene, unit: Unit) -> Scene:
        factor = ratio(scene.unit, unit)
        for row in self._rows:
            if row.measure.power:
                value = self._data[row.path]
                self._data[row.path] = (
                    [times(each, factor) for each in value]
                    if isinstance(value, list)
                    else times(value, factor)
                )
        return scene.in_unit(unit)

    def _take(self, edit: Edit) -> None:
        row = self._row(edit.path)
        assert self._scene is not None  # there is one before anything is typed
        unit = self._scene.unit
        try:
            values = [e.typed(e.text()).number(unit) for e in row.editors.values()]
        except ValueError as error:
            row.refuse(f"{error}")
            return
        for value in values:
            if not _sound(row.path, value):
                row.refuse(f"{value}; {_allowed(row.path)}")
                return
        row.refuse("")
        wanted = {**self._data, row.path: values if row.path in PAIRS else values[0]}
        self._judge(wanted)
        if not row.refusal:
            self._data = wanted
            self._show()

    def _judge(self, data: dict[str, Any]) -> None:
        assert self._scene is not None  # there is one before anything is typed
        try:
            self._possible(data).check(self._scene)
        except Refused as refused:
            row = next((row for row in self._rows if row.concerns(refused.path)), None)
            if row is not None:
                row.refuse(tr(refused.reason))
            else:
                self.obstacle = error_text(refused)

    def _possible(self, data: dict[str, Any]) -> Tolerances:
        absent = ABOUT.keys() - self._there()
        none = {name: [0.0, data[name][1]] if name in PAIRS else 0.0 for name in absent}
        return Tolerances.of(data | none)

    def _there(self) -> set[str]:
        assert self._scene is not None  # there is one before anything is asked for
        return {name for name, about in ABOUT.items() if about.there(self._scene)}

    def _refused(self) -> bool:
        return any(row.refusal for row in self._rows)

    def _revert(self, path: str) -> None:
        self._row(path).refuse("")
        self._show()

    def _show(self) -> None:
        assert self._scene is not None
        pending = {p for row in self._rows if row.refusal for p in row.editors}
        for row in self._rows:
            row.show_scene({"unit": self._scene.unit, **self._data}, pending)
        there = self._there()
        for row in self._rows:
            if row.path in ABOUT:
                row.setVisible(row.path in there)
                row.label.setVisible(row.path in there)
                row.explain(tr(ABOUT[row.path].tip, optic=self._scene.optic.called))

    def _row(self, path: str) -> NumberRow:
        return next(row for row in self._rows if row.concerns(path))


def _sound(path: str, value: float) -> bool:
    if path == "lenses":
        return 1 <= value <= _MOST
    return 0 <= value < math.inf


def _allowed(path: str) -> str:
    if path == "lenses":
        return tr("a whole number from 1 to {most} is needed").format(most=_MOST)
    if path == "seed":
        return tr("a whole number from 0 is needed")
    return tr("a finite number from 0 is needed")


def _make_rows() -> tuple[NumberRow, ...]:
    return (
        *(
            NumberRow(
                name,
                tr(about.title),
                tr(about.tip, optic="lens"),
                _MEASURES[about.unit],
                between=later("over") if name in PAIRS else "",
            )
            for name, about in ABOUT.items()
        ),
        NumberRow(
            "lenses",
            tr("Lenses"),
            tr("Number of traced lenses; more lenses give better percentiles"),
            whole=True,
        ),
        NumberRow("seed", tr("Seed"), tr("The same seed gives the same lenses"), whole=True),
    )


def _lines(rows: Sequence[NumberRow]) -> Iterator[Sequence[NumberRow]]:
    single = [row for row in rows if row.path not in PAIRS]
    *errors, last = zip(single[::2], single[1::2], strict=True)
    yield from errors
    yield from ((row,) for row in rows if row.path in PAIRS)
    yield last
