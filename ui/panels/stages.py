"""The stages of a run: a list of them, and the settings of the one that is chosen."""

from typing import Any

from ui.panels.edits import value_at
from ui.panels.fields import ChoiceRow, NumberRow, Row
from ui.panels.light import filter_rows
from ui.panels.optional import OptionalRow
from ui.panels.panel import Panel
from ui.panels.run import METHODS, RATE_TIP
from ui.panels.source import source_rows
from ui.panels.stage_list import StageListRow
from workbench.files.session import Session
from workbench.scene.run import LEARNING_RATES

_AS_THE_SCENE = "As the scene"


class StagesPanel(Panel):
    """Bound to ``scene.run.stages``."""

    def __init__(self) -> None:
        self._list = StageListRow()
        self._bound = -1  # the stage whose rows are there
        super().__init__("Stages", [self._list])
        self._list.chosen.connect(self._choose)

    def prepare(self, session: Session) -> None:
        """Have rows for the chosen stage, if there is one."""
        self._session = session
        stages = session.scene.run.stages
        self._list.show_stages(stages, session.scene.run.iterations)
        self._bind(self._list.current)

    def _choose(self) -> None:
        """Show another stage; what was refused in the one before is taken back."""
        self._bind(self._list.current)
        self.reverted.emit(self._list.path)

    def _bind(self, number: int) -> None:
        if number == self._bound:
            return
        self._remove_rows(list(self.rows[1:]))
        self._bound = number
        if number >= 0:
            self._add_rows(self._rows_of(number), f"Stage {number + 1}")

    def _rows_of(self, number: int) -> list[Row]:
        path = f"run.stages[{number}]"
        return [
            NumberRow(
                f"{path}.iterations",
                "Iterations",
                "Upper limit of iterations of this stage. They count within those of the run; "
                "what all stages leave is for the scene itself.",
                whole=True,
            ),
            ChoiceRow(
                f"{path}.method",
                "Method",
                "How the lens is searched for in this stage.",
                [("", _AS_THE_SCENE), *METHODS],
                read=lambda data: value_at(data, f"{path}.method") or "",
                changes=lambda choice: self._change_method(path, choice),
            ),
            OptionalRow(
                f"{path}.learning_rate",
                "Learning rate",
                RATE_TIP + " Left empty, it is that of the scene.",
                lambda data: [_rate(data)],
                present=lambda data: _method(data, path) == "paper",
            ),
            OptionalRow(
                f"{path}.control_points",
                "Control points",
                "Numbers of control points along x and y in this stage. A coarse net moves light "
                "over long distances soon; the next stage goes on with the same surface on a "
                "finer one. Left empty, they are the lens's.",
                lambda data: data["lens"]["control_points"],
                between="×",
                whole=True,
            ),
            *source_rows(
                f"{path}.source",
                lambda: self.session.scene.parts()[number],
                "Source",
                _AS_THE_SCENE,
            ),
            *filter_rows(f"{path}.filter", "Image filter", _AS_THE_SCENE),
        ]

    def _change_method(self, path: str, choice: str) -> dict[str, object]:
        changes: dict[str, object] = {f"{path}.method": choice or None}
        if (choice or self.session.scene.run.method) == "auto":  # which has no learning rate
            changes[f"{path}.learning_rate"] = None
        return changes


def _method(data: dict[str, Any], path: str) -> str:
    return str(value_at(data, f"{path}.method") or data["run"]["method"])


def _rate(data: dict[str, Any]) -> float:
    run = data["run"]
    return float(run.get("learning_rate", LEARNING_RATES[run.get("parametrisation", "none")]))
