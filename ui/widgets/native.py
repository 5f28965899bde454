"""Native windows, the Qt application, and images of numpy's arrays."""

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPoint, QRect, QSize, QSizeF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QSizePolicy, QWidget


def application() -> QApplication:
    """Return the application; raise RuntimeError if there is none yet."""
    found = QApplication.instance()
    if not isinstance(found, QApplication):
        raise RuntimeError("make the application before its widgets")
    return found


def available_size(widget: QWidget) -> QSize:
    """Return the size of the screen that a widget is on, without bars of the desktop.

    Not by `QWidget.screen`: PySide6 makes what that returns a child of the widget, and where
    Python collects both, the screen of other windows is gone and hiding one of them crashes.
    """
    place = widget.mapToGlobal(widget.rect().center())
    screen = QGuiApplication.screenAt(place) or QGuiApplication.primaryScreen()
    return screen.availableSize()


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
    """Return an image from colours (n_y, n_x, 3 or 4), with its own copy of the data."""
    rows, columns, channels = colours.shape
    data = np.ascontiguousarray(colours)
    kinds = QImage.Format
    given, own = (
        (kinds.Format_RGB888, kinds.Format_RGB32)
        if channels == 3
        else (kinds.Format_RGBA8888, kinds.Format_ARGB32_Premultiplied)
    )
    image = QImage(data.data, columns, rows, channels * columns, given)
    return image.convertToFormat(own)  # the data are numpy's; these formats are painted fastest


class ScaledImage(QWidget):
    """Paints an image as large as possible, with the aspect of what it shows."""

    def __init__(self) -> None:
        super().__init__()
        self._picture, self._aspect = QImage(), 1.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def show_image(self, image: QImage, aspect: float) -> None:
        self._picture, self._aspect = image, aspect
        self.update()

    def clear(self) -> None:
        self.show_image(QImage(), 1.0)

    @property
    def place(self) -> QRect:
        """Rectangle of the image."""
        size = QSizeF(self._aspect, 1.0).scaled(
            QSizeF(self.size()), Qt.AspectRatioMode.KeepAspectRatio
        )
        place = QRect(QPoint(0, 0), size.toSize().expandedTo(QSize(1, 1)))
        place.moveCenter(self.rect().center())
        return place

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(self.place, self._picture)
        painter.end()
