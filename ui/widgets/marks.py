"""Painted marks beside sentences: good, to be looked at, bad, or a note."""

from typing import Literal

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

Sign = Literal["good", "attention", "bad", "note"]

_MARK = 16  # pixels
# Both grounds: 3:1 at least beside the mark, white on them.
_COLOURS = {"good": "#2e8b57", "attention": "#c77700", "bad": "#d13438", "note": "#2b78b8"}
_POINTS = {  # outlines of the marks; discs have none
    "attention": ((8, 0.5), (16, 15.5), (0, 15.5)),
    "bad": ((5, 0), (11, 0), (16, 5), (16, 11), (11, 16), (5, 16), (0, 11), (0, 5)),
}
_STROKES = {
    "good": (((4, 8.5), (7, 11.5), (12, 5)),),
    "attention": (((8, 6), (8, 10)), ((8, 12.6), (8, 13))),
    "bad": (((5, 5), (11, 11)), ((11, 5), (5, 11))),
    "note": (((8, 7.5), (8, 12)), ((8, 4), (8, 4.4))),
}


class Mark(QWidget):
    """A tick on a disc, an exclamation mark on a triangle, a cross on an octagon, or an i."""

    def __init__(self, sign: Sign) -> None:
        super().__init__()
        self.setFixedSize(_MARK, _MARK)
        self.sign = sign

    def show_sign(self, sign: Sign) -> None:
        self.sign = sign
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(_COLOURS[self.sign]))
        if self.sign in _POINTS:
            painter.drawPolygon([QPointF(*point) for point in _POINTS[self.sign]])
        else:
            painter.drawEllipse(0, 0, _MARK, _MARK)
        pen = painter.pen()
        pen.setStyle(Qt.PenStyle.SolidLine)
        pen.setColor(QColor("white"))
        pen.setWidthF(2.0)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        for stroke in _STROKES[self.sign]:
            painter.drawPolyline([QPointF(*point) for point in stroke])
        painter.end()
