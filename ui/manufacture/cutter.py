"""Dialog of a ball cutter. Each entry restarts the simulation of the cut."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QWidget

from ui.background import Task
from ui.manufacture.option_fields import (
    OptionDialog,
    OptionFields,
    WorkDialog,
    keep_options,
    kept_options,
)
from ui.widgets.controls import STRETCH, filled
from ui.widgets.labels import WrappedLabel
from ui.words import capitalised, later, tr
from workbench.files.export.formats import GCODE, Format
from workbench.files.export.options import Chosen, Cutting
from workbench.files.session import Session
from workbench.powers import rounded, written

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan

_NEGLIGIBLE = 0.01  # a cut into the face of this part of the ridges' height is rounding
_ABOUT = later(
    "Writes the passes of a ball cutter as G-code in millimetres. The cut is simulated first; a "
    "cutter that leaves too much material or cuts too deep is refused."
)


def ask_options(
    window: QWidget, settings: QSettings, session: Session, found: Format
) -> Chosen | None:
    """Ask for the options of a format, starting from the last answers; None if cancelled."""
    if not found.options:
        return Chosen()
    unit = session.scene.unit
    dialog: CutterDialog | OptionDialog
    if found is GCODE:
        dialog = CutterDialog(session, kept_options(settings, unit, Cutting), window)
    else:
        kept = [kept_options(settings, unit, group) for group in found.options]
        dialog = OptionDialog(unit, kept, capitalised(found.name), window)
    try:
        if not dialog.exec():
            return None
        for options in dialog.options:
            keep_options(settings, unit, options)
        return Chosen(dialog.options, dialog.plan)
    finally:
        dialog.deleteLater()


class CutterDialog(WorkDialog):
    """Fields of a cut, and the result of its simulation."""

    def __init__(self, session: Session, begin_with: Cutting, window: QWidget) -> None:
        self._session, self._unit = session, session.scene.unit
        self.fields = OptionFields(self._unit, begin_with)
        name = later("simulation of the cut")
        super().__init__(tr("Ball cutter"), name, window)
        self.plan: CutPlan | None = None
        self._fitting = 0.0
        self.fields.changed.connect(self.simulate)
        self.state.setAccessibleName(tr("Result of the simulation"))
        self.state.setMinimumHeight(4 * self.fontMetrics().lineSpacing())
        self.state.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.fit = QPushButton()
        self.fit.clicked.connect(self._take_fitting)
        self.write = self.add_button(tr("&Write G-code…"))
        tip = tr("Compare the image of the lens as made with the lens as designed")
        self.look = self.add_button(tr("&Trace light"), tip, self.trace)
        beside = filled(QHBoxLayout(), STRETCH, self.fit)
        self.fill(WrappedLabel(tr(_ABOUT)), self.fields, self.state, beside)
        self._goes_on = False  # whether the keyboard was at the button
        self.simulate()

    @property
    def options(self) -> tuple[Cutting, ...]:
        return () if self.plan is None else (self.plan.cutting,)

    def accept(self) -> None:
        if self.plan is not None:
            super().accept()

    def simulate(self) -> None:
        self.background.cancel()
        self.plan = None
        self.write.setEnabled(False)
        self.look.setEnabled(False)
        self.fit.hide()
        if self.fields.refused:
            self.state.clear()
            return
        work = partial(_plan, self._session, self.fields.options)
        self._begin(tr("Simulating the cut: {percent} %"), work)

    def trace(self) -> None:
        if self.plan is not None:
            self._goes_on = self.look.hasFocus()
            self.look.setEnabled(False)
            working = f"{_words(self.plan, self._unit)}\n{tr('Tracing: {percent} %')}"
            self._begin(working, partial(_trace, self._session, self.plan))

    def _show_outcome(self, _: object, found: "CutPlan | str | None") -> None:
        if isinstance(found, str):
            assert self.plan is not None
            self.state.setText(f"{_words(self.plan, self._unit)}\n{found}")
        elif found is not None:
            self._judge(found)
        self._allow_trace()

    def _show_failure(self, reason: str) -> None:
        verdict = "" if self.plan is None else f"{_words(self.plan, self._unit)}\n"
        self.state.setText(f"{verdict}\N{WARNING SIGN} {reason}")
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
            self.state.setText(_words(plan, self._unit))
            return
        self.state.setText(f"\N{WARNING SIGN} {tr(refusal.reason)}")
        self._fitting = plan.default_radius
        self.fit.setText(tr("Use {radius}").format(radius=written(self._fitting, self._unit, 2)))
        self.fit.setVisible(self._fitting < plan.raster.radius)

    def _take_fitting(self) -> None:
        self.fields.enter(cutter=None, tool_radius=rounded(self._fitting, 2))


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


def _plan(session: Session, cutting: Cutting, task: Task) -> "CutPlan | None":
    from workbench.design.session import result_of  # late: take long to import
    from workbench.files.export.cut_plan import planning
    from workbench.files.export.design import Design

    design = Design(session.scene, result_of(session), options=(cutting,))
    return task.follow(planning(design), task.report)


def _trace(session: Session, plan: "CutPlan", task: Task) -> str | None:
    from workbench.analysis.making.as_made import checking  # late: takes long to import
    from workbench.design.session import result_of
    from workbench.report.figures import made_rows
    from workbench.scene.making.milling import Milling

    y = plan.raster.y
    milling = Milling(ball_radius=plan.raster.radius, step_over=float(y[1] - y[0]))
    later = (each for each in session.scene.processes if each.ball_cut is None)
    scene = session.scene.altered(processes=(milling, *later))
    steps = checking(scene, session.target, result_of(session).state.heights)
    found = task.follow(steps, task.report)
    if found is None:
        return None
    return "\n".join(capitalised(f"{tr(name)}: {tr(value)}") for name, value in made_rows(found))
