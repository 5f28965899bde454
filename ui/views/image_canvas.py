"""Canvas that paints an image of `workbench.pictures` with Qt, as large as possible.

1. A figure of matplotlib holds values, colours, scale and marks. Files are drawn from it; the
   window paints the same things itself, because matplotlib cannot draw 60 times a second.
2. Values become colours once for new data. Copies of half the size keep small pictures free of
   moiré, and only the visible part is painted.
3. Scales lie over the image while the pointer is on it or the keyboard acts on it.
"""

from typing import Any, BinaryIO, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QImage,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
    QSinglePointEvent,
    QTransform,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.views.image_overlays import Overlays
from ui.views.shared_view import Part, Place
from ui.widgets.native import rgb_image
from workbench.pictures.axes import paint

# Colours and resolution of files, which are read and printed elsewhere.
_INK, _PAPER, _FILE_DPI = "black", "white", 200
_FILE_SIZE = 7.0  # inches
RING = 1
"""Pixels of the frame around what has the keyboard."""
_LARGE = 3.0  # pixels of the display for one of the image, which then has sharp edges


def write_figure(figure: Figure, file: BinaryIO, format: str, **options: Any) -> None:
    """Write a figure as "png" or "svg", black on white; it has other colours afterwards."""
    paint(figure, _INK, _PAPER)
    figure.savefig(file, format=format, dpi=_FILE_DPI, **options)


def frame_focused(canvas: QWidget, inner: QWidget | None = None) -> None:
    """Paint a frame on a canvas that has the keyboard focus, or whose inner widget has it."""
    if (inner or canvas).hasFocus():
        painter = QPainter(canvas)
        painter.setPen(QPen(canvas.palette().link().color(), RING))
        painter.drawRect(canvas.rect().adjusted(0, 0, -1, -1))
        painter.end()


class Touch(NamedTuple):
    """Mouse on an image: pixel, place, whether there is image, and whether Shift is held."""

    at: QPointF
    place: Place
    inside: bool
    shift: bool


class ImageCanvas(QWidget):
    """Paints the image of a figure, its marks and its scales."""

    has_space = True  # since there are no labels around it

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMouseTracking(True)
        self.figure = Figure(figsize=(_FILE_SIZE, _FILE_SIZE))
        self._axes: Axes | None = None
        self._part: Part = (0.0, 1.0, 0.0, 1.0)
        self._transform = QTransform()  # of places to pixels
        self._whole, self._seen = QRectF(), QRectF()  # pixels of the image
        self._sizes: list[QImage] = []  # each half as large as the one before
        self._overlays: Overlays | None = None
        self._hovered = False

    @property
    def scale(self) -> float:
        """Pixels per unit of length."""
        return -self._transform.m22()

    @property
    def rightwards(self) -> int:
        """1 where x grows to the right, −1 where it grows to the left."""
        return 1 if self._transform.m11() > 0 else -1

    def begin(self) -> Axes:
        self.figure.clear()
        self._axes, self._overlays = self.figure.add_subplot(), None
        return self._axes

    def recolour(self) -> None:
        palette = self.palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())

    def show_changes(self) -> None:
        """Paint new values, colours or marks."""
        if self._axes is not None and self._axes.get_visible() and self._axes.images:
            self._convert(self._axes)
        self.repaint()

    def show_part(self, part: Part) -> None:
        """Show a rectangle as large as possible, and what else there is space for."""
        self._part = part
        self._settle()
        self.update()

    def write(self, file: BinaryIO, format: str) -> None:
        """Write what is seen as "png" or "svg" with axes, black on white."""
        write_figure(self.figure, file, format, bbox_inches="tight")
        self.recolour()

    def position_of(self, x: float, y: float) -> QPointF:
        return self._transform.map(QPointF(x, y))

    def place_at(self, at: QPointF) -> Place:
        place = self._transform.inverted()[0].map(at)
        return place.x(), place.y()

    def touch(self, event: QSinglePointEvent) -> Touch:
        middle = 0.5 / self.devicePixelRatioF()  # of the pixel that the pointer is on
        at = event.position() + QPointF(middle, middle)
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        return Touch(at, self.place_at(at), self._seen.contains(at), shift)

    def show_scales(self, shown: bool) -> None:
        if shown is not self._hovered:
            self._hovered = shown
            self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._settle()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:  # after that of the parent
            self.recolour()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().window())
        axes = self._axes
        if axes is not None and axes.get_visible() and self._overlays:
            self._paint_image(painter)
            painter.setClipRect(self._seen)
            self._overlays.paint_marks(painter, self._transform)
            if self._hovered or self.hasFocus():
                self._overlays.paint_scales(painter, self._seen)
        painter.end()
        frame_focused(self)

    def _settle(self) -> None:
        """Lay out the visible part, which is also that of files."""
        if self._axes is None or not self._axes.images:
            return
        left, right, bottom, top = self._part
        width, height = max(self.width(), 1), max(self.height(), 1)
        scale = min(width / (right - left), height / (top - bottom))
        west, east, south, north = self._axes.images[0].get_extent()
        across = scale if east > west else -scale
        x, y = (left + right) / 2, (bottom + top) / 2
        self._transform = QTransform(
            across, 0, 0, -scale, width / 2 - across * x, height / 2 + scale * y
        )
        self._whole = QRectF(self.position_of(west, north), self.position_of(east, south))
        self._seen = self._whole & QRectF(self.rect())
        if not self._seen.isEmpty():
            left, top = self.place_at(self._seen.topLeft())
            right, bottom = self.place_at(self._seen.bottomRight())
            self._axes.set_xlim(left, right)
            self._axes.set_ylim(bottom, top)

    def _convert(self, axes: Axes) -> None:
        (image,) = axes.images
        colours = np.asarray(image.to_rgba(np.ma.asarray(image.get_array()), bytes=True))
        self._sizes = [rgb_image(colours)]
        self._overlays = Overlays(axes, self.palette())

    def _paint_image(self, painter: QPainter) -> None:
        whole = self._whole
        zoom = painter.device().devicePixelRatioF() * whole.width() / self._sizes[0].width()
        image = self._reduced(zoom)
        kx, ky = image.width() / whole.width(), image.height() / whole.height()
        seen, corner = self._seen, self._seen.topLeft() - whole.topLeft()
        source = QRectF(corner.x() * kx, corner.y() * ky, seen.width() * kx, seen.height() * ky)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, zoom < _LARGE)
        painter.drawImage(seen, image, source)

    def _reduced(self, zoom: float) -> QImage:
        for image in self._sizes:
            if zoom > 0.5 or min(image.width(), image.height()) < 2:
                return image
            zoom *= 2
            if image is self._sizes[-1]:
                half = QSize(image.width() // 2, image.height() // 2)
                keep, smooth = (
                    Qt.AspectRatioMode.IgnoreAspectRatio,
                    Qt.TransformationMode.SmoothTransformation,
                )
                self._sizes.append(image.scaled(half, keep, smooth))
        return self._sizes[-1]
