"""Drawing of a part: front view and two sections at a round scale, with dimensions in mm or inch.

Views lie as in first-angle projection: the front view is seen from +z, the section A–A from −x at
its right, the section B–B from above below it.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from workbench.arrays import Array
from workbench.geometry.face_grids import element_sides
from workbench.powers import written
from workbench.scene import Element
from workbench.units import ratio

if TYPE_CHECKING:
    from matplotlib.axes import Axes
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
_GLASS, _INK, _THIN = "#cfe3f5", "#1d232b", "#5b6470"
_FONT = 8


@dataclass(frozen=True)
class _Section:
    """Outline of a section: ends along the side and depth along z, in the drawing's unit."""

    front: Array  # (n, 2): side, z
    back: Array

    @property
    def outline(self) -> Array:
        return np.concatenate([self.front, self.back[::-1]])

    def thickness(self, at: int) -> float:
        return abs(float(self.back[at, 1] - self.front[at, 1]))


class PartDrawing:
    """Drawing of an element; ``height`` is that of the picture in inches."""

    def __init__(
        self, element: Element, heights: Mapping[str, Array], unit: str, width: float
    ) -> None:
        self.unit = "inch" if unit == "inch" else "mm"
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

    def draw(self, figure: "FigureBase") -> None:
        """Draw on an empty figure or part of one, to scale."""
        axes = figure.subplots()
        axes.set_position((0, 0, 1, 1))
        axes.set(xlim=(0, self._width), ylim=(0, self._tall), autoscale_on=False)
        axes.set_axis_off()
        paper, (first, last) = self._paper, self._depths
        wide, high = paper * self._size
        deep = paper * (last - first)
        used = wide + _GAP + deep
        left = (self._width - used) / 2
        middle = np.array([left + wide / 2, self._tall - _MARGIN - high / 2])
        self._draw_front(axes, middle, wide, high)
        begin = left + wide + _GAP
        self._draw_upright(axes, begin, middle[1], deep, high)
        self._draw_level(axes, middle[0], middle[1] - high / 2 - _GAP, deep, wide)

    def _draw_front(self, axes: "Axes", middle: Array, wide: float, high: float) -> None:
        self._fill(axes, middle + self._paper * self._rim)
        across, up = np.array([wide / 2, 0]), np.array([0, high / 2])
        self._centre(axes, middle - across, middle + across, "B")
        self._centre(axes, middle - up, middle + up, "A")
        top, side = middle[1] + high / 2, middle[0] - wide / 2
        ends = (middle[0] - wide / 2, top), (middle[0] + wide / 2, top)
        self._dimension(axes, *ends, (0, _BESIDE), self._size[0])
        ends = (side, middle[1] - high / 2), (side, middle[1] + high / 2)
        self._dimension(axes, *ends, (-_BESIDE, 0), self._size[1])

    def _draw_upright(
        self, axes: "Axes", begin: float, middle: float, deep: float, high: float
    ) -> None:
        (first, last), section, paper = self._depths, self._upright, self._paper

        def at(side: float, z: float) -> tuple[float, float]:
            return begin + paper * (z - first), middle + paper * side

        self._fill(axes, [at(*place) for place in section.outline])
        self._centre(axes, (begin, middle), (begin + deep, middle), "")
        top, bottom = middle + high / 2, middle - high / 2
        self._dimension(
            axes, (begin, top), (begin + deep, top), (0, _BESIDE), last - first, "overall "
        )
        half = len(section.front) // 2
        begins, ends = ((at(*side[half])[0], bottom) for side in (section.front, section.back))
        self._dimension(axes, begins, ends, (0, -_BESIDE), section.thickness(half), "centre ")
        for place, row in ((top, -1), (bottom, 0)):
            self._edge(axes, (begin + deep + 2, place), section.thickness(row), "left")
        self._title(axes, begin + deep / 2, bottom - _BESIDE - 8, "A–A")

    def _draw_level(
        self, axes: "Axes", middle: float, top: float, deep: float, wide: float
    ) -> None:
        first, section, paper = self._depths[0], self._level, self._paper
        places = [(middle + paper * x, top - paper * (z - first)) for x, z in section.outline]
        self._fill(axes, places)
        self._centre(axes, (middle, top), (middle, top - deep), "")
        for side, row, across in ((1, -1, "left"), (-1, 0, "right")):
            place = middle + side * (wide / 2 + 2), top - deep / 2
            self._edge(axes, place, section.thickness(row), across)
        self._title(axes, middle, top - deep - 8, "B–B")

    def _fill(self, axes: "Axes", places: Any) -> None:
        x, y = np.asarray(places).T
        axes.fill(x, y, facecolor=_GLASS, edgecolor=_INK, linewidth=1.2)

    def _edge(self, axes: "Axes", place: Any, thickness: float, across: str) -> None:
        (x, y), text = place, f"edge {self._number(thickness)}"
        axes.text(x, y, text, fontsize=_FONT - 1, color=_THIN, ha=across, va="center")

    def _title(self, axes: "Axes", x: float, y: float, text: str) -> None:
        axes.text(x, y, text, fontsize=_FONT, weight="bold", color=_INK, ha="center", va="center")

    def _centre(self, axes: "Axes", start: Any, end: Any, letter: str) -> None:
        """Draw a centre line, with the letter of a section at both ends."""
        start, end = np.asarray(start), np.asarray(end)
        along = (end - start) / np.linalg.norm(end - start)
        ends = start - _BEYOND * along, end + _BEYOND * along
        axes.plot(*np.stack(ends, -1), color=_THIN, linewidth=0.6, dashes=(12, 3, 2, 3))
        for place, way in zip(ends, (-1, 1), strict=True):
            x, y = place + 2 * way * along
            axes.text(x, y, letter, fontsize=_FONT, color=_THIN, ha="center", va="center")

    def _dimension(
        self, axes: "Axes", start: Any, end: Any, beside: Any, value: float, name: str = ""
    ) -> None:
        """Draw a dimension line between two places, moved aside, with its extension lines."""
        start, end, beside = np.asarray(start), np.asarray(end), np.asarray(beside, dtype=float)
        aside = beside / np.linalg.norm(beside)
        for place in (start, end):
            line = np.stack([place + 0.8 * aside, place + beside + 1.5 * aside], -1)
            axes.plot(*line, color=_THIN, linewidth=0.5)
        ends, length = (start + beside, end + beside), np.linalg.norm(end - start)
        along = (end - start) / length if length else np.array([1.0, 0.0])
        look: dict[str, Any] = {"linewidth": 0.6, "color": _THIN, "shrinkA": 0, "shrinkB": 0}
        text = f"{name}{self._number(value)}"
        upright = abs(along[1]) > abs(along[0])
        if length >= _SHORT + _LETTER * len(text):
            axes.annotate("", ends[0], ends[1], arrowprops={"arrowstyle": "<|-|>"} | look)
            above = np.array([-1.8, 0.0]) if upright else np.array([0.0, 1.8])
            place, across = (ends[0] + ends[1]) / 2 + above, "center"
        else:
            for tip, way in zip(ends, (-1, 1), strict=True):
                axes.annotate(
                    "", tip, tip + 5 * way * along, arrowprops={"arrowstyle": "-|>"} | look
                )
            place, across = ends[1] + 6 * along, "center" if upright else "left"
        x, y = place
        axes.text(
            x,
            y,
            text,
            fontsize=_FONT,
            color=_INK,
            ha=across,
            va="center",
            rotation=90 if upright else 0,
        )

    def _number(self, value: float) -> str:
        return written(value, digits=4)
