"""Drawing of a part: front view and two sections at a round scale, with dimensions in mm or inch.

Views lie as in first-angle projection: the front view is seen from +z, the section A–A from −x at
its right, the section B–B from above below it.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.face_grids import element_sides
from workbench.pictures.part.pens import AxesPen, DxfPen, Pen
from workbench.powers import written
from workbench.scene import Element
from workbench.units import ratio

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

_MM = 25.4  # per inch of paper
_SCALES = [step * 10.0**power for power in range(4, -6, -1) for step in (5, 2, 1)]
_SAMPLES = 201  # along each face
# mm of paper: around the views, between them, of a dimension beside a view.
_MARGIN, _GAP, _BESIDE = 16.0, 26.0, 9.0
_TALLEST = 120.0  # of the views with the gap, mm of paper
# A dimension that is too short for its text has its arrows outside; mm of paper, for each letter.
_SHORT, _LETTER = 6.0, 1.8
_BEYOND = 3.0  # of centre lines and extension lines, mm of paper
BASE, SIDE, FOOT = "D", "E", "F"
"""Letters of the datums: the other side of the designed face, and the rim at −x and at −y."""
_FONT, _SMALL = 8, 5
_CORNERS = (-1, -1), (1, -1), (1, 1), (-1, 1)
_CROSS = 0.8  # half of the size of an inspection point's cross, mm of paper
_DATUM = 5.0  # from a side to the middle of its datum letter, mm of paper


class _Section(NamedTuple):
    """Outline of a section: ends along the side and depth along z, in the drawing's unit."""

    front: Array  # (n, 2): side, z
    back: Array

    @property
    def outline(self) -> Array:
        return np.concatenate([self.front, self.back[::-1]])

    def thickness(self, at: int) -> float:
        return abs(float(self.back[at, 1] - self.front[at, 1]))


def drawing_unit(unit: str) -> str:
    """Return the unit of drawings of a scene's unit."""
    return "inch" if unit == "inch" else "mm"


