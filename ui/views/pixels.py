"""A picture in as much room as there is, its aspect kept."""

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.widgets.colours import rgb_image

_USUAL, _LEAST = QSize(320, 320), QSize(160, 120)


class Pixels(QWidget):
    """Paints an image as large as possible, with its aspect ratio."""

    def __init__(self) -> None:
        super().__init__()
        self._image: QImage | None = None
        self._aspect = 1.0
        self.setMinimumSize(_LEAST)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        """Size in which an image is recognisable."""
        return _USUAL

    def show_pixels(self, values: "npt.NDArray[np.uint8] | None", aspect: float = 1.0) -> None:
        """Show an image (n_y, n_x, 3) with pixels of an aspect ratio, or none."""
        self._image, self._aspect = None if values is None else rgb_image(values), aspect
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the image in the middle, as large as possible."""
        if self._image is None:
            return
        size = QSizeF(self._image.width() * self._aspect, self._image.height())
        size.scale(QSizeF(self.size()), Qt.AspectRatioMode.KeepAspectRatio)
        place = QRectF(0, 0, size.width(), size.height())
        place.moveCenter(QRectF(self.rect()).center())
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(place, self._image)
        painter.end()
