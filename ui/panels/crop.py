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
Ends = tuple[bool, bool]  # which edges along an axis are dragged: the lower and the higher one

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
        self._held: tuple[Ends, Ends] | None = None  # along x and y
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
        if self._held is None:
            along_x, along_y = self._near(at)
            self.setCursor(_CURSORS[any(along_x), any(along_y)])
            return
        by, place = at - self._at, self.place
        self._at = at
        self._move(self._held, by.x() / place.width(), by.y() / place.height())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.show_crop(WHOLE)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = ARROWS.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
            return
        alone = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        self._move(2 * ((not alone, True),), _STEP * step[0], _STEP * step[1])

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

    def _near(self, at: QPointF) -> tuple[Ends, Ends]:
        """Which edges are moved from here; all of them within the rectangle."""
        kept = self.kept
        if not kept.adjusted(-_NEAR, -_NEAR, _NEAR, _NEAR).contains(at):
            return (False, False), (False, False)
        along_x = _near_ends(at.x(), kept.left(), kept.right())
        along_y = _near_ends(at.y(), kept.top(), kept.bottom())
        return (along_x, along_y) if any(along_x + along_y) else ((True, True), (True, True))

    def _move(self, edges: tuple[Ends, ...], x: float, y: float) -> None:
        left, top, right, bottom = self.crop
        left, right = _moved((left, right), edges[0], x)
        top, bottom = _moved((top, bottom), edges[1], y)
        self.show_crop((left, top, right, bottom))


def _near_ends(at: float, low: float, high: float) -> Ends:
    """Which end of a range is near; the nearer one of a narrow range."""
    nearer = abs(at - low) < abs(high - at)
    return nearer and abs(at - low) <= _NEAR, not nearer and abs(high - at) <= _NEAR


def _moved(cut: tuple[float, float], edges: Ends, by: float) -> tuple[float, float]:
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
