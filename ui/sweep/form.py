"""Fields that a sweep varies, and their values."""

import re
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QComboBox, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from ui.words import field_title, later, tr
from workbench.report.scene_rows import FieldRow, field_rows

if TYPE_CHECKING:
    from workbench.scene import Scene
    from workbench.sweep.points import Variation

_AT_MOST = 2  # fields at once
# Nothing of the lens depends on these, or a sweep refuses them.
_NOT = re.compile(r"unit|regions|images\[[1-9]|elements\[\d+\]\.(kind|name)$")
_VALUES = later(
    "Between commas: numbers as 1, 2.5, 3; whole numbers as 0..4; pairs as 64x48; words as auto. "
    "Lengths in the unit of the scene."
)


class SweepForm(QWidget):
    """A field and its values, and a second one if somebody wants it.

    Attributes
    ----------
    lines : QFormLayout
        Takes what else is asked for.
    """

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
            line = QHBoxLayout()
            line.addWidget(field, 1)
            line.addWidget(values, 1)
            self.lines.addRow(title, line)

    def show_scene(self, scene: "Scene") -> None:
        """Offer the fields of a scene; chosen ones stay, as far as it has them."""
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
        """What is asked for.

        Raises
        ------
        Refused
            If values of a field are missing or are none.
        """
        from workbench.sweep.points import Variation  # late, as all of sweeps

        found = []
        for field, values in zip(self.fields, self.values, strict=True):
            if path := field.currentData():
                found.append(Variation.parse(f"{path}={values.text().replace(' ', '')}"))
        return found

    def titles(self) -> list[str]:
        """What the chosen fields are called."""
        return [field.currentText() for field in self.fields if field.currentData()]

    def _show_present(self) -> None:
        """Say what the chosen fields are now, where their values are to be typed."""
        for field, values in zip(self.fields, self.values, strict=True):
            row = self._rows.get(field.currentData() or "")
            values.setEnabled(row is not None)
            now = "" if row is None else tr("now {value}").format(value=row.value)
            values.setPlaceholderText(now)
