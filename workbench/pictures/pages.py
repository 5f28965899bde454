"""Pages of A4 with headings, rows and pictures, as PDF."""

import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from itertools import zip_longest
from typing import TYPE_CHECKING, BinaryIO

import matplotlib
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.transforms import Bbox, BboxBase

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase, SubFigure

WIDTH = 7.5
"""Inches between the margins."""

Draw = Callable[["FigureBase"], None]
"""Draws a picture on an empty figure or part of one."""

_PAGE = (8.27, 11.69)
_MARGIN = (_PAGE[0] - WIDTH) / 2
_LINE = 0.17  # inches
_INK, _PALE = "#1d232b", "#6a7380"
_SIZES = {"title": 18.0, "heading": 12.0, "text": 8.5}
_COLUMNS = (0.0, 1.65, 3.85, 5.5)  # inches, of the names and values of two rows
_DIGITS = 6  # of places, in parts of a page
_TOGETHER = 16  # rows that stay on one page
_NAME_LETTERS, _VALUE_LETTERS, _LINE_LETTERS = 26, 34, 112


_Line = tuple[str, ...]


@dataclass(frozen=True)
class _Block:
    """Something that is not divided by the end of a page."""

    height: float
    draw: "Callable[[SubFigure], None]"
    heads: bool = False  # stays with what comes after it


class Pages:
    """Gathers blocks from the top of the first page down, and writes them.

    Parameters
    ----------
    foot : str
        Stands below each page, before its number.
    """

    def __init__(self, foot: str) -> None:
        self._foot = foot
        self._blocks: list[_Block] = []

    def title(self, text: str, below: str) -> None:
        """Begin with a title and a line below it."""

        def draw(part: "SubFigure") -> None:
            _write(part, 0.0, 0.32, text, "title", weight="bold")
            _write(part, 0.0, 0.56, below, "text", colour=_PALE)

        self._blocks.append(_Block(0.7, draw))

    def heading(self, text: str) -> None:
        """Add a heading, which stays with what follows."""

        def draw(part: "SubFigure") -> None:
            _write(part, 0.0, 0.3, text, "heading", weight="bold")

        self._blocks.append(_Block(0.4, draw, heads=True))

    def note(self, text: str) -> None:
        """Add some sentences."""
        lines = textwrap.wrap(text, _LINE_LETTERS)

        def draw(part: "SubFigure") -> None:
            for number, line in enumerate(lines):
                _write(part, 0.0, (number + 0.8) * _LINE, line, "text", colour=_PALE)

        self._blocks.append(_Block((len(lines) + 0.4) * _LINE, draw, heads=True))

    def rows(self, rows: Sequence[tuple[str, str]], heads: bool = False) -> None:
        """Add names and values, two beside each other; they may stay with what follows."""
        for first in range(0, len(rows), _TOGETHER):
            lines: list[_Line] = []
            for left in range(first, min(first + _TOGETHER, len(rows)), 2):
                lines += _beside(rows[left : left + 2])
            self._blocks.append(_Block(len(lines) * _LINE, partial(_draw_lines, lines), heads))

    def picture(self, draw: Draw, height: float) -> None:
        """Add a picture as wide as the page and as high as this, inches."""

        def between_margins(part: "SubFigure") -> None:
            ratios = [_MARGIN, WIDTH, _MARGIN]
            draw(part.subfigures(1, 3, width_ratios=ratios, squeeze=False)[0, 1])

        self._blocks.append(_Block(height, between_margins))

    def write(self, file: BinaryIO, title: str, dated: datetime) -> None:
        """Write all of it; the same pages of the same date are the same bytes.

        Raises
        ------
        OSError
            If it cannot be written.
        """
        pages = self._paginated()
        metadata = {"Title": title, "Creator": self._foot, "CreationDate": dated}
        # Letters as they are, so that the text can be found and copied.
        with (
            matplotlib.rc_context({"pdf.fonttype": 42}),
            PdfPages(file, metadata=metadata) as pdf,
        ):
            for number, blocks in enumerate(pages, 1):
                page = self._page(blocks, f"{self._foot} · {number} / {len(pages)}")
                _settle(page)
                pdf.savefig(page)

    def _paginated(self) -> list[list[_Block]]:
        room = _PAGE[1] - 2 * _MARGIN - _LINE
        pages: list[list[_Block]] = [[]]
        left = room
        for number, block in enumerate(self._blocks):
            needed = block.height
            follower = number
            while self._blocks[follower].heads and follower + 1 < len(self._blocks):
                follower += 1
                needed += self._blocks[follower].height
            if needed > left and pages[-1]:
                pages.append([])
                left = room
            pages[-1].append(block)
            left -= block.height
        return pages

    def _page(self, blocks: Sequence[_Block], foot: str) -> Figure:
        figure = Figure(figsize=_PAGE, layout="constrained")
        heights = [_MARGIN, *(block.height for block in blocks)]
        rest = max(_PAGE[1] - sum(heights), 1e-3)
        ratios = [*heights, rest]
        column = figure.subfigures(len(ratios), 1, height_ratios=ratios, squeeze=False)
        _, *parts, last = column[:, 0]
        for block, part in zip(blocks, parts, strict=True):
            block.draw(part)
        bottom = last.bbox.height / last.dpi - _MARGIN
        _write(last, 0.0, bottom, foot, "text", colour=_PALE)
        return figure


def _settle(page: Figure) -> None:
    """Lay out a page, and round where everything stands.

    The last digits of the solver depend on addresses in memory, which no two runs have in common.
    """
    page.draw_without_rendering()
    page.set_layout_engine("none")
    for axes in page.axes:
        axes.set_position(_rounded(axes.get_position()))
    parts = list(page.subfigs)
    for part in parts:  # grows
        parts.extend(part.subfigs)
        part.bbox_relative.set(_rounded(part.bbox_relative))


def _rounded(place: BboxBase) -> Bbox:
    return Bbox(place.get_points().round(_DIGITS))


def _beside(rows: Sequence[tuple[str, str]]) -> list[_Line]:
    """Lines of rows that stand beside each other: a name and a value for each."""
    cells = [
        part
        for name, value in rows
        for part in (textwrap.wrap(name, _NAME_LETTERS), textwrap.wrap(value, _VALUE_LETTERS))
    ]
    return list(zip_longest(*cells, fillvalue=""))


def _draw_lines(lines: Sequence[_Line], part: "SubFigure") -> None:
    for number, line in enumerate(lines):
        for text, x, colour in zip(line, _COLUMNS, (_PALE, _INK, _PALE, _INK), strict=False):
            _write(part, x, (number + 0.8) * _LINE, text, "text", colour=colour)


def _write(
    part: "SubFigure",
    x: float,
    y: float,
    text: str,
    kind: str,
    colour: str = _INK,
    weight: str = "normal",
) -> None:
    """Write a line; x and y in inches from the left margin and from the top of the part."""
    width, height = part.bbox.width / part.dpi, part.bbox.height / part.dpi
    part.text(
        (x + _MARGIN) / width,
        1 - y / height,
        text,
        fontsize=_SIZES[kind],
        color=colour,
        weight=weight,
        parse_math=False,
    )


def to_png(draw: Draw, height: float, file: BinaryIO) -> None:
    """Draw such a picture as a PNG file."""
    # Labels may stand out a little from the place that the layout has for them.
    figure = Figure(figsize=(WIDTH, height), layout=ConstrainedLayoutEngine(w_pad=0.15))
    draw(figure)
    figure.savefig(file, dpi=144, format="png")
