"""The wish: an image file or a built-in shape, and what is done to it."""

from pathlib import Path

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage, QPixmap, QResizeEvent
from PySide6.QtWidgets import QFileDialog, QLabel, QSizePolicy

from ui.panels.edits import Edit
from ui.panels.fields import Changes, CheckRow, ChoiceRow, NumberRow, TextRow
from ui.panels.panel import Panel
from workbench.files.session import Session
from workbench.scene import Finish

IMAGE_FILES = (
    "Images (*.png *.jpg *.jpeg *.bmp *.gif *.tif *.tiff *.webp *.pgm *.ppm *.npy);;All files (*)"
)

_WISH = "target.builtin"


class TargetPanel(Panel):
    """Bound to ``scene.target``."""

    def __init__(self) -> None:
        image = TextRow(
            "target.image",
            "Image",
            "Image file; bright pixels get much light, black ones none. It is fitted into the "
            "screen with its aspect kept.",
            "Choose an image file",
        )
        image.asked.connect(self._browse)
        super().__init__(
            "Target",
            [
                ChoiceRow(
                    _WISH,
                    "Wish",
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
        self._thumbnail = Thumbnail()
        self._form.insertRow(0, self._thumbnail)

    def show_session(self, session: Session, pending: set[str]) -> None:
        """Show the target's settings and the image itself."""
        super().show_session(session, pending)
        self._thumbnail.show_target(session.target)

    def _change_kind(self, choice: str) -> Changes | None:
        if choice == "image":
            self._browse()
            return None
        return {"target": {"builtin": choice, **self._finish()}}

    def _finish(self) -> dict[str, object]:
        target = self.session.scene.target
        return {name: getattr(target, name) for name in Finish.model_fields}

    def _browse(self) -> None:
        chosen, _ = QFileDialog.getOpenFileName(self, "Target image", "", IMAGE_FILES)
        if chosen:
            self.choose_image(Path(chosen))

    def choose_image(self, path: Path) -> None:
        """Ask for an image file as the target."""
        target = {"image": str(path.absolute()), **self._finish()}
        # Where the scene has no image so far, a refusal stands beside the choice of the wish.
        path = "target.image" if "image" in self.session.scene.to_data()["target"] else _WISH
        self.edited.emit(Edit(path, "change of target image", {"target": target}))


class Thumbnail(QLabel):
    """The target in greys, as large as the form is wide but not higher than a hand."""

    _HEIGHT = 110

    def __init__(self) -> None:
        super().__init__()
        self._picture = QPixmap()
        self.setFixedHeight(self._HEIGHT)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setToolTip("The light that is wished for on the screen")
        self.setAccessibleName("Target image")

    def show_target(self, target: npt.NDArray[np.float64]) -> None:
        """Show an image (n_y, n_x), its brightest pixel white."""
        greys = np.ascontiguousarray(target * (255 / target.max())).astype(np.uint8)
        rows, columns = greys.shape
        image = QImage(greys.data, columns, rows, columns, QImage.Format.Format_Grayscale8)
        self._picture = QPixmap.fromImage(image)  # copies the array
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the picture again."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        if self._picture.isNull():
            return
        ratio = self.devicePixelRatioF()
        room = QSize(self.width(), self._HEIGHT) * ratio
        fitted = self._picture.scaled(
            room,
            Qt.AspectRatioMode.KeepAspectRatio,
            Qt.TransformationMode.SmoothTransformation,
        )
        fitted.setDevicePixelRatio(ratio)
        self.setPixmap(fitted)
