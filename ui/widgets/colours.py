"""Pictures of numpy as pictures of Qt."""

import numpy as np
import numpy.typing as npt
from PySide6.QtGui import QImage


def rgb_image(colours: npt.NDArray[np.uint8]) -> QImage:
    """Return an image from colours (n_y, n_x, 3), with its own copy of the data."""
    rows, columns, _ = colours.shape
    data = np.ascontiguousarray(colours)
    image = QImage(data.data, columns, rows, 3 * columns, QImage.Format.Format_RGB888)
    return image.copy()  # the data are numpy's
