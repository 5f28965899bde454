"""The images of a scene: a list of them, and the settings of the one that is chosen."""

from pathlib import Path

from PySide6.QtCore import Signal

from ui.panels.edits import Edit
from ui.panels.fields import Row, TextRow
from ui.panels.image_list import ImageListRow
from ui.panels.listed import ListedPanel
from ui.panels.rows import KindRow, Rows
from ui.panels.target import image_rows, of_image
from ui.words import tr
from workbench.files.session import Session
from workbench.scene import FieldDescription, Image, Scene


class ImagesPanel(ListedPanel):
    """Bound to ``scene.images``; receiver and target of the first one have panels of their own.

    Attributes
    ----------
    image_asked : Signal()
        A person wants to choose an image file for the target of the chosen image.
    """

    image_asked = Signal()

    def __init__(self, field: FieldDescription) -> None:
        self._list = ImageListRow(tr(field.title), tr(field.tip))
        super().__init__(tr(field.title), self._list)

    def show_list(self, session: Session) -> None:
        """List the images of the scene."""
        self._list.show_images(session.scene)

    def name_of(self, number: int) -> str:
        """Its number, from 1."""
        return tr("Image {number}").format(number=number + 1)

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target of the chosen image."""
        where = f"images[{self._bound}].target"
        target = of_image(path, self.session.scene.images[self._bound].target)
        text = tr("change of target image")
        self.edited.emit(Edit(f"{where}.image", text, {where: target}, waits=False))

    def rows_of(self, number: int) -> list[Row]:
        """Receiver, target and weight of an image; the weight alone of the first one."""
        path = f"images[{number}]"
        rows = Rows(
            lambda: self.session.scene.single[number],
            {"image": image_rows},
            stage=path,
            place="images[0]",
        )
        fields = Image.fields() if number else Image.fields()[-1:]
        made = [row for field in fields for row in rows.of_field(field, f"{path}.{field.name}")]
        if number == 0:
            made[0].only_if(_several)
        for row in made:
            if isinstance(row, KindRow | TextRow):
                row.asked.connect(lambda *_: self.image_asked.emit())
        return made


def _several(scene: Scene) -> bool:
    return len(scene.images) > 1
