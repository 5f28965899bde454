"""The wish: an image file or a built-in shape, and what is done to it."""

from pathlib import Path

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPoint, QRect, QSize, QSizeF, Signal
from PySide6.QtGui import QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.panels.edits import Edit
from ui.panels.fields import Changes, CheckRow, ChoiceRow, NumberRow, TextRow
from ui.panels.panel import Panel
from workbench.design.picture import LARGEST_PICTURE
from workbench.files.session import Session
from workbench.scene import Finish

IMAGE_FILES = (
    "Images (*.png *.jpg *.jpeg *.svg *.bmp *.gif *.tif *.tiff *.webp *.pgm *.ppm *.jp2 *.tga "
    "*.npy);;All files (*)"
)

_WISH = "target.builtin"


class TargetPanel(Panel):
    """Bound to ``scene.target``.

    Attributes
    ----------
    image_asked : Signal()
        A person wants to choose an image file.
    image_again : Signal()
        The image file of the target was chosen again.
    """

    image_asked = Signal()
    image_again = Signal()

    def __init__(self) -> None:
        image = TextRow(
            "target.image",
            "Image",
            "Image file; bright pixels get much light, black ones and transparent ones none. "
            "Where all that is drawn is black, as in many a logo on a transparent ground, the "
            "drawing itself gets the light. It is fitted into the screen with its aspect kept. The "
            f"design keeps images of up to {LARGEST_PICTURE >> 20} MB.",
            "Choose an image file",
        )
        super().__init__(
            "Target",
            [
                ChoiceRow(
                    _WISH,
                    "Kind",
                    "The image that the light shall draw on the screen. "
                    "An image file can also be dropped onto the window.",
                    [
                        ("image", "Image file"),
                        ("tophat", "Top hat"),
                        ("flame", "Flame"),
                        ("ball", "Ball"),
                    ],
                    read=lambda data: data["target"].get("builtin", "image"),
                    changes=self._change_kind,
                ),
                image,
                NumberRow(
                    "target.radius",
                    "Radius",
                    "Radius of the shape as a fraction of the screen's smaller half-width.",
                    "of half width",
                ),
                NumberRow(
                    "target.height",
                    "Height",
                    "Height of the shape as a fraction of the screen's smaller width.",
                    "of width",
                ),
                NumberRow(
                    "target.padding",
                    "Padding",
                    "Black border on each side as a fraction of the screen; it keeps light "
                    "away from the edge.",
                    "of width",
                ),
                NumberRow(
                    "target.blur",
                    "Blur",
                    "Standard deviation of a Gaussian over the target. Soft edges are "
                    "easier for a smooth lens.",
                    "px",
                ),
                CheckRow("target.invert", "Invert", "Swap bright and dark."),
            ],
        )
        image.asked.connect(self.image_asked)
        self._thumbnail = Thumbnail()
        self._form.insertRow(0, self._thumbnail)

    def show_session(self, session: Session, pending: set[str]) -> None:
        """Show the target's settings and the image itself."""
        super().show_session(session, pending)
        screen = session.scene.screen
        self._thumbnail.show_target(session.target, screen.half_width[0] / screen.half_width[1])

    def _change_kind(self, choice: str) -> Changes | None:
        if choice == "image":
            self.image_asked.emit()
            return None
        return {"target": {"builtin": choice, **self._finish()}}

    def _finish(self) -> dict[str, object]:
        target = self.session.scene.target
        return {name: getattr(target, name) for name in Finish.model_fields}

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target; the one that it is already is read again."""
        if self.session.scene.image == str(path.absolute()):
            self.image_again.emit()
            return
        target = {"image": str(path.absolute()), **self._finish()}
        edit = Edit("target.image", "change of target image", {"target": target}, waits=False)
        self.edited.emit(edit)


class Thumbnail(QWidget):
    """The target in greys, also while the form is closed."""

    _HEIGHT = 110

    def __init__(self) -> None:
        super().__init__()
        self._picture, self._aspect = QImage(), 1.0
        self.setFixedHeight(self._HEIGHT)
        self.setToolTip("The light that is wished for on the screen")
        self.setAccessibleName("Target image")

    def show_target(self, target: npt.NDArray[np.float64], aspect: float) -> None:
        """Show an image (n_y, n_x), its brightest pixel white, on a screen of this aspect."""
        greys = (255 * (target / target.max())).astype(np.uint8, order="C")
        self._aspect = aspect
        rows, columns = greys.shape
        view = QImage(greys.data, columns, rows, columns, QImage.Format.Format_Grayscale8)
        self._picture = view.copy()  # the array is gone after this
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
