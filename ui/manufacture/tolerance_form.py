"""Fields for how far lenses may be off, and for how many of them are traced."""

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from fractions import Fraction
from typing import Any

from PySide6.QtWidgets import QGridLayout

from ui.panels.entries import DataForm
from ui.panels.fields import NumberRow, Row, described
from ui.words import later, tr
from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.option_groups import OptionGroup, option
from workbench.scene import LENGTH, Measure, Scene
from workbench.scene.fields import ANGLE, Between
from workbench.units import ratio, times

_MEASURES = {"": Measure(), "degrees": ANGLE, "length": LENGTH}


@dataclass(frozen=True)
class Samples(OptionGroup):
    """Which lenses are traced."""

    lenses: int = option(
        later("Lenses"),
        later("Number of traced lenses; more lenses give better percentiles"),
        100,
        kind=int,
        least=1,
        most=100_000,
    )
    seed: int = option(
        later("Seed"), later("The same seed gives the same lenses"), 1, kind=int, most=2**53
    )


# Of the lens, to begin with.
_DECENTRE, _SCALE = 0.005, 0.1


class ToleranceForm(DataForm):
    """Tolerances, number of lenses and seed, with refusals beside the fields."""

    def __init__(self) -> None:
        super().__init__(self._made(), {}, self._check_all)
        self._scene: Scene | None = None
        grid = QGridLayout(self)
        grid.setContentsMargins(6, 4, 6, 6)
        grid.setVerticalSpacing(3)
        lines = list(_lines(self.rows))
        for line, rows in enumerate(lines):
            for number, row in enumerate(rows):
                grid.addWidget(row.label, line, 2 * number)
                grid.addWidget(row, line, 2 * number + 1, 1, 3 if row.path in PAIRS else 1)
        grid.setRowStretch(len(lines), 1)

    @property
    def within(self) -> Tolerances:
        return self._possible(self.data)

    @property
    def samples(self) -> Samples:
        return Samples.of(self.data)

    def show_scene(self, scene: Scene) -> None:
        """Use the unit of a design, and default lengths for another lens size."""
        before, self._scene = self._scene, scene
        width, former = 2 * max(scene.optic.half_width), tuple[float, ...]()
        if before is not None:
            # Not the scene is converted: a file of heights holds it to its unit.
            factor = ratio(before.unit, scene.unit)
            former = tuple(times(r, factor) for r in before.optic.half_width)
            self._convert(factor)
            self.data["unit"] = scene.unit
        if former != scene.optic.half_width:
            self.data = {
                "unit": scene.unit,
                **{name: [0.0, _SCALE * width] if name in PAIRS else 0.0 for name in ABOUT},
                "tilt": 0.1,
                "decentre": _DECENTRE * width,
                "index": 0.001,
                **asdict(Samples()),
            }
        if before is None or (before.optic, before.source, before.receiver) != (
            scene.optic,
            scene.source,
            scene.receiver,
        ):
            self.forget()  # what was refused may be possible now
        for row in self.rows:
            if row.path in ABOUT:
                row.explain(tr(ABOUT[row.path].tip, optic=scene.optic.called))
        self.show_rows()

    def check(self) -> None:
        """Raise `Refused` unless the tolerances are possible for the shown scene."""
        self._check_all(self.data)

    def _convert(self, factor: Fraction) -> None:
        for row in self.rows:
            if row.measure.power:
                value = self.data[row.path]
                self.data[row.path] = (
                    [times(each, factor) for each in value]
                    if isinstance(value, list)
                    else times(value, factor)
                )

    def _check_all(self, data: dict[str, Any]) -> None:
        """Raise `Refused` with the path of a value that is not possible."""
        assert self._scene is not None  # there is one before anything is typed
        Samples.of(data)
        self._possible(data).check(self._scene)

    def _possible(self, data: dict[str, Any]) -> Tolerances:
        absent = [name for name in ABOUT if not self._is_there(name)]
        none = {name: [0.0, data[name][1]] if name in PAIRS else 0.0 for name in absent}
        return Tolerances.of(data | none)

    def _is_there(self, name: str) -> bool:
        return self._scene is not None and not ABOUT[name].absent(self._scene)

    def _made(self) -> Iterator[NumberRow]:
        for name, about in ABOUT.items():
            kind = tuple[float, float] if name in PAIRS else float
            marks = _MEASURES[about.unit], Between(later("over"))
            tip = tr(about.tip, optic="lens")
            row = NumberRow(described(tr(about.title), tip, kind, *marks), name)
            row.only_if(lambda _, name=name: self._is_there(name))  # type: ignore[misc]
            yield row
        for name, count in Samples.about():
            yield NumberRow(described(tr(count.title), tr(count.tip), int), name)


def _lines(rows: Sequence[Row]) -> Iterator[Sequence[Row]]:
    single = [row for row in rows if row.path not in PAIRS]
    *errors, last = zip(single[::2], single[1::2], strict=True)
    yield from errors
    yield from ((row,) for row in rows if row.path in PAIRS)
    yield last
