"""Fields that say how a face is cut."""

import json
from dataclasses import asdict

from PySide6.QtCore import QSettings, Signal
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QLabel, QLineEdit, QWidget

from ui.words import later, tr
from workbench.errors import Refused
from workbench.files.export.options import PLAIN, RANGES, Cutting
from workbench.quantity import read_number

_LENGTHS = later(
    {
        "tool_radius": (
            "Tool radius",
            "a radius that fits",
            "Radius of the ball. Left empty: that of the design task, or one that fits everywhere.",
        ),
        "scallop": (
            "Ridges",
            later("fine"),
            (
                "How high ridges between neighbouring cuts may be. Left empty: 1e-4 of "
                "the larger half-width, or higher where that takes more moves than a "
                "program can have."
            ),
        ),
        "rim": ("Clamping rim", "0", "Width of stock around the lens, to hold it by."),
        "safe_height": (
            "Travel height",
            "the ball's diameter",
            "How far over its highest cut the cutter travels.",
        ),
    }
)
_MACHINE = later(
    {
        "feed": ("Feed", "How fast the cutter moves while it cuts."),
        "plunge_feed": ("Plunge feed", "How fast the cutter goes down into the stock."),
        "spindle_speed": ("Spindle speed", "Revolutions a minute, clockwise."),
        "dwell": (
            "Dwell",
            "How long the cutter waits above the stock until the spindle is at its speed.",
        ),
    }
)


class CutFields(QWidget):
    """A field for each value of a `Cutting`.

    Parameters
    ----------
    unit : str
        Unit of lengths.
    begin_with : Cutting
        What the fields hold at first.

    Attributes
    ----------
    lines : dict of str to QLineEdit
        By the names of `Cutting`.
    mould : QCheckBox
        Whether a mould is cut.
    changed : Signal()
        A person has changed something.
    """

    changed = Signal()

    def __init__(self, unit: str, begin_with: Cutting) -> None:
        super().__init__()
        self._unit = unit
        self.lines: dict[str, QLineEdit] = {}
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for name, (title, empty, tip) in _LENGTHS.items():
            value = getattr(begin_with, name)
            text = f"{value:.12g}" if value else ""
            self._add(name, tr(title), text, tr(empty), tr(tip), unit)
        for name, (title, tip) in _MACHINE.items():
            least, most, of = RANGES[name]
            allowed = tr("From {least} to {most} {unit}.").format(
                least=f"{least:g}", most=f"{most:,}", unit=of
            )
            text, usual = (f"{getattr(each, name):g}" for each in (begin_with, PLAIN))
            self._add(name, tr(title), text, usual, f"{tr(tip)} {allowed}", of)
        self.mould = QCheckBox(tr("Cut a mould of the face"))
        self.mould.setToolTip(
            tr("The negative: hollows become humps, turned over about the y axis.")
        )
        self.mould.setChecked(begin_with.negative)
        self.mould.toggled.connect(self.changed)
        self._form.addRow("", self.mould)

    def cutting(self) -> Cutting:
        """What the fields say.

        Raises
        ------
        ValueError, Refused
            If one of them is no number or not within its range, or they do not go together.
        """
        numbers = {name: self._number(name) for name in self.lines}
        stated = {name: value for name, value in numbers.items() if value is not None}
        try:
            return Cutting(**stated, negative=self.mould.isChecked())
        except Refused as refused:
            title = self.lines[refused.path].accessibleName()
            raise ValueError(f"{title}: {tr(refused.reason)}") from None

    def _add(self, name: str, title: str, text: str, empty: str, tip: str, unit: str) -> None:
        line = self.lines[name] = QLineEdit(text)
        line.setPlaceholderText(empty)
        line.setToolTip(f"<p>{tip}</p>")
        line.setAccessibleName(title)
        line.textEdited.connect(self.changed)
        row = QHBoxLayout()
        row.addWidget(line, 1)
        row.addWidget(QLabel(unit))
        self._form.addRow(title, row)

    def _number(self, name: str) -> float | None:
        text = self.lines[name].text().strip()
        if not text:
            return None
        unit = RANGES[name].unit if name in RANGES else self._unit
        try:
            return float(read_number(text, unit))
        except ValueError as error:
            raise ValueError(f"{self.lines[name].accessibleName()}: {error}") from None


def kept_cutting(settings: QSettings, unit: str) -> Cutting:
    """Return what was chosen last for designs of this unit, or the defaults."""
    try:
        return Cutting(**json.loads(str(settings.value(_key(unit), "{}"))))
    except (ValueError, TypeError, Refused):  # not this program's, or not this version's
        return PLAIN


def keep_cutting(settings: QSettings, unit: str, cutting: Cutting) -> None:
    """Keep what was chosen, for the next dialog and the next start."""
    settings.setValue(_key(unit), json.dumps(asdict(cutting)))


def _key(unit: str) -> str:
    return f"cutting/{unit}"
