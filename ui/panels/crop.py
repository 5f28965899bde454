"""A picture that is cropped by dragging the edges of what is kept."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QRegion,
)

from ui.widgets.native import ScaledImage
from ui.words import tr
from workbench.arrays import Array
from workbench.targets.colour import SRGB

Crop = tuple[float, float, float, float]
"""What is cut away at the left, top, right and bottom, as fractions."""

_NEAR, _HANDLE = 12.0, 7.0  # pixels from an edge that is taken hold of, and size of a handle
_LEAST = 0.05  # of the picture is kept along each axis
_STEP = 0.01  # of the picture for an arrow key
_VEIL = QColor(0, 0, 0, 150)
WHOLE: Crop = (0.0, 0.0, 0.0, 0.0)
"""Nothing is cut away."""
ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
"""Steps of arrow keys to the right and down."""
_CURSORS = {  # by what moves along x and along y
    (False, False): Qt.CursorShape.ArrowCursor,
    (True, False): Qt.CursorShape.SizeHorCursor,
    (False, True): Qt.CursorShape.SizeVerCursor,
    (True, True): Qt.CursorShape.SizeAllCursor,
}


def grey_image(light: Array) -> QImage:
    """Return an image of light (n_y, n_x) in greys; its peak, if there is any, is white."""
    # As much light of the monitor for each pixel as there is on the screen.
    greys = (255 * SRGB.stored(light / (light.max() or 1.0))).round().astype(np.uint8, order="C")
    rows, columns = greys.shape
    image = QImage(greys.data, columns, rows, columns, QImage.Format.Format_Grayscale8)
    return image.copy()  # the array is gone after this


class CropView(ScaledImage):
    """A picture and the rectangle of it that is kept.

    Edges, corners and the rectangle itself are dragged; arrows move it, with Shift its right and
    lower edge.
    """

    changed = Signal()

    def __init__(self, crop: Crop) -> None:
        super().__init__()
        self.crop = crop
        self._held: tuple[bool, ...] = ()  # which edges are dragged
        self._at = QPointF()
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Picture with the part that is kept"))

    def show_light(self, light: Array) -> None:
        rows, columns = light.shape
        self.show_image(grey_image(light), columns / rows)

    def show_crop(self, crop: Crop) -> None:
        self.crop = crop
        self.update()
        self.changed.emit()

    @property
    def kept(self) -> QRectF:
        """Rectangle of what is kept, in pixels of the widget."""
        left, top, right, bottom = self.crop
        all_of_it = QRectF(self.place)
        width, height = all_of_it.width(), all_of_it.height()
        return all_of_it.adjusted(left * width, top * height, -right * width, -bottom * height)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self._held, self._at = self._near(event.position()), event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if not any(self._held):
            near = self._near(at)
            self.setCursor(_CURSORS[near[0] or near[2], near[1] or near[3]])
            return
        by, place = at - self._at, self.place
        self._at = at
        self._move(self._held, by.x() / place.width(), by.y() / place.height())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = ()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.show_crop(WHOLE)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = ARROWS.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
            return
        alone = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        held = (not alone, not alone, True, True)
        self._move(held, _STEP * step[0], _STEP * step[1])

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter, kept = QPainter(self), self.kept
        outside = QRegion(self.place) - QRegion(kept.toAlignedRect())
        painter.setClipRegion(outside)
        painter.fillRect(self.place, _VEIL)
        painter.setClipping(False)
        accent = self.palette().highlight().color()
        painter.setPen(QPen(accent, 2 if self.hasFocus() else 1))
        painter.drawRect(kept)
        for across in (kept.left(), kept.center().x(), kept.right()):
            for down in (kept.top(), kept.center().y(), kept.bottom()):
                handle = QRectF(0, 0, _HANDLE, _HANDLE)
                handle.moveCenter(QPointF(across, down))
                if handle.center() != kept.center():
                    painter.fillRect(handle, accent)
        painter.end()

    def _near(self, at: QPointF) -> tuple[bool, ...]:
        """Which edges are moved from here: left, top, right, bottom; all within the rectangle."""
        kept = self.kept
        if not kept.adjusted(-_NEAR, -_NEAR, _NEAR, _NEAR).contains(at):
            return (False,) * 4
        gaps = at.x() - kept.left(), at.y() - kept.top(), kept.right() - at.x()
        edges = [abs(gap) <= _NEAR for gap in (*gaps, kept.bottom() - at.y())]
        if edges[0] and edges[2]:  # of a narrow rectangle
            edges[0] = gaps[0] < gaps[2]
            edges[2] = not edges[0]
        if edges[1] and edges[3]:
            edges[1] = gaps[1] < kept.bottom() - at.y()
            edges[3] = not edges[1]
        return tuple(edges) if any(edges) else (True,) * 4

    def _move(self, edges: tuple[bool, ...], x: float, y: float) -> None:
        left, top, right, bottom = self.crop
        left, right = _moved((left, right), (edges[0], edges[2]), x)
        top, bottom = _moved((top, bottom), (edges[1], edges[3]), y)
        self.show_crop((left, top, right, bottom))


def _moved(cut: tuple[float, float], edges: tuple[bool, bool], by: float) -> tuple[float, float]:
    """What is cut away at both ends of an axis after a move of these edges."""
    low, high = cut
    if all(edges):
        by = min(max(by, -low), high)
        return low + by, high - by
    if edges[0]:
        low = min(max(low + by, 0.0), 1 - _LEAST - high)
    if edges[1]:
        high = min(max(high - by, 0.0), 1 - _LEAST - low)
    return low, high
