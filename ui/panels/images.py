"""The further images of a scene: a list of them, and the settings of the one that is chosen."""

from pathlib import Path
from typing import Any

from PySide6.QtCore import Signal

from ui.panels.edits import Edit, value_at
from ui.panels.fields import Changes, Row, TextRow
from ui.panels.image_list import ImageListRow
from ui.panels.listed import ListedPanel
from ui.panels.receiver import ChoiceOfReceiver, receiver_kinds
from ui.panels.rows import KindRow, Rows
from ui.panels.target import image_rows, of_image
from ui.words import tr
from workbench.files.session import Session
from workbench.scene import FieldDescription, FurtherImage


class ImagesPanel(ListedPanel):
    """Bound to ``scene.further_images``.

    Attributes
    ----------
    image_asked : Signal()
        A person wants to choose an image file for the target of the chosen image.
    """

    image_asked = Signal()

    def __init__(self, field: FieldDescription) -> None:
        self._list = ImageListRow(tr("Elsewhere"), tr(field.tip))
        super().__init__(tr(field.title), self._list)

    def show_list(self, session: Session) -> None:
        """List the further images of the scene."""
        self._list.show_images(session.scene)

    def name_of(self, number: int) -> str:
        """Its number; the scene's own image is the first."""
        return tr("Image {number}").format(number=number + 2)

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target of the chosen image."""
        before = self.session.scene.further_images[self._bound].target
        where = f"{self._path}.target"
        changes: Changes = {where: of_image(path, before)}
        self.edited.emit(
            Edit(f"{where}.image", tr("change of target image"), {**changes}, waits=False)
        )

    @property
    def _path(self) -> str:
        return f"further_images[{self._bound}]"

    def rows_of(self, number: int) -> list[Row]:
        """Receiver, target and weight of an image."""
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
