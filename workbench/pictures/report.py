"""Report: A4 pages with headings, rows and pictures, and the pictures themselves."""

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
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox, BboxBase

from workbench.arrays import Array
from workbench.design.session import Session, result_of
from workbench.geometry.surface import freeform_nets
from workbench.messages import capitalised
from workbench.pictures import lens_image, loss
from workbench.pictures.axes import AS_SEEN, UNSIGNED
from workbench.pictures.error_curves import draw_errors
from workbench.pictures.images import (
    ErrorImage,
    IrradianceImage,
    full_scale,
    is_lighting,
    target_irradiance,
    to_colours,
)
from workbench.pictures.manufacture import draw_manufacture
from workbench.pictures.regions import RegionMarks
from workbench.pictures.section import SectionCurves, cut_through
from workbench.pictures.surface import ASPECTS, SurfaceImage
from workbench.scene import Element, Scene
from workbench.scene.image import as_viewed

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase, SubFigure

    from workbench.design.snapshot import Result

WIDTH = 7.5
"""Inches between the margins."""
Draw = Callable[["FigureBase"], None]
"""Draws a picture on an empty figure or part of one."""
_PAGE = (8.27, 11.69)
_MARGIN = (_PAGE[0] - WIDTH) / 2
_LINE = 0.17  # inches
_INK, _PALE, _RULE = "#1d232b", "#6a7380", "#d9dee5"
_SIZES = {"title": 18.0, "heading": 12.0, "text": 8.5}
_COLUMNS = (0.0, 1.85, 3.8, 5.65)  # inches: names and values of two rows
_DIGITS = 6  # of positions, in parts of a page
_TOGETHER = 16  # rows that stay on one page
_NAME_LETTERS, _VALUE_LETTERS, _LINE_LETTERS = 28, 29, 112
_CELL_GAP = 3  # letters, between columns of a table
_Line = tuple[str, ...]
__all__ = [
    "draw_faces",
    "draw_images",
    "draw_lens",
    "draw_loss",
    "draw_manufacture",
    "draw_sections",
    "draw_seen",
    "draw_tolerances",
    "draw_two_tracers",
]
_FONT = 9
_APART = {"wspace": 0.12, "hspace": 0.03}


@dataclass(frozen=True)
class _Block:
    height: float
    draw: "Callable[[SubFigure], None]"
    heads: bool = False  # stays with the next block


