"""Figures of manufacture beside their limits, and the fields of the limits."""

import math
from dataclasses import asdict
from typing import Any, NamedTuple

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QVBoxLayout, QWidget

from ui.manufacture.option_fields import keep_options, kept_options, option_row
from ui.panels.editors import NumberEditor
from ui.panels.entries import DataForm
from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel, text_label
from ui.words import later, tr
from workbench.analysis.manufacture import Extreme, Manufacture, Verdict, verdicts
from workbench.analysis.shop_limits import Limits
from workbench.powers import written
from workbench.scene import Scene

_HINT = later("Empty: the limit of the design task. Stored for the next start.")


_STATES = later(
    {
        "met": ("✓ met", "The limit is kept everywhere."),
        "open": (
            "? not checked yet",
            ("The limit is kept at all sampled points. Proved for the whole face: {bound}."),
        ),
        "broken": ("✗ exceeded", "The limit is exceeded; the map shows where."),
    }
)
"""Sign, word and tip of each verdict."""


class _Line(NamedTuple):
    limited: str
    at_least: bool
    field: str


_LINES = {
    "thinnest": _Line("thickness", True, "min_thickness"),
    "thickest": _Line("thickness", False, "max_thickness"),
    "steepest": _Line("slope", False, "max_slope"),
    "tightest_concave": _Line("concave radius", True, "min_radius"),
    "tightest_convex": _Line("convex radius", True, ""),  # the same as that above
    "tool_radius": _Line("ball cutter", True, "min_tool_radius"),
}
_OF_FACE = later(
    {
        "steepest": ("Slope", "Largest angle between the face and a plane across the axis"),
        "tightest_concave": ("Concave radius", "Least concave radius of curvature"),
        "tightest_convex": ("Convex radius", "Least convex radius of curvature"),
        "tool_radius": (
            "Largest ball cutter",
            (
                "Radius of the largest ball cutter that fits everywhere on the face. A larger "
                "ball leaves material in hollows"
            ),
        ),
        "sag_range": ("Sag range", "Height of the highest point of the face above the lowest"),
        "draft": ("Draft", "Least angle between the face and the axis, along which a mould opens"),
    }
)
"""Figures that each freeform face has; the same limits hold for both."""
_ENTRANCE = "entrance "  # before the keys of the entrance face, and before the names of its limits
_ROUNDING = 1e-9  # what a flat face may have of slope, and of sag in its thicknesses
_NAME, _FOUND, _SIGN, _LIMIT = range(4)


