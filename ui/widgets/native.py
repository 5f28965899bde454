"""Native windows, the Qt application, and pictures of numpy for Qt."""

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QImage, QPaintEvent
from PySide6.QtWidgets import QApplication, QWidget


def application() -> QApplication:
    """Return the application; raise RuntimeError if there is none yet."""
    found = QApplication.instance()
    if not isinstance(found, QApplication):
        raise RuntimeError("make the application before its widgets")
    return found


def make_native(widget: QWidget) -> None:
    """Give a widget a native window, as everything over the native 3D view needs.

    Other widgets must not be native: menus over a native dock would belong to no window.
    """
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_DontCreateNativeWidgetSiblings)
    widget.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
    widget.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)


class Uncovered(QObject):
    """Repaints uncovered parts of a window with OpenGL, where there is no compositor."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        window.winId()  # there is a handle from here on
        window.windowHandle().installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QPaintEvent):
            self._window.update(event.region())
        return False


def rgb_image(colours: npt.NDArray[np.uint8]) -> QImage:
    """Return an image from colours (n_y, n_x, 3), with its own copy of the data."""
    rows, columns, _ = colours.shape
    data = np.ascontiguousarray(colours)
    image = QImage(data.data, columns, rows, 3 * columns, QImage.Format.Format_RGB888)
    return image.copy()  # the data are numpy's
