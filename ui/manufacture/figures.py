"""What a shop asks of a lens, each figure beside its limit and what comes of both."""

import math
from typing import NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from ui.manufacture.limits import LimitFields
from workbench.analysis.manufacture import Extreme, Manufacture
from workbench.analysis.manufacture_limits import Limits, Verdict, verdicts

_STATES = {
    "met": ("✓ met", "No place of the lens is beyond the limit."),
    "open": (
        "? open",
        "No place that was looked at is beyond the limit, but that no other place is, is not "
        "proved: {bound} is all that the face surely keeps to.",
    ),
    "broken": ("✗ broken", "The lens is beyond the limit; the map shows where."),
}
"""Sign, word and tip of each verdict."""


class _Line(NamedTuple):
    """The limit that a figure is judged by: as verdicts call it, and its field, if that is here."""

    limited: str
    at_least: bool
    field: str


_LINES = {
    "thinnest": _Line("thickness", True, "min_thickness"),
    "thickest": _Line("thickness", False, "max_thickness"),
    "steepest": _Line("slope", False, "max_slope"),
    "tightest_concave": _Line("concave radius", True, "min_radius"),
    "tightest_convex": _Line("convex radius", True, ""),  # the same as that above
}
_ROUNDING = 1e-9  # what a flat face may have of slope, and of sag in its thicknesses
_NAME, _FOUND, _SIGN, _LIMIT, _STATE = range(5)


class ManufactureFigures(QWidget):
    """A table of figures, limits and verdicts.

    Parameters
    ----------
    fields : LimitFields
        The limits; their fields stand in the table.
    """

    def __init__(self, fields: LimitFields) -> None:
        super().__init__()
        self._fields = fields
        self._found: Manufacture | None = None
        self._unit = ""
        self._grid = grid = QGridLayout(self)
        grid.setContentsMargins(6, 4, 6, 6)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(3)
        grid.setColumnStretch(_LIMIT, 1)
        for column, text in ((_FOUND, "Lens"), (_LIMIT, "Limit")):
            grid.addWidget(QLabel(f"<b>{text}</b>"), 0, column)
        self.found: dict[str, QLabel] = {}
        self.states: dict[str, QLabel] = {}
        for row, (key, line) in enumerate(_LINES.items(), 1):
            if line.field:  # one radius for hollows and humps
                field = fields.rows[line.field]
                rows = 2 if line.field == "min_radius" else 1
                grid.addWidget(field, row, _LIMIT, rows, 1)
                self._add(row, key, field.label)
            else:
                self._add(row, key, _named("Hump radius", "Smallest radius of curvature of humps"))
            grid.addWidget(QLabel("≥" if line.at_least else "≤"), row, _SIGN)
            self.states[key] = state = QLabel()
            state.setAccessibleName(f"Verdict: {self.found[key].accessibleName()}")
            grid.addWidget(state, row, _STATE)
        end = len(_LINES) + 1
        sag = _named("Sag range", "Height of the highest point of the exit face over the lowest")
        draft = _named("Draft", "Least angle between exit face and axis, along which a mould opens")
        self._add(end, "sag_range", sag)
        self._add(end + 1, "draft", draft)
        self.note = QLabel(wordWrap=True)
        grid.addWidget(self.note, end + 2, 0, 1, 5)
        grid.setRowStretch(end + 3, 1)
        fields.changed.connect(self._judge)

    def show_found(self, found: Manufacture, unit: str) -> None:
        """Show the figures of a lens."""
        self._found, self._unit = found, unit
        for key in _LINES:
            extreme: Extreme = getattr(found, key)
            label = self.found[key]
            label.setText(self._in_words(key, extreme.value))
            label.setToolTip(f"<p>{self._where(key, extreme)}</p>")
        flat = found.sag_range < _ROUNDING * found.thickest.value
        self.found["sag_range"].setText(f"{0 if flat else found.sag_range:.4g} {unit}")
        self.found["draft"].setText(f"{found.draft:.4g}°")
        self.say("")
        self._judge(self._fields.limits)

    def show_nothing(self) -> None:
        """Show no lens."""
        self._found = None
        for label in (*self.found.values(), *self.states.values()):
            label.clear()
            label.setToolTip("")

    def say(self, sentence: str) -> None:
        """What there is to know beside; while there is something, the figures are of before."""
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))
        for label in (*self.found.values(), *self.states.values()):
            label.setEnabled(not sentence)

    def _add(self, row: int, key: str, name: QLabel) -> None:
        self._grid.addWidget(name, row, _NAME)
        self.found[key] = QLabel()
        self.found[key].setAccessibleName(name.text())
        self.found[key].setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._grid.addWidget(self.found[key], row, _FOUND)

    def _judge(self, limits: Limits) -> None:
        if self._found is None:
            return
        judged = {(v.name, v.at_least): v for v in verdicts(self._found, limits)}
        for key, line in _LINES.items():
            self._show_state(key, judged.get((line.limited, line.at_least)))

    def _show_state(self, key: str, verdict: Verdict | None) -> None:
        text, tip = _STATES[verdict.state] if verdict else ("", "")
        label = self.states[key]
        label.setText(text)
        font = label.font()
        font.setBold(text == _STATES["broken"][0])
        label.setFont(font)
        if verdict is not None:
            tip = tip.format(bound=self._in_words(key, verdict.found.bound))
        label.setToolTip(f"<p>{tip}</p>" if tip else "")

    def _in_words(self, key: str, value: float) -> str:
        if math.isinf(value):
            return "none"
        if key == "steepest":
            return f"{0 if value < _ROUNDING else value:.4g}°"
        return f"{value:.4g} {self._unit}"

    def _where(self, key: str, extreme: Extreme) -> str:
        if math.isinf(extreme.value):
            return "The face has none."
        x, y = extreme.place
        bound = self._in_words(key, extreme.bound)
        return f"At x = {x:.4g}, y = {y:.4g} {self._unit}. Nowhere beyond {bound}."


def _named(text: str, tip: str) -> QLabel:
    label = QLabel(text)
    label.setToolTip(f"<p>{tip}</p>")
    return label