class ManufactureFigures(DataForm):
    """A table of figures beside fields of their limits, with each verdict below its figure.

    An empty field means the limit of the design.
    """

    limits_changed = Signal(object)  # Limits

    def __init__(self, settings: QSettings) -> None:
        rows = [option_row(limit, about, None) for limit, about in Limits.about()]
        super().__init__(rows, {"unit": "", **asdict(Limits())}, self._keep)
        self._editors = {each.path: each.findChildren(NumberEditor)[0] for each in rows}
        for limit, about in Limits.about():
            self.row(limit).explain(f"{tr(about.tip)}. {tr(_HINT)}")
            label = tr("Limit: {label}").format(label=tr(about.title))
            self._editors[limit].setAccessibleName(label)
        self.changed.connect(self._show_limits)
        self._settings = settings
        self._own = Limits()  # of the design
        self._found: Manufacture | None = None
        self._found_unit = ""
        self._grid = grid = QGridLayout(self)
        grid.setContentsMargins(6, 4, 6, 6)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(_LIMIT, 1)
        for column, text in ((_FOUND, tr("Lens")), (_LIMIT, tr("Limit"))):
            grid.addWidget(QLabel(f"<b>{text}</b>"), 0, column)
        self.found: dict[str, QLabel] = {}
        self.states: dict[str, QLabel] = {}
        keys = (*_LINES, "sag_range", "draft")
        for row, key in enumerate(keys, 1):
            line = _LINES.get(key)
            if line is not None:
                grid.addWidget(QLabel("≥" if line.at_least else "≤"), row, _SIGN)
            if line is not None and line.field:  # one radius for hollows and humps
                field = self.row(line.field)
                grid.addWidget(field, row, _LIMIT, 2 if line.field == "min_radius" else 1, 1)
                self._add(row, key, field.label)
            else:
                self._add(row, key, _named(key))
        title, first = QLabel(f"<b>{tr('Entrance face')}</b>"), len(keys) + 1
        grid.addWidget(title, first, 0, 1, 4)
        self._of_entrance: list[QWidget] = [title]  # shown where it is freeform
        for row, key in enumerate(_OF_FACE, first + 1):
            name = _named(key)
            self._add(row, f"{_ENTRANCE}{key}", name, tr("Entrance face: {figure}"))
            self._of_entrance += [name, self.found[f"{_ENTRANCE}{key}"]]
        self.note = WrappedLabel()
        end = first + len(_OF_FACE) + 1
        grid.addWidget(self.note, end, 0, 1, 4)
        grid.setRowStretch(end + 1, 1)
        self._show_entrance(False)

    @property
    def limits(self) -> Limits:
        stated = {name: value for name, value in self.data.items() if value is not None}
        return Limits.of(asdict(self._own) | stated)

    def show_scene(self, scene: Scene) -> None:
        if self.data["unit"] != scene.unit:
            kept = kept_options(self._settings, scene.unit, Limits)
            self.data = {"unit": scene.unit, **asdict(kept)}
            self.forget()
        self._own = Limits.asked(scene, scene.optic)
        self._show_change()

    def _keep(self, data: dict[str, Any]) -> None:
        keep_options(self._settings, data["unit"], Limits.of(data))

    def _show_limits(self) -> None:
        for name, value in asdict(self._own).items():
            text = tr("none") if value is None else format(value, "g")
            self._editors[name].setPlaceholderText(text)
        self._judge()
        self.limits_changed.emit(self.limits)

    def show_found(self, found: Manufacture, unit: str) -> None:
        self._found, self._found_unit = found, unit
        for key, label in self.found.items():
            face = found.entrance if key.startswith(_ENTRANCE) else found
            figure = getattr(face, key.removeprefix(_ENTRANCE), None)
            if isinstance(figure, Extreme):
                label.setText(self._in_words(key, figure.value))
                label.setToolTip(f"<p>{self._where(key, figure)}</p>")
            elif figure is not None:
                label.setText(self._in_words(key, figure))
        self._show_entrance(found.entrance is not None)
        self.show_remark("")
        self._judge()

    def show_nothing(self) -> None:
        self._found = None
        for label in self.found.values():
            label.clear()
            label.setToolTip("")
        for key in self.states:
            self._show_state(key, None)

    def show_remark(self, sentence: str) -> None:
        """Show a remark, and grey the outdated figures; or remove both."""
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))
        for label in (*self.found.values(), *self.states.values()):
            label.setEnabled(not sentence)

    def _show_entrance(self, shown: bool) -> None:
        for part in self._of_entrance:
            part.setVisible(shown)

    def _add(self, row: int, key: str, name: QLabel, called: str = "{figure}") -> None:
        name.setWordWrap(True)
        self._grid.addWidget(name, row, _NAME)
        self.found[key] = found = QLabel()
        found.setAccessibleName(called.format(figure=name.text()))
        found.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        cell = filled(QVBoxLayout(), found, spacing=0)
        if key.removeprefix(_ENTRANCE) in _LINES:
            self.states[key] = state = QLabel()
            state.setAccessibleName(tr("Verdict: {figure}").format(figure=found.accessibleName()))
            state.hide()
            cell.addWidget(state)
        self._grid.addLayout(cell, row, _FOUND)

    def _judge(self) -> None:
        if self._found is None:
            return
        judged = {(v.name, v.at_least): v for v in verdicts(self._found, self.limits)}
        for key in self.states:
            face = _ENTRANCE if key.startswith(_ENTRANCE) else ""
            line = _LINES[key.removeprefix(face)]
            self._show_state(key, judged.get((f"{face}{line.limited}", line.at_least)))

    def _show_state(self, key: str, verdict: Verdict | None) -> None:
        text, tip = map(tr, _STATES[verdict.state] if verdict else ("", ""))
        label = self.states[key]
        label.setText(text)
        font = label.font()
        font.setBold(verdict is not None and verdict.state == "broken")
        label.setFont(font)
        if verdict is not None:
            tip = tip.format(bound=self._in_words(key, verdict.found.bound))
        label.setToolTip(f"<p>{tip}</p>" if tip else "")
        label.setVisible(verdict is not None)

    def _in_words(self, key: str, value: float) -> str:
        if math.isinf(value):
            return tr("none")
        if key.endswith(("steepest", "draft")):
            return written(0.0 if value < _ROUNDING else value, "°")
        assert self._found is not None  # or nothing is shown
        flat = key.endswith("sag_range") and value < _ROUNDING * self._found.thickest.value
        return written(0.0 if flat else value, self._found_unit)

    def _where(self, key: str, extreme: Extreme) -> str:
        if math.isinf(extreme.value):
            return tr("The face has none.")
        x, y = extreme.place
        bound = self._in_words(key, extreme.bound)
        return tr("At x = {x}, y = {y}. Proved bound: {bound}.").format(
            x=written(x, self._found_unit), y=written(y, self._found_unit), bound=bound
        )


def _named(key: str) -> QLabel:
    text, tip = map(tr, _OF_FACE[key])
    return text_label(text, tip=tip)
