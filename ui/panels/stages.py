"""The stages of a run: a list of them, and the settings of the one that is chosen."""

from ui.panels.fields import Changes, ChoiceRow, Row
from ui.panels.panel import Panel
from ui.panels.rows import Rows
from ui.panels.stage_list import StageListRow
from workbench.files.session import Session
from workbench.scene import FieldDescription, Stage

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
        rows = Rows(
            lambda: self.session.scene.parts()[number],
            {"method": self._method_rows},
            _AS_THE_SCENE,
            path,
        )
        return rows.of_part(Stage, path)

    def _method_rows(self, field: FieldDescription, path: str) -> list[Row]:
        """The automatic method has no learning rate."""
        rate = f"{path.rpartition('.')[0]}.learning_rate"

        def changes(choice: str) -> Changes:
            made: Changes = {path: choice or None}
            if (choice or self.session.scene.run.method) == "auto":
                made[rate] = None
            return made

        return [
            ChoiceRow(path, field.title, field.tip, field.choices, _AS_THE_SCENE, changes=changes)
        ]
