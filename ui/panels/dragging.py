"""Numbers of a row that change in proportion as its label is dragged."""

from collections.abc import Callable, Mapping
from itertools import count

from ui.widgets.labels import DragLabel
from workbench.scene import FieldDescription

_PART = 1.01  # by which a number grows with each pixel
_STEP, _WHOLE_STEP = 0.01, 0.1  # by which 0 does
_DIGITS, _FINE_DIGITS = 3, 4
_drags = count()


class Dragging:
    """Drags on the label of a row: all its numbers but zeros change, the last one if all are.

    ``values`` gives the numbers of the scene by their paths, ``change`` takes others and a name of
    the drag.
    """

    def __init__(
        self,
        label: DragLabel,
        field: FieldDescription,
        values: Callable[[], Mapping[str, float]],
        change: Callable[[Mapping[str, float], str], None],
    ) -> None:
        self._field, self._values, self._change, self._key = field, values, change, ""
        self._start: Mapping[str, float] = {}
        label.allow_drag()
        label.begun.connect(self._begin)
        label.dragged.connect(self._drag)
        label.cancelled.connect(lambda: self._change(self._start, self._key))

    def _begin(self) -> None:
        self._key, values = f"label {next(_drags)}", self._values()
        self._start = {path: value for path, value in values.items() if value} or {
            path: values[path] for path in list(values)[-1:]
        }

    def _drag(self, by: float) -> None:
        start = self._start.items()
        changes = {path: dragged(value, by, self._field) for path, value in start}
        self._change(changes, self._key)


def dragged(value: float, by: float, field: FieldDescription) -> float:
    """Return a number of a field after a drag by some pixels."""
    if field.number is int:
        return round(field.clamped(value * _PART**by if value else _WHOLE_STEP * by))
    found = field.times * value * _PART**by if value else _STEP * by
    digits = _DIGITS if by.is_integer() else _FINE_DIGITS
    return field.clamped(float(f"{found:.{digits}g}") / field.times)
