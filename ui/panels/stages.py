"""The stages of a run: a list of them, and the settings of the one that is chosen."""

from ui.panels.fields import Changes, ChoiceRow, Row
from ui.panels.listed import ListedPanel
from ui.panels.rows import Rows
from ui.panels.stage_list import StageListRow
from ui.words import later, tr
from workbench.files.session import Session
from workbench.scene import FieldDescription, Stage

_AS_THE_SCENE = later("As the scene")


class StagesPanel(ListedPanel):
    """Bound to ``scene.run.stages``."""

    def __init__(self) -> None:
        self._list = StageListRow()
        super().__init__(tr("Stages"), self._list)

    def show_list(self, session: Session) -> None:
        """List the stages of the run."""
        run = session.scene.run
        self._list.show_stages(run.stages, run.iterations)

    def name_of(self, number: int) -> str:
        """Its number, from 1."""
        return tr("Stage {number}").format(number=number + 1)

    def rows_of(self, number: int) -> list[Row]:
        """What a stage may have of its own."""
        path = f"run.stages[{number}]"
        rows = Rows(
            lambda: self.session.scene.stage_scenes()[number],
            {"method": self._method_rows},
            tr(_AS_THE_SCENE),
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
            ChoiceRow(
                path,
                tr(field.title),
                tr(field.tip),
                [(value, tr(title)) for value, title in field.choices],
                tr(_AS_THE_SCENE),
                changes=changes,
            )
        ]
