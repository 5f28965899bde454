"""The target: an image file or a built-in shape, and what is done to it."""

from collections.abc import Set
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPoint, QRect, QSize, QSizeF, Signal
from PySide6.QtGui import QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.panels.edits import Edit
from ui.panels.fields import Row, TextRow
from ui.panels.panel import PartPanel
from ui.panels.rows import KindRow, Make
from ui.words import tr
from workbench.arrays import Array
from workbench.design.picture import LARGEST_PICTURE
from workbench.files.session import Session
from workbench.scene import FieldDescription, Finish
from workbench.scene.viewing import as_viewed
from workbench.targets.colour import SRGB

_ENDINGS = (
    "*.png *.jpg *.jpeg *.heic *.heif *.avif *.svg *.svgz *.bmp *.gif *.tif *.tiff *.webp "
    "*.pgm *.ppm *.jp2 *.tga *.exr *.hdr *.npy"
)
_OF_LIGHT = ".npy", ".exr", ".hdr"  # whose numbers are light itself

_HEIGHT = 110  # logical pixels of a thumbnail


def image_files() -> str:
    """Names of files of images, as dialogs take them."""
    return tr("Images ({endings});;All files (*)").format(endings=_ENDINGS)


def is_image_file(path: Path) -> bool:
    """Whether a file is an image, by its name."""
    return f"*{path.suffix.lower()}" in _ENDINGS.split()


class TargetPanel(PartPanel):
    """Bound to the target of the first image.

    Attributes
    ----------
    image_asked : Signal()
        A person wants to choose an image file.
    image_again : Signal()
        The image file of the target was chosen again.
    """

    image_asked = Signal()
    image_again = Signal()

    def __init__(self, field: FieldDescription) -> None:
        dropped = tr("An image file can also be dropped onto the window.")
        super().__init__(replace(field, tip=f"{tr(field.tip)} {dropped}"), "images[0].target")
        for row in self.rows:
            if isinstance(row, KindRow | TextRow):
                row.asked.connect(lambda *_: self.image_asked.emit())
        self._thumbnail = Thumbnail()
        self._form.insertRow(0, self._thumbnail)

    def own_rows(self) -> dict[str, Make]:
        """A file can be looked for."""
        return {"image": image_rows}

    def show_session(self, session: Session, present: Set[Row], pending: Set[str]) -> None:
        """Show the target's settings and the image itself."""
        super().show_session(session, present, pending)
        r_u, r_v = session.scene.receiver.half_extent
        self._thumbnail.show_target(as_viewed(session.scene, session.target), r_u / r_v)

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target; the one that it is already is read again."""
        if self.session.scene.image == str(path.absolute()):
            self.image_again.emit()
            return
        target = of_image(path, self.session.scene.target)
        text, changes = tr("change of target image"), {self.path: target}
        self.edited.emit(Edit(f"{self.path}.image", text, {**changes}, waits=False))


def of_image(path: Path, before: Finish) -> dict[str, object]:
    """A target of an image file, finished as the one before."""
    finish = {name: getattr(before, name) for name in Finish.model_fields}
    tone = "linear" if path.suffix.lower() in _OF_LIGHT else "srgb"
    return {"image": str(path.absolute()), "tone": tone, **finish}


def image_rows(field: FieldDescription, path: str) -> list[Row]:
    """A row in which a file can be looked for."""
    kept = tr("The design keeps images of up to {largest} MB.").format(
        largest=LARGEST_PICTURE >> 20
    )
    return [TextRow(path, tr(field.title), f"{tr(field.tip)} {kept}", tr("Choose an image file"))]


class Thumbnail(QWidget):
    """The target in greys, also while the form is closed.

    Parameters
    ----------
    height : int
        Logical pixels.
    """

    def __init__(self, height: int = _HEIGHT) -> None:
        super().__init__()
        self._picture, self._aspect = QImage(), 1.0
        self.setFixedHeight(height)
        self.setToolTip(tr("The light that is wanted on the screen, as its viewer sees it"))
        self.setAccessibleName(tr("Target image"))

    def show_target(self, target: Array, aspect: float) -> None:
        """Show an image (n_y, n_x), its brightest pixel white, on a screen of this aspect."""
        # As much light of the monitor for each pixel as there is on the screen.
        greys = (255 * SRGB.stored(target / target.max())).round().astype(np.uint8, order="C")
        self._aspect = aspect
        rows, columns = greys.shape
        view = QImage(greys.data, columns, rows, columns, QImage.Format.Format_Grayscale8)
        self._picture = view.copy()  # the array is gone after this
        self.update()

    def clear(self) -> None:
        """Show no image."""
        self._picture = QImage()
        self.update()

    @property
    def place(self) -> QRect:
        """Where the picture is: as large as fits, centred."""
        width, height = float(self.width()), float(self.height())
        size = QSizeF(min(width, height * self._aspect), min(height, width / self._aspect))
        place = QRect(QPoint(0, 0), size.toSize().expandedTo(QSize(1, 1)))
        place.moveCenter(self.rect().center())
        return place

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the picture."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(self.place, self._picture)
        painter.end()
