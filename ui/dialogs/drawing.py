"""A job from the side: light, lens or mirror, image, widths and distances."""

from collections.abc import Sequence

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.widgets import theme
from ui.words import tr
from workbench.arrays import Array
from workbench.jobs import Dimension, SideView

_LIGHT = {"light": "#d88900", "dark": "#ffc14d"}
_GLASS = {"light": "#5b93c9", "dark": "#7fb2e6"}
_FLATTEST = 0.3  # a drawing flatter than this part of the area is drawn with larger heights
_ARROW = 3.0


class SideDrawing(QWidget):
    """Draws a `SideView`, to scale where that is high enough to be seen."""

    def __init__(self) -> None:
        super().__init__()
        self._view: SideView | None = None
        self.setMinimumSize(320, 180)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(tr("Side view of the job"))

    def show_view(self, view: SideView) -> None:
        self._view = view
        self.update()

    @property
    def scales(self) -> tuple[float, float]:
        """Logical pixels per unit of length along the axis and across it."""
        if self._view is None:
            return 1.0, 1.0
        left, right, low, high = self._view.bounds
        area = self._area()
        length, height = right - left, max(high - low, 1e-12)
        along = min(area.width() / length, area.height() / height)
        across = max(along, min(_FLATTEST * area.height() / height, area.height() / height))
        return along, across

    def paintEvent(self, event: QPaintEvent) -> None:
        view = self._view
        if view is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        scheme = "dark" if theme.is_dark(self.palette()) else "light"
        light, glass = QColor(_LIGHT[scheme]), QColor(_GLASS[scheme])
        ink = self.palette().windowText().color()
        painter.setPen(QPen(light, 1.2))
        for ray in view.rays:
            painter.drawPolyline(self._line(ray))
        painter.setPen(QPen(glass, 1.5))
        glass.setAlphaF(0.45)
        painter.setBrush(glass)
        painter.drawPolygon(self._line(view.optic))
        painter.setPen(QPen(ink, 3))
        painter.drawPolyline(self._line(view.receiver))
        painter.setPen(QPen(light, 4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        if len(view.source):
            painter.drawPolyline(self._line(view.source))
            painter.drawPoints(self._line(view.source))
        painter.setPen(QPen(ink, 1))
        self._lengths(painter, view.dimensions)
        painter.drawText(QPointF(4, self.fontMetrics().ascent() + 2), self._remark(view))
        painter.end()

    def _area(self) -> QRectF:
        line = self.fontMetrics().lineSpacing()
        rows = 0 if self._view is None else sum(map(_along, self._view.dimensions))
        side = self.fontMetrics().horizontalAdvance("00000 mm") / 2 + 4
        return QRectF(self.rect()).adjusted(side, 2.4 * line, -side, -(rows + 1) * 1.3 * line)

    def _line(self, points: Array) -> QPolygonF:
        assert self._view is not None  # or nothing is drawn
        left, right, low, high = self._view.bounds
        middle, (along, across) = self._area().center(), self.scales
        places = (points - [(left + right) / 2, (low + high) / 2]) * [along, -across]
        return QPolygonF([middle + QPointF(x, y) for x, y in places.tolist()])

    def _lengths(self, painter: QPainter, dimensions: Sequence[Dimension]) -> None:
        line = self.fontMetrics().lineSpacing()
        row = self._area().bottom() + 0.5 * line
        for dimension in dimensions:
            first, last = (self._line(dimension.ends).at(end) for end in (0, 1))
            middle = (first.x() + last.x()) / 2
            if not dimension.distance:
                self._write(painter, middle, min(first.y(), last.y()) - 0.35 * line, dimension.text)
            elif not _along(dimension):
                self._aslant(painter, first, last, dimension.text)
            else:
                row += 1.3 * line
                painter.drawLine(QPointF(first.x(), row), QPointF(last.x(), row))
                for end in (first.x(), last.x()):
                    painter.drawLine(QPointF(end, row - _ARROW), QPointF(end, row + _ARROW))
                self._write(painter, middle, row - _ARROW - 2, dimension.text)

    def _write(self, painter: QPainter, middle: float, y: float, text: str) -> None:
        wide = self.fontMetrics().horizontalAdvance(text)
        left = min(max(middle - wide / 2, 2.0), self.width() - wide - 2.0)
        painter.drawText(QPointF(left, y), text)

    def _aslant(self, painter: QPainter, first: QPointF, last: QPointF, text: str) -> None:
        painter.save()
        painter.setPen(QPen(painter.pen().color(), 1, Qt.PenStyle.DashLine))
        painter.drawLine(first, last)
        painter.restore()
        ground = self.fontMetrics().boundingRect(text).adjusted(-4, -1, 4, 1)
        ground.moveCenter(((first + last) / 2).toPoint())
        if ground.width() > QLineF(first, last).length():  # would hide what it is between
            ground.moveRight(max(round(first.x()), ground.width()))
            ground.moveTop(round(max(first.y(), last.y()) + _ARROW))
        painter.fillRect(ground, self.palette().window())
        painter.drawText(ground, Qt.AlignmentFlag.AlignCenter, text)

    def _remark(self, view: SideView) -> str:
        along, across = self.scales
        seen = tr("From the side") if view.across == "y" else tr("From above")
        if across > 1.01 * along:
            return seen + tr(", heights × {across:.1f}").format(across=across / along)
        return seen + tr(", to scale")


def _along(dimension: Dimension) -> bool:
    return dimension.distance and bool(abs(dimension.ends[0, 1] - dimension.ends[1, 1]) < 1e-9)
