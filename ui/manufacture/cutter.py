"""Dialog of a ball cutter. Each entry restarts the simulation of the cut."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from functools import partial
from typing import TYPE_CHECKING, Any

from annotated_types import Ge, Le
from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ui.background import Background, Task
from ui.panels.edits import Edit
from ui.panels.entries import RowEntries, edited_data
from ui.panels.fields import CheckRow, OptionalRow, Row, described
from ui.widgets.controls import STRETCH, filled
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.errors import Refused
from workbench.files.export.options import FEED, PLAIN, RANGES, Cutting
from workbench.powers import written
from workbench.scene import LENGTH, Measure
from workbench.scene.fields import LeftOut

if TYPE_CHECKING:
    from workbench.analysis.making.as_made import MadeStep
    from workbench.files.export.gcode import CutPlan
    from workbench.files.session import Session

_LENGTHS = later(
    {
        "tool_radius": (
            "Tool radius",
            "automatic",
            "Radius of the ball cutter. Empty: the radius of the design task, or the largest "
            "that fits everywhere.",
        ),
        "scallop": (
            "Scallop height",
            later("automatic"),
            (
                "Largest height of material between neighbouring passes. Empty: 1e-4 of the "
                "larger half-width, or more where that needs too many moves."
            ),
        ),
        "rim": ("Clamping rim", "0", "Width of stock around the lens for clamping."),
        "safe_height": (
            "Travel height",
            "the ball's diameter",
            "Height of rapid moves above the highest cut.",
        ),
    }
)
_MACHINE = later(
    {
        "feed": ("Feed", "Feed rate while cutting."),
        "plunge_feed": ("Plunge feed", "Feed rate while plunging into the stock."),
        "spindle_speed": ("Spindle speed", "Revolutions per minute, clockwise."),
        "dwell": ("Dwell", "Wait above the stock until the spindle has reached its speed."),
    }
)


class CutFields(QWidget):
    """A field for each value of a `Cutting`."""

    changed = Signal()

    def __init__(self, unit: str, begin_with: Cutting) -> None:
        super().__init__()
        self._data = {"unit": unit, **asdict(begin_with)}
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.rows = {row.path: row for row in _rows()}
        for row in self.rows.values():
            form.addRow(row.label, row)
            row.reserve_unit(FEED)
        self._entries = RowEntries(
            list(self.rows.values()), lambda: self._data, self._enter, self, form.setRowVisible
        )
        self._entries.changed.connect(self.changed)
        self._entries.show()

    @property
    def refused(self) -> bool:
        return self._entries.refused

    @property
    def cutting(self) -> Cutting:
        return _cutting(self._data)

    def enter(self, name: str, value: object) -> None:
        self._entries.edit(Edit(name, name, {name: value}))

    def _enter(self, edits: list[Edit]) -> None:
        data = edited_data(self._data, edits)
        _cutting(data)
        self._data = data


def _cutting(data: dict[str, Any]) -> Cutting:
    stated = {k: value for k, value in data.items() if k != "unit" and value is not None}
    return Cutting(**stated)


def _rows() -> Iterator[Row]:
    for name, (title, empty, tip) in _LENGTHS.items():
        length = LENGTH, LeftOut(empty)
        yield OptionalRow(described(tr(title), tr(tip), float, *length, optional=True), name)
    for name, (title, tip) in _MACHINE.items():
        least, most, unit = RANGES[name]
        marks = Measure(unit), Ge(least), Le(most), LeftOut(f"{getattr(PLAIN, name):g}")
        yield OptionalRow(described(tr(title), tr(tip), float, *marks, optional=True), name)
    tip = tr("Cut the negative of the face, turned over about the y axis.")
    yield CheckRow(described(tr("Cut a mould of the face"), tip, bool), "negative")


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


RAYS = 1_000_000
"""Through the cut; some ten seconds."""
_NEGLIGIBLE = 0.01  # a cut into the face of this part of the ridges' height is rounding
_ABOUT = later(
    "Writes a finishing pass of a ball cutter as G-code in millimetres (GRBL, LinuxCNC). The cut "
    "is simulated first; a cutter that leaves too much material or cuts too deep is refused."
)


class AskCutting:
    """Asks for the cut of a lens, starting from the last answer."""

    def __init__(self, window: QWidget, settings: QSettings) -> None:
        self._window, self._settings = window, settings

    def __call__(self, session: "Session") -> "CutPlan | None":
        """Return the planned cut; None if cancelled."""
        unit = session.scene.unit
        dialog = CutterDialog(session, kept_cutting(self._settings, unit), self._window)
        try:
            if not dialog.exec() or dialog.plan is None:
                return None
            keep_cutting(self._settings, unit, dialog.plan.cutting)
            return dialog.plan
        finally:
            dialog.deleteLater()


class CutterDialog(QDialog):
    """Fields of a cut, and the result of its simulation."""

    def __init__(self, session: "Session", begin_with: Cutting, window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle(tr("Ball cutter"))
        self._session, self._unit = session, session.scene.unit
        self.plan: CutPlan | None = None
        self._fitting = 0.0
        self.fields = CutFields(self._unit, begin_with)
        self.fields.changed.connect(self._follow)
        self.found = WrappedLabel()
        self.found.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.found.setAccessibleName(tr("Result of the simulation"))
        self.found.setMinimumHeight(4 * self.fontMetrics().lineSpacing())
        self.found.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._working = ""  # a text with the percentage that is done
        self.fit = QPushButton()
        self.fit.clicked.connect(self._take_fitting)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.write = buttons.addButton(tr("&Write G-code…"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.look = buttons.addButton(tr("&Trace light"), QDialogButtonBox.ButtonRole.ActionRole)
        self.look.setToolTip(tr("Compare the image of the lens as made with the lens as designed"))
        self.look.clicked.connect(self.trace)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        about, below = WrappedLabel(tr(_ABOUT)), filled(QHBoxLayout(), STRETCH, self.fit)
        filled(QVBoxLayout(self), about, self.fields, self.found, below, buttons)
        self.setMinimumWidth(46 * self.fontMetrics().averageCharWidth() + 120)
        self._goes_on = False  # whether the keyboard was at the button
        self._background = Background(later("simulation of the cut"), self)
        self._background.progressed.connect(self._show_progress)
        self._background.done.connect(self._show_outcome)
        self._background.failed.connect(self._show_failure)
        self.finished.connect(self._background.close)
        self.simulate()

    def simulate(self) -> None:
        self._forget()
        if self.fields.refused:
            self.found.clear()
            return
        self._begin(tr("Simulating the cut: {percent} %"))
        self._background.begin(partial(_plan, self._session, self.fields.cutting))

    def trace(self) -> None:
        if self.plan is not None:
            self._goes_on = self.look.hasFocus()
            self.look.setEnabled(False)
            self._begin(f"{_words(self.plan, self._unit)}\n{tr('Tracing: {percent} %')}")
            self._background.begin(partial(_trace, self._session, self.plan))

    def _follow(self) -> None:
        self._background.cancel()
        self.simulate()

    def _forget(self) -> None:
        self.plan = None
        self.write.setEnabled(False)
        self.look.setEnabled(False)
        self.fit.hide()

    def _begin(self, working: str) -> None:
        self._working = working
        self._show_progress(None, 0.0)

    def _show_progress(self, _: object, done: float) -> None:
        self.found.setText(self._working.format(percent=round(100 * done)))

    def _show_outcome(self, _: None, found: "CutPlan | str | None") -> None:
        if isinstance(found, str):
            assert self.plan is not None
            self.found.setText(f"{_words(self.plan, self._unit)}\n{found}")
        elif found is not None:
            self._judge(found)
        self._allow_trace()

    def _show_failure(self, reason: str) -> None:
        verdict = "" if self.plan is None else f"{_words(self.plan, self._unit)}\n"
        self.found.setText(f"{verdict}\N{WARNING SIGN} {reason}")
        self._allow_trace()

    def _allow_trace(self) -> None:
        self.look.setEnabled(self.plan is not None and not self.plan.cutting.negative)
        if self._goes_on:  # disabled, the button gave the keyboard to another one
            self.look.setFocus()
            self._goes_on = False

    def _judge(self, plan: "CutPlan") -> None:
        refusal = plan.refusal(self._unit)
        if refusal is None:
            self.plan = plan
            self.write.setEnabled(True)
            self.write.setDefault(True)
            self.found.setText(_words(plan, self._unit))
            return
        self.found.setText(f"\N{WARNING SIGN} {tr(refusal.reason)}")
        self._fitting = plan.default_radius
        self.fit.setText(tr("Use {radius}").format(radius=written(self._fitting, self._unit, 2)))
        self.fit.setVisible(self._fitting < plan.raster.radius)

    def _take_fitting(self) -> None:
        self.fields.enter("tool_radius", float(f"{self._fitting:.2g}"))

    def _accept(self) -> None:
        if self.plan is not None:
            self.accept()


def _words(plan: "CutPlan", unit: str) -> str:
    cut_off, left, _ = plan.errors
    deep = tr("Up to {cut_off} is cut too deep").format(cut_off=written(cut_off, unit, 2))
    whole = cut_off < _NEGLIGIBLE * left
    found = tr("Radius {radius}, {size:,} moves. {deep}; up to {left} of material remains.").format(
        radius=written(plan.raster.radius, unit),
        size=plan.raster.tip.size,
        left=written(left, unit, 2),
        deep=tr("Nothing is cut too deep") if whole else deep,
    )
    return f"\N{CHECK MARK} {tr('The cutter fits.')} {found}"


def words_of(steps: "Sequence[MadeStep]") -> str:
    """Errors as designed and after each process, in a sentence."""
    errors = (
        tr("{process} {error:.3g} % (± {off:.1g})").format(
            process=tr(step.title) if step.title else tr("As designed"),
            error=100 * step.error.distance,
            off=100 * step.error.off,
        )
        for step in steps
    )
    return tr("Error: {errors}.").format(errors=", ".join(errors))


def _plan(session: "Session", cutting: Cutting, task: Task) -> "CutPlan | None":
    from workbench.design.session import result_of  # late: take long to import
    from workbench.files.export.design import Design
    from workbench.files.export.gcode import planning

    design = Design(session.scene, result_of(session), cutting=cutting)
    return task.follow(planning(design), task.report)


def _trace(session: "Session", plan: "CutPlan", task: Task) -> str | None:
    from workbench.analysis.making.as_made import tracing_made  # late: takes long to import
    from workbench.design.session import result_of
    from workbench.scene.making.milling import Milling

    y = plan.raster.y
    milling = Milling(ball_radius=plan.raster.radius, step_over=float(y[1] - y[0]))
    later = (each for each in session.scene.processes if not isinstance(each, Milling))
    scene = session.scene.altered(processes=(milling, *later))
    steps = tracing_made(scene, session.target, result_of(session).state.heights, rays=RAYS)
    found = task.follow(steps, task.report)
    return None if found is None else words_of(found)