class PartDrawing:
    """Drawing of an element; ``height`` is that of the picture in inches."""

    def __init__(
        self,
        element: Element,
        heights: Mapping[str, Array],
        unit: str,
        width: float,
        points: Array | None = None,
    ) -> None:
        """``points`` (m, 2) of the front view, scene units, are marked with their numbers."""
        self.unit = drawing_unit(unit)
        self._points = None if points is None else float(ratio(unit, self.unit)) * points
        self._faces_back = element.placed_faces[0].name != element.designed_face
        self._width = width * _MM
        line, middle = np.linspace(-1, 1, _SAMPLES), _SAMPLES // 2
        front, back = sides = [
            float(ratio(unit, self.unit)) * element.seen(points)
            for points in element_sides(element, line, line, heights)
        ]
        points = np.concatenate(sides).reshape(-1, 3)
        low, high = points.min(axis=0), points.max(axis=0)
        self._depths = float(low[2]), float(high[2])
        self._size = high[:2] - low[:2]
        around = front[:, 0], front[-1], front[::-1, -1], front[0, ::-1]
        self._rim = np.concatenate(around)[:, :2]
        self._upright = _Section(front[middle][:, [1, 2]], back[middle][:, [1, 2]])
        self._level = _Section(front[:, middle][:, [0, 2]], back[:, middle][:, [0, 2]])
        depth = high[2] - low[2]
        per_unit = float(ratio(self.unit, "mm"))
        space = self._width - 2 * _MARGIN - _GAP, _TALLEST - _GAP
        needed = (self._size[0] + depth) * per_unit, (self._size[1] + depth) * per_unit
        most = min(free / need for free, need in zip(space, needed, strict=True))
        self.scale = next((scale for scale in _SCALES if scale <= most), most)
        self._paper = self.scale * per_unit  # mm of paper per unit
        self._tall = self._paper * (self._size[1] + depth) + _GAP + 2 * _MARGIN
        self.height = self._tall / _MM

    @property
    def scale_in_words(self) -> str:
        """The scale as in "2 : 1"."""
        return f"{max(self.scale, 1):.3g} : {max(1 / self.scale, 1):.3g}"

    @property
    def chord_error(self) -> float:
        """Largest distance of the drawn sections from the part, in the drawing's unit."""
        sides = (side[:, 1] for each in (self._upright, self._level) for side in each)
        return max(float(np.abs(np.diff(z, 2)).max()) / 8 for z in sides)

    def draw(self, figure: "FigureBase") -> None:
        """Draw on an empty figure or part of one, to scale."""
        axes = figure.subplots()
        axes.set_position((0, 0, 1, 1))
        axes.set(xlim=(0, self._width), ylim=(0, self._tall), autoscale_on=False)
        axes.set_axis_off()
        self.draw_with(AxesPen(axes))

    def write_dxf(self, file: BinaryIO) -> None:
        """Write the drawing as DXF, with the part in full size in the drawing's unit."""
        pen = DxfPen(1 / self._paper)
        self.draw_with(pen)
        pen.write(file)

    def draw_with(self, pen: Pen) -> None:
        """Draw with a pen, in mm of paper."""
        paper, (first, last) = self._paper, self._depths
        wide, high = paper * self._size
        deep = paper * (last - first)
        used = wide + _GAP + deep
        left = (self._width - used) / 2
        middle = np.array([left + wide / 2, self._tall - _MARGIN - high / 2])
        self._draw_front(pen, middle, wide, high)
        begin = left + wide + _GAP
        self._draw_upright(pen, begin, middle[1], deep, high)
        self._draw_level(pen, middle[0], middle[1] - high / 2 - _GAP, deep, wide)

    def _draw_front(self, pen: Pen, middle: Array, wide: float, high: float) -> None:
        pen.outline(middle + self._paper * self._rim)
        across, up = np.array([wide / 2, 0]), np.array([0, high / 2])
        self._centre(pen, middle - across, middle + across, "B")
        self._centre(pen, middle - up, middle + up, "A")
        top, side = middle[1] + high / 2, middle[0] - wide / 2
        ends = (middle[0] - wide / 2, top), (middle[0] + wide / 2, top)
        self._dimension(pen, *ends, (0, _BESIDE), self._size[0])
        ends = (side, middle[1] - high / 2), (side, middle[1] + high / 2)
        self._dimension(pen, *ends, (-_BESIDE, 0), self._size[1])
        self._datum(pen, middle - across - up / 2, (-1, 0), SIDE)
        self._datum(pen, middle - up + across / 2, (0, -1), FOOT)
        for number, place in enumerate(() if self._points is None else self._points):
            at = middle + self._paper * place
            for way in ((_CROSS, 0), (0, _CROSS)):
                pen.line([at - way, at + way])
            inwards = np.where(place > 0, -1, 1)
            end = "left" if inwards[0] > 0 else "right"
            pen.text(at + 1.5 * _CROSS * inwards, str(number + 1), _SMALL, end)

    def _draw_upright(
        self, pen: Pen, begin: float, middle: float, deep: float, high: float
    ) -> None:
        (first, last), section, paper = self._depths, self._upright, self._paper

        def at(side: float, z: float) -> tuple[float, float]:
            return begin + paper * (z - first), middle + paper * side

        pen.outline([at(*place) for place in section.outline])
        self._centre(pen, (begin, middle), (begin + deep, middle), "")
        top, bottom = middle + high / 2, middle - high / 2
        self._dimension(
            pen, (begin, top), (begin + deep, top), (0, _BESIDE), last - first, "overall "
        )
        half = len(section.front) // 2
        begins, ends = ((at(*side[half])[0], bottom) for side in (section.front, section.back))
        self._dimension(pen, begins, ends, (0, -_BESIDE), section.thickness(half), "centre ")
        for place, row in ((top, -1), (bottom, 0)):
            self._edge(pen, (begin + deep + 2, place), section.thickness(row), "left")
        base = section.front if self._faces_back else section.back
        row = len(base) // 8
        self._datum(pen, at(*base[row]), (-1 if self._faces_back else 1, 0), BASE)
        self._title(pen, begin + deep / 2, bottom - _BESIDE - 8, "A–A")

    def _draw_level(self, pen: Pen, middle: float, top: float, deep: float, wide: float) -> None:
        first, section, paper = self._depths[0], self._level, self._paper
        places = [(middle + paper * x, top - paper * (z - first)) for x, z in section.outline]
        pen.outline(places)
        self._centre(pen, (middle, top), (middle, top - deep), "")
        for side, row, across in ((1, -1, "left"), (-1, 0, "right")):
            place = middle + side * (wide / 2 + 2), top - deep / 2
            self._edge(pen, place, section.thickness(row), across)
        self._title(pen, middle, top - deep - 8, "B–B")

    def _edge(self, pen: Pen, place: Any, thickness: float, across: str) -> None:
        pen.text(place, f"edge {self._number(thickness)}", _FONT - 1, across)

    def _title(self, pen: Pen, x: float, y: float, text: str) -> None:
        pen.text((x, y), text, _FONT, bold=True)

    def _centre(self, pen: Pen, start: Any, end: Any, letter: str) -> None:
        """Draw a centre line, with the letter of a section at both ends."""
        start, end = np.asarray(start), np.asarray(end)
        along = (end - start) / np.linalg.norm(end - start)
        ends = start - _BEYOND * along, end + _BEYOND * along
        pen.line(ends, centre=True)
        for place, way in zip(ends, (-1, 1), strict=True):
            if letter:
                pen.text(place + 2 * way * along, letter, _FONT)

    def _datum(self, pen: Pen, place: Any, aside: Any, letter: str) -> None:
        """Draw the letter of a datum in a frame, with a triangle on its side."""
        place, aside = np.asarray(place, dtype=float), np.asarray(aside, dtype=float)
        along, middle = np.array([-aside[1], aside[0]]), place + _DATUM * aside
        foot, half = _DATUM / 3, _DATUM / 3
        triangle = [place - half / 2 * along, place + half / 2 * along, place + foot * aside]
        pen.line([*triangle, triangle[0]])
        pen.line([triangle[2], middle - half * aside])
        frame = [middle + half * np.array(corner) for corner in _CORNERS]
        pen.line([*frame, frame[0]])
        pen.text(middle, letter, _FONT)

    def _dimension(
        self, pen: Pen, start: Any, end: Any, beside: Any, value: float, name: str = ""
    ) -> None:
        """Draw a dimension line between two places, moved aside, with its extension lines."""
        start, end, beside = np.asarray(start), np.asarray(end), np.asarray(beside, dtype=float)
        aside = beside / np.linalg.norm(beside)
        for place in (start, end):
            pen.line([place + 0.8 * aside, place + beside + 1.5 * aside])
        ends, length = (start + beside, end + beside), np.linalg.norm(end - start)
        along = (end - start) / length if length else np.array([1.0, 0.0])
        text = f"{name}{self._number(value)}"
        upright = abs(along[1]) > abs(along[0])
        if length >= _SHORT + _LETTER * len(text):
            middle = (ends[0] + ends[1]) / 2
            for tip in ends:
                pen.arrow(tip, middle)
            above = np.array([-1.8, 0.0]) if upright else np.array([0.0, 1.8])
            place, across = middle + above, "center"
        else:
            for tip, way in zip(ends, (-1, 1), strict=True):
                pen.arrow(tip, tip + 5 * way * along)
            place, across = ends[1] + 6 * along, "center" if upright else "left"
        pen.text(place, text, _FONT, across, turned=upright)

    def _number(self, value: float) -> str:
        return written(value, digits=4)
