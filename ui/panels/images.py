"""Target of the first image, the list of all images, and the list of regions."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.panels.crop import grey_image
from ui.panels.edits import Edit
from ui.panels.fields import Row
from ui.panels.panel import ListedPanel, PartPanel, another_name
from ui.panels.rows import Rows
from ui.panels.text_rows import PairsRow
from ui.widgets.controls import STRETCH, filled, push_button
from ui.widgets.native import ScaledImage
from ui.words import error_text, in_sentence, later, tr
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.powers import rounded, written
from workbench.scene import (
    AnyRegion,
    FieldDescription,
    Finish,
    Image,
    ImageTarget,
    RectangleRegion,
    Scene,
)
from workbench.scene.image import as_viewed
from workbench.scene.part import title_of
from workbench.units import sized

_ENDINGS = (
    "*.png *.jpg *.jpeg *.heic *.heif *.avif *.svg *.svgz *.bmp *.gif *.tif *.tiff *.webp *.pgm "
    "*.ppm *.jp2 *.tga *.exr *.hdr *.npy"
)
_OF_LIGHT = ".npy", ".exr", ".hdr"  # whose numbers are light itself

_HEIGHT = 96  # logical pixels of a thumbnail


def image_files() -> str:
    """File filter of images."""
    return tr("Images ({endings});;All files (*)").format(endings=_ENDINGS)


def is_image_file(path: Path) -> bool:
    """Whether a file is an image, by its name."""
    return f"*{path.suffix.lower()}" in _ENDINGS.split()


class TargetPanel(PartPanel):
    """Bound to the target of the first image."""

    refused = Signal(str)

    def __init__(self, field: FieldDescription) -> None:
        dropped = tr("An image file can also be dropped onto the window.")
        super().__init__(replace(field, tip=f"{tr(field.tip)} {dropped}"), "images[0].target")
        self._thumbnail = Thumbnail()
        self._tools = QWidget()
        tip = tr("Choose the part of the picture that is used, and its levels")
        adjust = push_button(tr("Crop and tone…"), tip, self.adjust)
        turn = push_button(tr("Turn"), tr("Turn the picture by a quarter to the right"), self.turn)
        filled(QHBoxLayout(self._tools), STRETCH, adjust, turn, STRETCH, margins=0)
        self._form.insertRow(0, self._tools)
        self._form.insertRow(0, self._thumbnail)

    def prepare(self, session: Session) -> None:
        super().prepare(session)
        r_u, r_v = session.scene.receiver.half_extent
        self._thumbnail.show_target(as_viewed(session.scene, session.target), r_u / r_v)
        self._form.setRowVisible(self._tools, session.scene.target.file is not None)

    def adjust(self) -> None:
        """Ask which part of the picture is used, and for its levels."""
        from ui.panels.picture_dialog import PictureDialog  # late: takes long to import
        from workbench.targets import stored_picture

        scene = self.session.scene
        if not isinstance(scene.target, ImageTarget):  # or there is no such button
            return
        try:
            picture = stored_picture(scene.target, self.session.picture)
        except Refused as refused:
            self.refused.emit(error_text(refused))
            return
        dialog = PictureDialog(picture, scene, self.path, self)
        if dialog.exec() and dialog.changes:
            self._change(tr("crop and tone of the picture"), dialog.changes)
        dialog.deleteLater()

    def turn(self) -> None:
        """Turn the picture by a quarter to the right."""
        target = self.session.scene.target
        if isinstance(target, ImageTarget):
            turned = {"none": "right", "right": "around", "around": "left", "left": "none"}
            self._change(tr("turn of the picture"), {"turn": turned[target.turn]})

    def _change(self, text: str, fields: Mapping[str, object]) -> None:
        changes = {f"{self.path}.{field}": value for field, value in fields.items()}
        self.edited.emit(Edit(next(iter(changes)), text, changes, waits=False))


def of_image(path: Path, before: Finish) -> dict[str, object]:
    """Return plain data of an image target with the finish of another target."""
    finish = {name: getattr(before, name) for name in Finish.model_fields}
    tone = "linear" if path.suffix.lower() in _OF_LIGHT else "srgb"
    return {"image": str(path.absolute()), "tone": tone, **finish}


class Thumbnail(ScaledImage):
    """The target in grey levels."""

    def __init__(self, height: int = _HEIGHT) -> None:
        super().__init__()
        self.setFixedHeight(height)
        self.setToolTip(tr("Target irradiance as its viewer sees it"))
        self.setAccessibleName(tr("Target image"))

    def show_target(self, target: Array, aspect: float) -> None:
        """Show an image (n_y, n_x) with an aspect ratio; its peak is white."""
        self.show_image(grey_image(target), aspect)


_FARTHER = 1.2  # times as far from the lens as the receiver before


class ImagesPanel(ListedPanel[Image]):
    """Bound to ``scene.images``; receiver and target of the first one have panels of their own."""

    _CALLED, _NAMED = later("image"), later("Image {number}")

    def __init__(self, field: FieldDescription) -> None:
        add = tr("Add an image farther away, with the target of the last one")
        super().__init__(field, {tr("Add"): add})

    def remark(self, scene: Scene) -> str:
        of_first = tr("The panels Target and Receiver belong to image 1.")
        return of_first if len(scene.images) > 1 else ""

    def new(self, which: int) -> Image:
        scene = self.session.scene
        last, near = scene.images[-1], scene.optic.leaving_z
        receiver = last.receiver
        if receiver.at_distance:
            away = _FARTHER * (receiver.plane_z - near)
            receiver = receiver.moved_to(rounded(near + away, 6))
        return Image(receiver=receiver, target=last.target)

    def summary(self, part: Image) -> str:
        receiver = part.receiver
        place = f"z = {receiver.plane_z:.6g}" if receiver.at_distance else tr(receiver.called)
        return tr("{place}, {target}, weight {weight:g}").format(
            place=place, target=in_sentence(tr(title_of(type(part.target)))), weight=part.weight
        )

    def rows_of(self, number: int) -> list[Row]:
        """Receiver, target and weight of an image; the weight alone of the first one."""
        path = f"images[{number}]"
        rows = Rows(lambda: self.session.scene.single[number], stage=path, place="images[0]")
        fields = Image.fields() if number else Image.fields()[-1:]
        made = [row for field in fields for row in rows.of_field(field, f"{path}.{field.name}")]
        if number == 0:
            made[0].only_if(lambda scene: len(scene.images) > 1)
        return made


def _corner_rows(field: FieldDescription, path: str) -> list[Row]:
    tip = f"{tr(field.tip)} {tr('As x, y; x, y; …')}"
    return [PairsRow(replace(field, tip=tip), path)]


class RegionsPanel(ListedPanel[AnyRegion]):
    """Bound to ``scene.regions``."""

    _CALLED, _NAMED, _NONE = later("region"), later("Region {number}"), later("None.")
    _KIND, _OWN = later("Shape"), {"corners": _corner_rows}

    def __init__(self, field: FieldDescription) -> None:
        add = {tr("Add"): tr("Add a region in the middle")}
        super().__init__(field, add, listed=later("Regions"))

    def new(self, which: int) -> AnyRegion:
        count = len(self.session.scene.regions) + 1
        return RectangleRegion(name=tr("Region {count}").format(count=count))

    def copy(self, part: AnyRegion) -> AnyRegion:
        taken = (region.name for region in self.session.scene.regions)
        return part.model_copy(update={"name": another_name(part.name, taken, " ")})

    def summary(self, part: AnyRegion) -> str:
        scene = self.session.scene
        low, high = part.outline.min(axis=0), part.outline.max(axis=0)
        width, height = (high - low) * scene.receiver.half_extent * 2
        unit = scene.receiver.measure.sign_in(scene.unit)
        size = sized(f"{written(width)} × {written(height)}", unit)
        return f"{part.name}: {in_sentence(tr(title_of(type(part))))}, {size}"
