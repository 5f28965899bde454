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
_ARROW = 4.0


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
        if self._view is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        scheme = "dark" if theme.is_dark(self.palette()) else "light"
        light, glass = QColor(_LIGHT[scheme]), QColor(_GLASS[scheme])
        ink = self.palette().windowText().color()
        view = self._view
        painter.setPen(QPen(light, 1.2))
        for ray in view.rays:
            painter.drawPolyline(self._line(ray))
        filled = QColor(glass)
        filled.setAlphaF(0.45)
        painter.setPen(QPen(glass, 1.5))
        painter.setBrush(filled)
        painter.drawPolygon(self._line(view.optic))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(ink, 3))
        painter.drawPolyline(self._line(view.receiver))
        painter.setPen(QPen(light, 4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        if len(view.source):
            painter.drawPolyline(self._line(view.source))
            painter.drawPoints(self._line(view.source))
        painter.setPen(QPen(ink, 1))
        self._lengths(painter, view.dimensions)
        self._remark(painter)
        painter.end()

    def _area(self) -> QRectF:
        line = self.fontMetrics().lineSpacing()
        rows = 0 if self._view is None else sum(map(_along, self._view.dimensions))
        side = self.fontMetrics().horizontalAdvance("00000 mm") / 2 + 4
        return QRectF(self.rect()).adjusted(side, 2.4 * line, -side, -(rows + 1) * 1.3 * line)

    def _line(self, points: Array) -> QPolygonF:
        assert self._view is not None  # or nothing is drawn
        left, right, low, high = self._view.bounds
        area, (along, across) = self._area(), self.scales
        begin = area.center().x() - along * (left + right) / 2
        middle = area.center().y() + across * (low + high) / 2
        return QPolygonF([QPointF(begin + along * z, middle - across * y) for z, y in points])

    def _lengths(self, painter: QPainter, dimensions: Sequence[Dimension]) -> None:
        metrics, line = self.fontMetrics(), self.fontMetrics().lineSpacing()
        row = self._area().bottom() + 0.5 * line
        for dimension in dimensions:
            first, last = (self._line(dimension.ends).at(end) for end in (0, 1))
            if dimension.distance and not _along(dimension):
                self._aslant(painter, first, last, dimension.text)
                continue
            if not dimension.distance:
                top = min(first.y(), last.y())
                wide = metrics.horizontalAdvance(dimension.text)
                middle = (first.x() + last.x()) / 2
                at = min(max(middle - wide / 2, 2.0), self.width() - wide - 2.0)
                painter.drawText(QPointF(at, top - 0.35 * line), dimension.text)
                continue
            row += 1.3 * line
            ends = [QPointF(min(first.x(), last.x()), row), QPointF(max(first.x(), last.x()), row)]
            painter.drawLine(*ends)
            for end in ends:
                painter.drawLine(end + QPointF(0, -_ARROW), end + QPointF(0, _ARROW))
            wide = metrics.horizontalAdvance(dimension.text)
            middle = (ends[0].x() + ends[1].x()) / 2
            at = min(max(middle - wide / 2, 2.0), self.width() - wide - 2.0)
            painter.drawText(QPointF(at, row - 0.25 * line), dimension.text)

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

    def _remark(self, painter: QPainter) -> None:
        assert self._view is not None  # or nothing is drawn
        along, across = self.scales
        seen = tr("From the side") if self._view.across == "y" else tr("From above")
        scale = (
            tr(", heights × {across:.1f}").format(across=across / along)
            if across > 1.01 * along
            else tr(", to scale")
        )
        painter.drawText(QPointF(4, self.fontMetrics().ascent() + 2), seen + scale)


def _along(dimension: Dimension) -> bool:
    return dimension.distance and bool(abs(dimension.ends[0, 1] - dimension.ends[1, 1]) < 1e-9)
