"""Fields for how far lenses may be off, and for how many of them are traced."""

import math
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QPushButton, QWidget

from ui.panels.edits import Edit
from ui.panels.fields import NumberRow
from workbench.analysis.tolerances import Tolerances
from workbench.errors import Refused
from workbench.scene import LENGTH, Measure, Scene, Unit
from workbench.units import ratio, times

_MOST = 100_000  # lenses
# Of the lens, to begin with.
_DECENTRE, _SCALE = 0.005, 0.1


class ToleranceForm(QWidget):
    """What is asked for; a field that is refused says why.

    Attributes
    ----------
    toggled, save_asked : Signal()
        A person wants to begin, or to cancel; to save what was found.
    obstacle : str
        What in the task itself tolerances do not know, as it was found last; empty if nothing.
    """

    toggled = Signal()
    save_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.obstacle = ""
        self._scene: Scene | None = None
        self._data: dict[str, Any] = {}
        self._rows = _make_rows()
        tilt, decentre, index, distance, turn, shift, surface, lenses, seed = self._rows
        self._distance, self._turn, self._shift = distance, turn, shift
        grid = QGridLayout(self)
        grid.setContentsMargins(6, 4, 6, 6)
        grid.setVerticalSpacing(3)
        pairs = ((tilt, decentre), (index, distance), (turn, shift), (surface,), (lenses, seed))
        for line, pair in enumerate(pairs):
            for number, row in enumerate(pair):
                grid.addWidget(row.label, line, 2 * number)
                grid.addWidget(row, line, 2 * number + 1, 1, 1 if len(pair) == 2 else 3)
        self.begin = QPushButton()
        self.begin.clicked.connect(self.toggled)
        self.save = QPushButton("Save…")
        self.save.setToolTip("Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)")
        self.save.clicked.connect(self.save_asked)
        buttons = QHBoxLayout()
        buttons.setSpacing(6)
        buttons.addWidget(self.begin)
        buttons.addWidget(self.save)
        buttons.addStretch(1)
        grid.addLayout(buttons, len(pairs), 0, 1, 4)
        grid.setRowStretch(len(pairs) + 1, 1)
        for row in self._rows:
            row.edited.connect(self._take)
            row.reverted.connect(self._revert)

    @property
    def within(self) -> Tolerances:
        """How far lenses may be off."""
        return self._possible(self._data)

    @property
    def lenses(self) -> int:
        """How many."""
        return int(self._data["lenses"])

    @property
    def seed(self) -> int:
        """Of which kind."""
        return int(self._data["seed"])

    def show_scene(self, scene: Scene) -> None:
        """Take the unit of a design, and for another size of lens lengths that suit it."""
        before, self._scene = self._scene, scene
        width = 2 * max(scene.optic.half_width)
        if before is not None and before.unit != scene.unit:
            before = self._convert(before, scene.unit)
        if before is None or before.optic.half_width != scene.optic.half_width:
            self._data = {
                "tilt": 0.1,
                "decentre": _DECENTRE * width,
                "index": 0.001,
                "distance": 0.0,
                "source_tilt": 0.0,
                "source_shift": 0.0,
                "surface": [0.0, _SCALE * width],
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
        """Whether all that is typed is possible; what is not, says so."""
        for row in self._rows:
            row.commit()
        self.obstacle = ""
        if not self._refused():
            self._judge(self._data)
        return not self._refused() and not self.obstacle

    def _convert(self, scene: Scene, unit: Unit) -> Scene:
        """Give the lengths for a scene in another unit."""
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
        wanted = {**self._data, row.path: values if row.path == "surface" else values[0]}
        self._judge(wanted)
        if not row.refusal:
            self._data = wanted
            self._show()

    def _judge(self, data: dict[str, Any]) -> None:
        """Have the engine refuse what is not possible for this lens."""
        assert self._scene is not None  # there is one before anything is typed
        try:
            self._possible(data).check(self._scene)
        except Refused as refused:
            row = next((row for row in self._rows if row.concerns(refused.path)), None)
            if row is not None:
                row.refuse(refused.reason)
            else:
                self.obstacle = f"{refused}"

    def _possible(self, data: dict[str, Any]) -> Tolerances:
        """Without errors of what a scene does not have, whatever was typed before."""
        absent = [row.path for row, there in self._sometimes() if not there]
        return _within(data | dict.fromkeys(absent, 0.0))

    def _sometimes(self) -> tuple[tuple[NumberRow, bool], ...]:
        """Rows that not all scenes have, and whether this one has them."""
        assert self._scene is not None  # there is one before anything is asked for
        receiver, source = self._scene.receiver, self._scene.source
        there = receiver.at_distance, source.turns, source.moves
        return tuple(zip((self._distance, self._turn, self._shift), there, strict=True))

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
        for row, there in self._sometimes():
            row.setVisible(there)
            row.label.setVisible(there)

    def _row(self, path: str) -> NumberRow:
        return next(row for row in self._rows if row.concerns(path))


def _within(data: dict[str, Any]) -> Tolerances:
    return Tolerances(
        tilt=math.radians(data["tilt"]),
        decentre=data["decentre"],
        index=data["index"],
        distance=data["distance"],
        surface=(data["surface"][0], data["surface"][1]),
        source_tilt=math.radians(data["source_tilt"]),
        source_shift=data["source_shift"],
    )


def _sound(path: str, value: float) -> bool:
    if path == "lenses":
        return 1 <= value <= _MOST
    return 0 <= value < math.inf


def _allowed(path: str) -> str:
    if path == "lenses":
        return f"a whole number from 1 to {_MOST} is needed"
    return f"a {'whole' if path == 'seed' else 'finite'} number from 0 is needed"


def _make_rows() -> tuple[NumberRow, ...]:
    return (
        NumberRow(
            "tilt",
            "Tilt",
            "Largest angle between lens and optical axis; lenses are tilted evenly within it",
            Measure("°"),
        ),
        NumberRow(
            "decentre",
            "Decentre",
            "Largest distance of the lens from the optical axis",
            LENGTH,
        ),
        NumberRow("index", "Index ±", "Largest error of the refractive index"),
        NumberRow("distance", "Screen ±", "Largest error of the screen's distance", LENGTH),
        NumberRow(
            "source_tilt",
            "Source tilt",
            "Largest angle by which the source is turned about its middle",
            Measure("°"),
        ),
        NumberRow(
            "source_shift",
            "Source shift",
            "Largest distance of the source from its place, in any direction",
            LENGTH,
        ),
        NumberRow(
            "surface",
            "Surface",
            "Root mean square of the exit face's error, and the length over which it is "
            "alike: some micrometres over some millimetres for a milled face",
            LENGTH,
            between="over",
        ),
        NumberRow("lenses", "Lenses", "How many are traced; more make the tail surer", whole=True),
        NumberRow("seed", "Seed", "The same seed gives the same lenses", whole=True),
    )
