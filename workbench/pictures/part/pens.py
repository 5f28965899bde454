"""Pens of line drawings: onto axes of matplotlib, and into DXF files."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, BinaryIO, Protocol

import numpy as np

from workbench.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_GLASS, _INK, _THIN = "#cfe3f5", "#1d232b", "#5b6470"
_DASHES = 12, 3, 2, 3  # points
_POINT = 25.4 / 72  # mm
_CAPITAL = 0.7  # height of capital letters over the size of a font
_HEAD = 2.5, 0.8  # mm of paper, length and width of an arrowhead


class Pen(Protocol):
    """Draws on a sheet; places are in mm of paper, x to the right and y up."""

    def outline(self, places: Any) -> None:
        """Draw a closed outline (n, 2) of the part."""

    def line(self, places: Any, centre: bool = False) -> None:
        """Draw a thin line (n, 2), or a centre line."""

    def arrow(self, tip: Array, tail: Array) -> None:
        """Draw a line with an arrowhead at its tip."""

    def text(
        self,
        place: Any,
        text: str,
        size: float,
        across: str = "center",
        turned: bool = False,
        bold: bool = False,
    ) -> None:
        """Write text at its middle or at one end; ``size`` in points."""


class AxesPen:
    """Draws onto axes whose unit is one mm of paper."""

    def __init__(self, axes: "Axes") -> None:
        self._axes = axes

    def outline(self, places: Any) -> None:
        """See `Pen.outline`."""
        x, y = np.asarray(places).T
        self._axes.fill(x, y, facecolor=_GLASS, edgecolor=_INK, linewidth=1.2)

    def line(self, places: Any, centre: bool = False) -> None:
        """See `Pen.line`."""
        look: dict[str, Any] = {"linewidth": 0.6, "dashes": _DASHES} if centre else {}
        self._axes.plot(*np.asarray(places).T, **{"color": _THIN, "linewidth": 0.5, **look})

    def arrow(self, tip: Array, tail: Array) -> None:
        """See `Pen.arrow`."""
        look = {"linewidth": 0.6, "color": _THIN, "shrinkA": 0, "shrinkB": 0}
        self._axes.annotate("", tuple(tip), tuple(tail), arrowprops={"arrowstyle": "-|>"} | look)

    def text(
        self,
        place: Any,
        text: str,
        size: float,
        across: str = "center",
        turned: bool = False,
        bold: bool = False,
    ) -> None:
        """See `Pen.text`."""
        x, y = place
        self._axes.text(
            x,
            y,
            text,
            fontsize=size,
            weight="bold" if bold else "normal",
            color=_INK,
            ha=across,
            va="center",
            rotation=90 if turned else 0,
        )


class DxfPen:
    """Collects entities of a DXF file, revision 12; a mm of paper becomes ``scale`` units."""

    def __init__(self, scale: float) -> None:
        self._scale = scale
        self._entities: list[tuple[int, object]] = []

    def outline(self, places: Any) -> None:
        """See `Pen.outline`."""
        self._polyline(places, "PART", closed=1)

    def line(self, places: Any, centre: bool = False) -> None:
        """See `Pen.line`."""
        self._polyline(places, "CENTRE" if centre else "DIMENSIONS", closed=0)

    def arrow(self, tip: Array, tail: Array) -> None:
        """See `Pen.arrow`."""
        self.line([tail, tip])
        tip, tail = np.asarray(tip, dtype=float), np.asarray(tail, dtype=float)
        along = (tail - tip) / np.linalg.norm(tail - tip)
        aside = np.array([-along[1], along[0]])
        length, width = _HEAD
        corners = [tip + length * along + side * width / 2 * aside for side in (1, -1)]
        self._add((0, "SOLID"), (8, "DIMENSIONS"))
        for number, place in enumerate([tip, *corners, corners[-1]]):
            self._add(*self._place(place, number))

    def text(
        self,
        place: Any,
        text: str,
        size: float,
        across: str = "center",
        turned: bool = False,
        bold: bool = False,
    ) -> None:
        """See `Pen.text`."""
        height = self._scale * size * _POINT * _CAPITAL
        letters = "".join(c if c.isascii() else f"\\U+{ord(c):04X}" for c in text)
        self._add((0, "TEXT"), (8, "TEXT"), *self._place(place, 0), (40, height), (1, letters))
        self._add((50, 90.0 if turned else 0.0), (72, ("left", "center", "right").index(across)))
        self._add(*self._place(place, 1), (73, 2))

    def write(self, file: BinaryIO) -> None:
        """Write the file."""
        dashes = [self._scale * _POINT * each for each in _DASHES]
        for code, value in (*_tables(dashes), *self._entities, (0, "ENDSEC"), (0, "EOF")):
            number = f"{value:.9g}" if isinstance(value, float) else value
            file.write(f"{code}\n{number}\n".encode("ascii"))

    def _polyline(self, places: Any, layer: str, closed: int) -> None:
        self._add((0, "POLYLINE"), (8, layer), (66, 1), *self._place((0.0, 0.0), 0), (70, closed))
        for place in np.asarray(places):
            self._add((0, "VERTEX"), (8, layer), *self._place(place, 0))
        self._add((0, "SEQEND"), (8, layer))

    def _place(self, place: Any, number: int) -> Iterator[tuple[int, float]]:
        x, y = (self._scale * float(each) for each in place)
        yield from zip((10 + number, 20 + number, 30 + number), (x, y, 0.0), strict=True)

    def _add(self, *groups: tuple[int, object]) -> None:
        self._entities += groups


def _tables(dashes: Sequence[float]) -> Iterator[tuple[int, object]]:
    """Groups of a DXF file before its entities: version, line types and layers."""
    yield from ((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC"))
    yield from ((0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LTYPE"), (70, 2))
    yield from (
        (0, "LTYPE"),
        (2, "CONTINUOUS"),
        (70, 0),
        (3, "Solid"),
        (72, 65),
        (73, 0),
        (40, 0.0),
    )
    yield from ((0, "LTYPE"), (2, "CENTER"), (70, 0), (3, "Dash dot"), (72, 65))
    yield from ((73, len(dashes)), (40, float(sum(dashes))))
    yield from ((49, dash if number % 2 == 0 else -dash) for number, dash in enumerate(dashes))
    yield from ((0, "ENDTAB"), (0, "TABLE"), (2, "LAYER"), (70, 4))
    for layer in ("PART", "CENTRE", "DIMENSIONS", "TEXT"):
        line = "CENTER" if layer == "CENTRE" else "CONTINUOUS"
        yield from ((0, "LAYER"), (2, layer), (70, 0), (62, 7), (6, line))
    yield from ((0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"))
