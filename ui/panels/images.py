"""The further images of a scene: a list of them, and the settings of the one that is chosen."""

from pathlib import Path
from typing import Any

from PySide6.QtCore import Signal

from ui.panels.edits import Edit, value_at
from ui.panels.fields import Changes, Row, TextRow
from ui.panels.image_list import ImageListRow
from ui.panels.panel import Panel
from ui.panels.receiver import ChoiceOfReceiver, receiver_kinds
from ui.panels.rows import KindRow, Rows
from ui.panels.target import image_rows
from workbench.files.session import Session
from workbench.scene import FieldDescription, Finish, FurtherImage


class ImagesPanel(Panel):
    """Bound to ``scene.further_images``.

    Parameters
    ----------
    field : FieldDescription
        The field of the scene that holds them.

    Attributes
    ----------
    image_asked : Signal()
        A person wants to choose an image file for the target of the chosen image.
    """

    image_asked = Signal()

    def __init__(self, field: FieldDescription) -> None:
        self._list = ImageListRow("Elsewhere", field.tip)
        self._bound = -1  # the image whose rows are there
        super().__init__(field.title, [self._list])
        self._list.chosen.connect(self._choose)

    def prepare(self, session: Session) -> None:
        """Have rows for the chosen image, if there is one."""
        self._session = session
        self._list.show_images(session.scene)
        self._bind(self._list.current)

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target of the chosen image."""
        target = self.session.scene.further_images[self._bound].target
        finish = {name: getattr(target, name) for name in Finish.model_fields}
        where = f"{self._path}.target"
        changes: Changes = {where: {"image": str(path.absolute()), **finish}}
        self.edited.emit(Edit(f"{where}.image", "change of target image", {**changes}, waits=False))

    @property
    def _path(self) -> str:
        return f"further_images[{self._bound}]"

    def _choose(self) -> None:
        """Show another image; what was refused in the one before is taken back."""
        self._bind(self._list.current)
        self.reverted.emit(self._list.path)

    def _bind(self, number: int) -> None:
        if number == self._bound:
            return
        self._remove_rows(list(self.rows[1:]))
        self._bound = number
        if number >= 0:
            self._add_rows(self._rows_of(number), f"Image {number + 2}")

    def _rows_of(self, number: int) -> list[Row]:
        path = self._path
        rows = Rows(
            lambda: self.session.scene.single[number + 1], {"image": image_rows}, stage=path
        )
        fields = {field.name: field for field in FurtherImage.fields()}
        receivers = [fields.pop("screen"), fields.pop("far_field")]

        def change(name: str) -> Changes | None:
            return self._receiver(receivers, number, name)

        made: list[Row] = [ChoiceOfReceiver(receivers, change, path)]
        for field in receivers:
            made += rows.of_part(field.parts[0], f"{path}.{field.name}")
        for field in fields.values():
            made += rows.of_field(field, f"{path}.{field.name}")
        for row in made:
            if isinstance(row, KindRow | TextRow):
                row.asked.connect(lambda *_: self.image_asked.emit())
        return made

    def _receiver(self, fields: list[FieldDescription], number: int, name: str) -> Changes | None:
        """A receiver of another kind."""
        scene = self.session.scene
        if value_at(scene, f"{self._path}.{name}") is not None:
            return None
        kind = receiver_kinds(fields)[name]
        made: dict[str, Any] = kind.model_validate(
            kind.defaults_for(scene.single[number + 1])
        ).model_dump(mode="json", exclude_none=True)
        changes: Changes = {f"{self._path}.{field.name}": None for field in fields}
        return changes | {f"{self._path}.{name}": made}
