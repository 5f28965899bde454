"""The panel of what concerns the whole scene."""

from ui.panels.edits import Edit
from ui.panels.fields import Changes, ChoiceRow, Row
from ui.panels.panel import Panel
from ui.panels.rows import Rows
from ui.words import tr
from workbench.scene import FieldDescription, Scene


class ScenePanel(Panel):
    """Bound to what concerns the whole scene."""

    def __init__(self) -> None:
        rows = Rows(lambda: self.session.scene, {"unit": _unit_rows})
        fields = [field for field in Scene.fields() if field.tip and not field.parts]
        super().__init__(
            tr("Scene"), [row for field in fields for row in rows.of_field(field, field.name)]
        )


def _unit_rows(field: FieldDescription, path: str) -> list[Row]:
    units = [(unit, unit) for unit, _ in field.choices]  # in small letters
    return [_UnitRow(path, tr(field.title), tr(field.tip), units)]


class _UnitRow(ChoiceRow):
    """The unit of length; a choice converts all lengths."""

    def _tell(self, path: str, changes: Changes) -> None:
        # A step of its own: from unit to unit, rounding adds up, and the scene would be another.
        unit = self.chooser.currentData()
        self.edited.emit(Edit(path, tr("change of unit"), {}, alone=True, unit=unit))
