"""Dialog of a shop's plans: step-over and polishing for a wanted error as made."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from ui.background import Task
from ui.manufacture.option_fields import OptionFields, WorkDialog
from ui.panels.edits import Edit
from ui.widgets.controls import Table
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.analysis.making.plan_options import PlanOptions
from workbench.files.session import Session
from workbench.powers import written

if TYPE_CHECKING:
    from workbench.analysis.making.plan import ShopPlan, ShopPlans

_COLUMNS = later(("Step-over", "Scallop", "Polish over", "Error as made", "Minutes"))
_ABOUT = later(
    "Milling leaves scallops, and polishing removes them and fine details of the lens. These plans "
    "reach the wanted error; the first takes the least time and is verified by random rays."
)
_ROWS = 12  # lines of text that the table is at least high


class PlanDialog(WorkDialog):
    """Finds plans for a lens; ``choose`` gets the edit that makes the lens by one of them."""

    def __init__(self, session: Session, choose: Callable[[Edit], object], window: QWidget) -> None:
        self.fields = OptionFields(session.scene.unit, PlanOptions())
        title, name = tr("Plan milling and polishing"), later("search for plans")
        super().__init__(title, name, window)
        self._session, self._choose = session, choose
        self._plans: tuple[ShopPlan, ...] = ()
        self.fields.changed.connect(self._allow)
        self.state.setAccessibleName(tr("Result of the search"))
        self.table = Table(tr("Plans"), len(_COLUMNS))
        self.table.setHorizontalHeaderLabels([tr(title) for title in _COLUMNS])
        self.table.setMinimumHeight(_ROWS * self.fontMetrics().lineSpacing())
        self.table.itemSelectionChanged.connect(self._allow)
        tip = tr("Enter these processes; Continue then designs for them")
        self.use = self.add_button(tr("&Use this plan"), tip)
        self.again = self.add_button(tr("&Find plans"), act=self.search)
        self.fill(WrappedLabel(tr(_ABOUT)), self.fields, self.state, (self.table, 1))
        self.resize(72 * self.fontMetrics().averageCharWidth(), self.sizeHint().height())
        self.search()

    def search(self) -> None:
        self._show_plans(())
        work = partial(_plans, self._session, self.fields.options)
        self._begin(tr("Comparing plans: {percent} %"), work)

    def accept(self) -> None:
        plan = self._plans[self.table.currentRow()]
        data = [process.model_dump(mode="json") for process in plan.processes]
        self._choose(Edit("processes", tr("plan of manufacture"), {"processes": data}, alone=True))
        super().accept()

    def _show_outcome(self, _: object, found: "ShopPlans | None") -> None:
        if found is not None:
            self.state.setText(
                tr(
                    "Error as designed {designed:.2f} %, wanted as made {wanted:.2f} %; ball "
                    "radius {radius}."
                ).format(
                    designed=100 * found.designed,
                    wanted=100 * found.wanted,
                    radius=written(found.plans[0].milling.ball_radius, self._session.scene.unit),
                )
            )
            self._show_plans(found.plans)

    def _show_plans(self, plans: "tuple[ShopPlan, ...]") -> None:
        self._plans, unit = plans, self._session.scene.unit
        rows: list[Sequence[str]] = []
        for plan in plans:
            polish = "–" if plan.polishing is None else written(plan.polishing.width, unit)
            about = "≈ " if rows else ""
            texts = (
                written(plan.milling.step_over, unit),
                written(plan.milling.scallop, unit, 2),
                polish,
                f"{about}{100 * plan.error:.2f} %",
                f"{plan.minutes:.0f}",
            )
            rows.append(texts)
        self.table.fill(rows)
        if plans:
            self.table.selectRow(0)
        self._allow()

    def _allow(self) -> None:
        self.again.setEnabled(not self.fields.refused)
        self.use.setEnabled(bool(self._plans) and self.table.currentRow() >= 0)


def _plans(session: Session, options: PlanOptions, task: Task) -> "ShopPlans | None":
    from workbench.analysis.making.plan import planning  # slow import
    from workbench.design.session import result_of

    heights = result_of(session).state.heights
    steps = planning(session.scene, session.target, heights, options)
    return task.follow(steps, task.report)
