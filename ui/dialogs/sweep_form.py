"""Fields that a sweep varies, and the curve of the errors of its lenses."""

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QComboBox, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from ui.widgets.controls import filled
from ui.widgets.figures import FigureCanvas, translate
from ui.words import field_title, later, tr
from workbench.pictures.error_curves import Curve, draw_sweep
from workbench.report.scene_rows import FieldRow, field_rows

if TYPE_CHECKING:
    from workbench.scene import Scene
    from workbench.sweep.points import Variation
    from workbench.sweep.sweep import PointRow

_AT_MOST = 2  # fields at once
# Nothing of the lens depends on these, or a sweep refuses them.
_NOT = re.compile(r"unit|regions|images\[[1-9]|elements\[\d+\]\.(kind|name)$")
_VALUES = later(
    "Separate values by commas: 1, 2.5, 3; ranges as 0..4; pairs as 64x48; words as auto. Lengths "
    "in the unit of the scene."
)


class SweepForm(QWidget):
    """One or two fields and their values."""

    def __init__(self) -> None:
        super().__init__()
        self.fields = [QComboBox() for _ in range(_AT_MOST)]
        self.values = [QLineEdit() for _ in range(_AT_MOST)]
        self._rows: dict[str, FieldRow] = {}
        self.lines = QFormLayout(self)
        self.lines.setContentsMargins(0, 0, 0, 0)
        titles = tr("Field"), tr("Second field")
        for title, field, values in zip(titles, self.fields, self.values, strict=True):
            field.setAccessibleName(title)
            field.currentIndexChanged.connect(self._show_present)
            values.setAccessibleName(tr("Values of {field}").format(field=title))
            values.setToolTip(f"<p>{tr(_VALUES)}</p>")
            line = filled(QHBoxLayout(), (field, 1), (values, 1))
            self.lines.addRow(title, line)

    def show_scene(self, scene: "Scene") -> None:
        """Offer the fields of a scene; the selection stays where possible."""
        self._rows = {row.path: row for row in field_rows(scene) if not _NOT.match(row.path)}
        for number, field in enumerate(self.fields):
            chosen = field.currentData()
            field.blockSignals(True)
            field.clear()
            if number:
                field.addItem(tr("none"), "")
            for path, row in self._rows.items():
                field.addItem(field_title(row.title), path)
            field.setCurrentIndex(max(field.findData(chosen), 0))
            field.blockSignals(False)
        self._show_present()

    def variations(self) -> "list[Variation]":
        from workbench.sweep.points import Variation  # late, as all of sweeps

        found = []
        for field, values in zip(self.fields, self.values, strict=True):
            if path := field.currentData():
                found.append(Variation.parse(f"{path}={values.text().replace(' ', '')}"))
        return found

    def titles(self) -> list[str]:
        return [field.currentText() for field in self.fields if field.currentData()]

    def _show_present(self) -> None:
        for field, values in zip(self.fields, self.values, strict=True):
            row = self._rows.get(field.currentData() or "")
            values.setEnabled(row is not None)
            now = "" if row is None else tr("now {value}").format(value=row.value)
            values.setPlaceholderText(now)


_EVERY_MS = 50  # lenses that are there already come by the thousand


class SweepCurve(FigureCanvas):
    """Plots errors of finished lenses, a curve for each value of a second field."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, tr("Verified error over the values"), Figure(layout="constrained"))
        self._titles: Sequence[str] = ()
        self._rows: Mapping[int, PointRow] = {}
        self._soon = QTimer(self, singleShot=True, interval=_EVERY_MS)
        self._soon.timeout.connect(self._draw_rows)

    def show_rows(self, titles: Sequence[str], rows: "Mapping[int, PointRow]") -> None:
        """Plot the rows that have a lens, after a short delay."""
        self._titles, self._rows = titles, rows
        if not self._soon.isActive():
            self._soon.start()

    def _draw_rows(self) -> None:
        titles, curves = self._titles, dict[str, list["PointRow"]]()
        for _, row in sorted(self._rows.items()):
            if row.reason is None:
                curves.setdefault(_name(titles, row), []).append(row)
        self.figure.clear()
        if curves:
            drawn = [
                Curve(name, [_first(row) for row in found], [row.verified for row in found])
                for name, found in curves.items()
            ]
            draw_sweep(self.figure.subplots(), titles[0], drawn)
            translate(self.figure, (titles[0], *curves))
        self.recolour()


def _first(row: "PointRow") -> str:
    return next(iter(row.changes.values()))


def _name(titles: Sequence[str], row: "PointRow") -> str:
    _, *others = row.changes.values()
    return ", ".join(f"{title} {value}" for title, value in zip(titles[1:], others, strict=True))
