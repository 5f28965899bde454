"""A photograph whose four corners of the receiver are marked by dragging."""

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from ui.manufacture.option_fields import OptionFields
from ui.panels.crop import ARROWS, grey_image
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import ScaledImage
from ui.words import later, tr
from workbench.analysis.making.photograph_options import PhotographOptions
from workbench.arrays import Array

_SIZE = QSize(900, 720)
_INSET = 0.1  # of the first corners from the edges of the photograph
_HANDLE = 9  # pixels, radius
_ABOUT = later(
    "Drag the numbered corners onto those of the receiver: 1 is the top left corner of the target, "
    "and 2, 3 and 4 follow around it. With the keyboard: Space chooses a corner, arrows move it."
)


class CornerView(ScaledImage):
    """A picture and a quadrilateral in it; ``corners`` are in pixels of the picture."""

    def __init__(self, light: Array) -> None:
        super().__init__()
        rows, columns = light.shape
        self._pixels = columns, rows
        self.show_image(grey_image(light), columns / rows)
        near, far = _INSET, 1 - _INSET
        shares = (near, near), (far, near), (far, far), (near, far)
        self.corners = [(x * columns, y * rows) for x, y in shares]
        self._held = 0
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Photograph with the corners of the receiver"))

    @property
    def handles(self) -> list[QPointF]:
        """Corners in pixels of the widget."""
        place, (columns, rows) = self.place, self._pixels
        return [
            QPointF(place.x() + x / columns * place.width(), place.y() + y / rows * place.height())
            for x, y in self.corners
        ]

    def move_corner(self, number: int, x: float, y: float) -> None:
        columns, rows = self._pixels
        self.corners[number] = min(max(x, 0.0), columns), min(max(y, 0.0), rows)
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at, handles = event.position(), self.handles
        self._held = min(range(4), key=lambda n: (handles[n] - at).manhattanLength())
        self.mouseMoveEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at, place, (columns, rows) = event.position(), self.place, self._pixels
        x, y = (at.x() - place.x()) / place.width(), (at.y() - place.y()) / place.height()
        self.move_corner(self._held, x * columns, y * rows)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = ARROWS.get(Qt.Key(event.key()))
        if step is not None:
            x, y = self.corners[self._held]
            self.move_corner(self._held, x + step[0], y + step[1])
        elif event.key() == Qt.Key.Key_Space:
            self._held = (self._held + 1) % 4
            self.update()
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter, palette, handles = QPainter(self), self.palette(), self.handles
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(palette.highlight().color(), 2))
        painter.drawPolygon(QPolygonF(handles))
        for number, handle in enumerate(handles):
            held = number == self._held and self.hasFocus()
            painter.setPen(QPen(palette.highlightedText().color(), 2 if held else 0))
            painter.setBrush(palette.highlight())
            painter.drawEllipse(handle, _HANDLE, _HANDLE)
            painter.drawText(handle + QPointF(-4, 5), str(number + 1))
        painter.end()


class PhotographDialog(Dialog):
    """Asks for the corners of the receiver in a photograph, and for its tone."""

    def __init__(self, light: Array, begin_with: PhotographOptions, window: QWidget) -> None:
        super().__init__(tr("Compare a photograph"), window, Buttons.Cancel)
        self.view, self.fields = CornerView(light), OptionFields("mm", begin_with)
        self.add_button(tr("&Compare")).setDefault(True)
        self.fill(WrappedLabel(tr(_ABOUT)), (self.view, 1), self.fields, size=_SIZE)
        self.view.setFocus()