class Pages:
    """A4 pages with headings, rows and pictures; ``foot`` stands below each page."""

    def __init__(self, foot: str) -> None:
        self._foot = foot
        self._blocks: list[_Block] = []

    def title(self, text: str, below: str) -> None:
        """Add a title and a line below it."""

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
        """Add sentences."""
        lines = textwrap.wrap(text, _LINE_LETTERS)

        def draw(part: "SubFigure") -> None:
            for number, line in enumerate(lines):
                _write(part, 0.0, (number + 0.8) * _LINE, line, "text", colour=_PALE)

        self._blocks.append(_Block((len(lines) + 0.4) * _LINE, draw, heads=True))

    def rows(self, rows: Sequence[tuple[str, str]], heads: bool = False) -> None:
        """Add names and values in two columns; ``heads`` keeps them with what follows."""
        for first in range(0, len(rows), _TOGETHER):
            lines: list[_Line] = []
            for left in range(first, min(first + _TOGETHER, len(rows)), 2):
                lines += _row_lines(rows[left : left + 2])
            self._blocks.append(_Block(len(lines) * _LINE, partial(_draw_lines, lines), heads))

    def table(self, header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        """Add a table, with columns as wide as their texts need."""
        columns = zip(header, *rows, strict=True)
        letters = [max(map(len, column)) + _CELL_GAP for column in columns]
        while sum(letters) > _LINE_LETTERS:
            letters[letters.index(max(letters))] -= 1
        places = [WIDTH * sum(letters[:k]) / _LINE_LETTERS for k in range(len(letters))]
        for number, row in enumerate((header, *rows)):
            cells = [
                textwrap.wrap(text, count - _CELL_GAP) or [""]
                for text, count in zip(row, letters, strict=True)
            ]
            lines = list(zip_longest(*cells, fillvalue=""))
            draw = partial(_draw_row, lines, places, _INK if number else _PALE)
            heads = number < len(rows) if len(rows) < _TOGETHER else not number
            self._blocks.append(_Block((len(lines) + 0.4) * _LINE, draw, heads))

    def picture(self, draw: Draw, height: float) -> None:
        """Add a picture over the whole width, height in inches."""

        def between_margins(part: "SubFigure") -> None:
            ratios = [_MARGIN, WIDTH, _MARGIN]
            draw(part.subfigures(1, 3, width_ratios=ratios, squeeze=False)[0, 1])

        self._blocks.append(_Block(height, between_margins))

    def write(self, file: BinaryIO, title: str, dated: datetime | None = None) -> None:
        """Write the PDF; the same pages of the same date give the same bytes."""
        pages = self._paginated()
        metadata = {"Title": title, "Creator": self._foot, "CreationDate": dated}
        # Fonts are embedded as TrueType, so that the text can be found and copied.
        usual = matplotlib.rcParamsDefault["font.family"]
        with (
            matplotlib.rc_context({"pdf.fonttype": 42, "font.family": usual}),
            PdfPages(file, metadata=metadata) as pdf,
        ):
            for number, blocks in enumerate(pages, 1):
                page = self._page(blocks, f"{self._foot} · {number} / {len(pages)}")
                _fix_layout(page)
                pdf.savefig(page)

    def _paginated(self) -> list[list[_Block]]:
        space = _PAGE[1] - 2 * _MARGIN - _LINE
        pages: list[list[_Block]] = [[]]
        left = space
        for number, block in enumerate(self._blocks):
            needed = block.height
            follower = number
            while self._blocks[follower].heads and follower + 1 < len(self._blocks):
                follower += 1
                needed += self._blocks[follower].height
            if needed > left and pages[-1]:
                pages.append([])
                left = space
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


def _fix_layout(page: Figure) -> None:
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


def _row_lines(rows: Sequence[tuple[str, str]]) -> list[_Line]:
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


def _draw_row(
    lines: Sequence[_Line], places: Sequence[float], colour: str, part: "SubFigure"
) -> None:
    for number, line in enumerate(lines):
        for text, x in zip(line, places, strict=True):
            _write(part, x, (number + 0.8) * _LINE, text, "text", colour=colour)
    left, right = (x / part.bbox.width * part.dpi for x in (_MARGIN, _MARGIN + WIDTH))
    rule = Line2D([left, right], [0, 0], color=_RULE, linewidth=0.5)
    rule.set_transform(part.transSubfigure)
    part.add_artist(rule)


def _write(
    part: "SubFigure",
    x: float,
    y: float,
    text: str,
    kind: str,
    colour: str = _INK,
    weight: str = "normal",
) -> None:
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
    """Write a picture of the report as PNG."""
    # Labels may exceed the area that the layout gives them.
    figure = Figure(figsize=(WIDTH, height), layout=ConstrainedLayoutEngine(w_pad=0.15))
    draw(figure)
    figure.savefig(file, dpi=144, format="png")


def draw_lens(figure: "FigureBase", session: Session, lights: Sequence[Array]) -> None:
    """Draw the lens with rays, distances compressed, and each receiver with its image."""
    axes = figure.subplots()
    axes.imshow(lens_image(session, lights, explode=True), interpolation="antialiased")
    axes.set_axis_off()


def draw_seen(figure: "FigureBase", session: Session, irradiance: Array, which: str = "") -> None:
    """Draw the light as its viewer sees it, and the target, in the same greys.

    ``which`` follows both titles.
    """
    scene, target = session.scene, session.target
    flux = scene.receiver.total(irradiance)
    top = full_scale(scene, target, flux)
    panels = figure.subplots(1, 2, gridspec_kw={"wspace": 0.02})
    lights = irradiance, target_irradiance(scene, target, flux)
    for axes, light, title in zip(panels, lights, ("Light", "Target"), strict=True):
        axes.imshow(to_colours(as_viewed(scene, light), top, AS_SEEN), aspect=aspect(scene))
        axes.set(xticks=[], yticks=[])
        axes.set_title(f"{title}{which}", fontsize=_FONT)


def aspect(scene: Scene) -> float:
    """Height of a pixel of the receiver over its width."""
    receiver = scene.receiver
    (r_x, r_y), (n_x, n_y) = receiver.half_extent, receiver.pixels
    return float(r_y * n_x / (r_x * n_y))


def draw_images(figure: "FigureBase", session: Session, irradiance: Array) -> None:
    """Draw irradiance, with lines of equal light where it is lighting, and its signed error."""
    scene, target = session.scene, session.target
    lit, off = figure.subplots(1, 2, gridspec_kw=_APART)
    image = IrradianceImage(lit, scene, target)
    if is_lighting(scene, target):
        image.outlined = True
        image.set_colours(UNSIGNED[0])
    image.update(irradiance)
    RegionMarks(lit, scene)
    ErrorImage(off, scene, target).update(irradiance)
    density = scene.receiver.density.capitalize()
    for axes, title in zip((lit, off), (density, f"{density} − target"), strict=True):
        axes.set_title(title, fontsize=_FONT)


def draw_faces(figure: "FigureBase", session: Session, element: Element) -> None:
    """Draw the heights of each freeform face of an element over its base."""
    scene, heights = session.scene, result_of(session).state.heights
    faces = list(reversed(freeform_nets(element)))
    panels = figure.subplots(-(-len(faces) // 2), 2, gridspec_kw=_APART).ravel()
    for axes, face in zip(panels, faces, strict=False):
        SurfaceImage(axes, scene, ASPECTS[0], face).update(heights[face])
        title = capitalised(f"{scene.face_in_words(face)} over its base")
        axes.set_title(title, fontsize=_FONT)
    for axes in panels[len(faces) :]:
        axes.set_axis_off()


def draw_sections(figure: "FigureBase", session: Session, irradiance: Array) -> None:
    """Draw irradiance and target along x and y through the middle of the receiver."""
    for axes, along in zip(figure.subplots(1, 2, gridspec_kw=_APART), "xy", strict=True):
        curves = SectionCurves(axes, session.scene, session.target)
        middle = session.scene.receiver.middle
        curves.update(irradiance, cut_through(session.scene, along, middle))


def draw_two_tracers(figure: "FigureBase", session: Session, ours: Array, mitsuba: Array) -> None:
    """Draw irradiance by two tracers, their difference at equal flux, and the target."""
    scene, target = session.scene, session.target
    density, flux = scene.receiver.density.capitalize(), scene.receiver.total(ours)
    panels = figure.subplots(2, 2, gridspec_kw=_APART).ravel()
    for axes, irradiance in zip(
        panels[[0, 1, 3]], (ours, mitsuba, target_irradiance(scene, target, flux)), strict=True
    ):
        IrradianceImage(axes, scene, target).update(irradiance)
    ErrorImage(panels[2], scene, ours).update(mitsuba)
    titles = f"{density}, check", f"{density}, Mitsuba 3", "Mitsuba 3 − check", "Target"
    for axes, title in zip(panels, titles, strict=True):
        axes.set_title(title, fontsize=_FONT)


def draw_loss(figure: "FigureBase", result: "Result") -> None:
    """Draw the loss over the iterations."""
    loss.draw_loss(figure.subplots(), result.losses, result.stage_starts, result.state.loss)


def draw_tolerances(figure: "FigureBase", nominal: float, errors: Sequence[float]) -> None:
    """Draw the distribution of the error over perturbed lenses."""
    draw_errors(figure.subplots(), nominal, errors)
