"""What is painted over an image: marks, numbers along its edges, and the colour bar."""

import itertools
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D
from PySide6.QtCore import QLineF, QPointF, QRect, QRectF, QSizeF, Qt
from PySide6.QtGui import (
    QBrush,
    QColor,
    QPainter,
    QPainterPath,
    QPalette,
    QPen,
    QPolygonF,
    QTransform,
)
from PySide6.QtWidgets import QApplication

from ui.widgets.native import rgb_image
from workbench.pictures.axes import ticks_along

_BAR, _TICK, _GAP = 10.0, 4.0, 3.0  # pixels: width of the bar, length of ticks, around numbers
_SMALLER = 0.85  # numbers, relative to other text
_BACKING, _HALO = 190, 110  # of 255: opacity behind numbers, and around lines
_WIDE, _HIGH = 12, 4  # distance of ticks, in characters and lines
_FEWEST = 2  # such distances on an image with numbers
_DOT, _DASH = 2.5, 5.0  # pixels
_POINT = 4 / 3  # pixels

_UP, _RIGHT, _LEFT = QPointF(0, -1), QPointF(1, 0), QPointF(-1, 0)


class Overlays:
    """Marks and scales of the axes of a figure, in the colours of a palette."""

    def __init__(self, axes: Axes, palette: QPalette) -> None:
        self._axes, self._ink = axes, palette.windowText().color()
        self._backing, self._halo = (QColor(palette.window().color()) for _ in range(2))
        self._backing.setAlpha(_BACKING)
        self._halo.setAlpha(_HALO)
        colours = axes.images[0].get_cmap()(np.linspace(1, 0, 256)[:, None], bytes=True)
        self._colours = rgb_image(np.asarray(colours))
        self._hatches = [(_outlines(each), _colour(each)) for each in axes.collections]
        self._taken: list[QRectF] = []  # by texts

    def paint_marks(self, painter: QPainter, to_pixels: QTransform) -> None:
        """Paint hatches, lines and texts that lie at places of the image."""
        self._taken = []
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for outlines, colour in self._hatches:
            painter.fillPath(to_pixels.map(outlines), QBrush(colour, Qt.BrushStyle.BDiagPattern))
        for line in self._axes.lines:
            if line.get_visible():
                self._paint_line(painter, line, to_pixels)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
        _make_small(painter)
        self._paint_legend(painter)
        for text in self._axes.texts:
            at = to_pixels.map(QPointF(*text.get_position()))
            box = self._box(painter, text.get_text())
            box.moveLeft(at.x() - (0 if text.get_horizontalalignment() == "left" else box.width()))
            box.moveTop(at.y() - (0 if text.get_verticalalignment() == "top" else box.height()))
            self._write(painter, box, text.get_text())

    def _paint_legend(self, painter: QPainter) -> None:
        legend, at = self._axes.get_legend(), painter.clipBoundingRect().topLeft()
        if legend is None:
            return
        at += QPointF(0, painter.fontMetrics().height())  # below the name of the vertical axis
        for swatch, text in zip(legend.get_patches(), legend.get_texts(), strict=True):
            box = self._box(painter, text.get_text())
            colour = QRectF(at, QSizeF(box.height(), box.height()))
            painter.fillRect(colour, QColor(to_hex(swatch.get_facecolor())))
            box.moveTopLeft(colour.topRight())
            self._write(painter, box, text.get_text())
            at = colour.bottomLeft()

    def paint_scales(self, painter: QPainter, space: QRectF) -> None:
        """Paint axes along the lower and left edge of a space, and a colour bar at the right."""
        _make_small(painter)
        metrics = painter.fontMetrics()
        wide, high = _WIDE * metrics.averageCharWidth(), _HIGH * metrics.height()
        if space.width() < _FEWEST * wide or space.height() < _FEWEST * high:
            return
        x, y = self._axes.xaxis, self._axes.yaxis
        self._name(painter, x.get_label_text(), space.bottomRight(), (-1, -1))
        self._name(painter, y.get_label_text(), space.topLeft(), (0, 0))
        for bar in self._axes.child_axes:
            name = self._name(painter, bar.get_ylabel(), space.topRight(), (-1, 0))
            place = QRectF(space.right() - _BAR - _GAP, name.bottom() + high / _HIGH, _BAR, 0)
            place.setBottom(space.bottom() - high)
            painter.drawImage(place, self._colours)
            painter.drawRect(place)
            edge = QLineF(place.bottomLeft(), place.topLeft())
            self._paint_axis(painter, bar.yaxis, edge, _LEFT, space, place.height() / high)
        edge = QLineF(space.bottomLeft(), space.topLeft())
        self._paint_axis(painter, y, edge, _RIGHT, space, space.height() / high)
        edge = QLineF(space.bottomLeft(), space.bottomRight())
        self._paint_axis(painter, x, edge, _UP, space, space.width() / wide)

    def _paint_axis(
        self,
        painter: QPainter,
        axis: Axis,
        edge: QLineF,
        inwards: QPointF,
        space: QRectF,
        most: float,
    ) -> None:
        """Paint ticks and numbers beside an edge, but no number over another or beyond."""
        for part, number in ticks_along(axis, int(most)):
            foot, box = edge.pointAt(part), self._box(painter, number)
            half = abs(inwards.x()) * box.width() / 2 + abs(inwards.y()) * box.height() / 2
            box.moveCenter(foot + inwards * (_TICK + half))
            if space.contains(box) and not any(box.intersects(each) for each in self._taken):
                self._write(painter, box, number)
                painter.drawLine(QLineF(foot, foot + inwards * _TICK))

    def _name(
        self, painter: QPainter, name: str, corner: QPointF, shift: tuple[int, int]
    ) -> QRectF:
        box = self._box(painter, name)
        box.moveTopLeft(corner + QPointF(shift[0] * box.width(), shift[1] * box.height()))
        self._write(painter, box, name)
        return box

    def _write(self, painter: QPainter, box: QRectF, text: str) -> None:
        painter.fillRect(box, self._backing)
        painter.setPen(self._ink)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        self._taken.append(box)

    def _paint_line(self, painter: QPainter, line: Line2D, to_pixels: QTransform) -> None:
        places = np.asarray(line.get_xydata())
        pieces = np.split(places, np.flatnonzero(np.isnan(places[:, 0])))
        parts = [to_pixels.map(_polygon(piece[np.isfinite(piece[:, 0])])) for piece in pieces]
        colour, width = QColor(to_hex(line.get_color())), _POINT * line.get_linewidth()
        for pen in (QPen(self._halo, width + 2), QPen(colour, width)):
            if line.get_linestyle() == "--":
                pen.setDashPattern([_DASH / pen.widthF()] * 2)
            painter.setPen(pen)
            for part in parts:
                painter.drawPolyline(part)
        if line.get_marker() == "o":
            painter.setBrush(colour)
            for place in itertools.chain.from_iterable(part.toList() for part in parts):
                painter.drawEllipse(place, _DOT, _DOT)
            painter.setBrush(Qt.BrushStyle.NoBrush)

    @staticmethod
    def _box(painter: QPainter, text: str) -> QRectF:
        box = QRectF(painter.boundingRect(QRect(), Qt.AlignmentFlag.AlignLeft, text))
        return box.adjusted(-_GAP, 0, _GAP, 0)


def _make_small(painter: QPainter) -> None:
    font = painter.font()
    font.setPointSizeF(_SMALLER * QApplication.font().pointSizeF())
    painter.setFont(font)


def _polygon(places: Any) -> QPolygonF:
    return QPolygonF([QPointF(x, y) for x, y in np.asarray(places).tolist()])


def _outlines(filled: Any) -> QPainterPath:
    outlines = QPainterPath()  # whose holes stay empty
    for path in filled.get_paths():
        for polygon in path.to_polygons():
            outlines.addPolygon(_polygon(polygon))
    return outlines


def _colour(filled: Any) -> QColor:
    return QColor(to_hex(filled.get_edgecolor()[0]))
