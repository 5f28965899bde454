"""Numbers of a row that change in proportion as its label is dragged."""

from itertools import count
from typing import TYPE_CHECKING

from workbench.scene import FieldDescription

if TYPE_CHECKING:
    from ui.panels.fields import NumberRow

_PART = 1.01  # by which a number grows with each pixel
_STEP, _WHOLE_STEP = 0.01, 0.1  # by which 0 does
_DIGITS, _FINE_DIGITS = 3, 4
_drags = count()


class Dragging:
    """Drags on the label of a row: all its numbers but zeros change, the last one if all are."""

    def __init__(self, row: "NumberRow") -> None:
        self._row, self._key = row, ""
        self._start: dict[str, float] = {}
        row.label.allow_drag()
        row.label.begun.connect(self._begin)
        row.label.dragged.connect(self._drag)
        row.label.cancelled.connect(lambda: row.change(self._start, self._key))

    def _begin(self) -> None:
        self._key = f"label {next(_drags)}"
        values = {path: value for path, value in self._row.values.items() if value is not None}
        self._start = {path: value for path, value in values.items() if value}
        if values and not self._start:
            self._start = dict([values.popitem()])

    def _drag(self, by: float) -> None:
        field = self._row.field
        changes = {path: dragged(value, by, field) for path, value in self._start.items()}
        self._row.change(changes, self._key)


def dragged(value: float, by: float, field: FieldDescription) -> float:
    """Return a number of a field after a drag by some pixels."""
    if field.number is int:
        return round(field.clamped(value * _PART**by if value else _WHOLE_STEP * by))
    found = field.times * value * _PART**by if value else _STEP * by
    digits = _DIGITS if by.is_integer() else _FINE_DIGITS
    return field.clamped(float(f"{found:.{digits}g}") / field.times)
