"""Pictures of benchmarks."""

import math
import textwrap
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, BinaryIO

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from workbench.pictures.experiments import page

if TYPE_CHECKING:
    from workbench.analysis.benchmark.bounds import BoundedDesign
    from workbench.analysis.benchmark.frontier import Course
    from workbench.analysis.benchmark.leds import LedDesign
    from workbench.analysis.benchmark.second_tracer import SeenTwice

_FONT = 8
_LETTERS = 16  # of that font, that an inch holds
_DPI = 130
_COLUMNS = 3
COLOURS = {
    "paper on torch": "#cbb8e4",
    "paper": "#8e6bbf",
    "transport": "#e0912f",
    "auto, before": "#9aa0a8",
    "auto": "#2f86d1",
}
_TRACED = (("difference", "o"), ("noise", "|"))
_ERRORS = (("sharp", "s"), ("bound", "|"), ("spots", "1"), ("light", "o"), ("lens", "^"))
_LIT = (("efficiency", "o"), ("merit", "^"), ("deviation", "|"))


def draw(name: str, rows: Sequence[Any], file: BinaryIO) -> None:
    """Draw the picture of a benchmark as PNG.

    Parameters
    ----------
    name : str
        Of the benchmark.
    rows : sequence
        What it has measured; at least one.
    file : binary file
        Where the picture goes.
    """
    _DRAWN[name](rows).savefig(file, format="png", dpi=_DPI)


def courses(rows: Sequence["Course"]) -> Figure:
    """Error over time, a panel for each scene."""
    scenes = list(dict.fromkeys(row.scene for row in rows))
    figure, panels = _panels(len(scenes), width=4.2, height=3.2)
    for axes, scene in zip(panels, scenes, strict=True):
        axes.set_title(scene, fontsize=_FONT + 2)
        for row in rows:
            if row.scene == scene and row.times:
                colour = COLOURS.get(row.method)
                # The best lens so far stays until there is a better one.
                axes.plot(
                    row.times,
                    row.errors,
                    "o-",
                    ms=3,
                    lw=1.4,
                    drawstyle="steps-post",
                    color=colour,
                    label=row.method,
                )
                if row.own_curve:
                    axes.plot(*zip(*row.own_curve, strict=True), ".", ms=2, alpha=0.5, color=colour)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter(FuncFormatter(_per_cent))
        axes.yaxis.set_minor_formatter(FuncFormatter(_per_cent_of_1_2_5))
        axes.set_xlabel("seconds", fontsize=_FONT)
        axes.set_ylabel("verified error", fontsize=_FONT)
        axes.tick_params(which="both", labelsize=_FONT)
        axes.grid(which="both", linewidth=0.5, alpha=0.3)
        if axes.lines:
            axes.legend(fontsize=_FONT, frameon=False)
    text = (
        "Relative L2 error of the best lens so far. Lines: traced anew by other means; dots: own "
        "error of the run, after each iteration."
    )
    width = round(_LETTERS * figure.get_figwidth())
    figure.supxlabel(textwrap.fill(text, width), fontsize=_FONT)
    return figure


def bounds(rows: Sequence["BoundedDesign"]) -> Figure:
    """Errors of lenses beside their bounds as marks on one logarithmic scale."""
    return _marks(rows, _ERRORS, "relative L2 error")


def leds(rows: Sequence["LedDesign"]) -> Figure:
    """How much light lands on a rectangle, and how evenly, as marks on one logarithmic scale."""
    return _marks(rows, _LIT, "part of the light; relative deviation of the irradiance")


def tracers(rows: Sequence["SeenTwice"]) -> Figure:
    """How far two tracers are apart, and by how much of that their rays scatter."""
    return _marks(rows, _TRACED, "relative L2 difference")


def _marks(rows: Sequence[Any], kinds: Sequence[tuple[str, str]], label: str) -> Figure:
    """Figures of scenes, each kind by a mark of its own."""
    figure = Figure(figsize=(7, 1.2 + 0.35 * len(rows)), layout="constrained")
    axes = figure.subplots()
    places = range(len(rows))
    for kind, mark in kinds:
        axes.plot([getattr(row, kind) for row in rows], places, mark, label=kind)
    axes.set_xscale("log")
    axes.set_yticks(places, [row.scene for row in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlabel(label, fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)
    axes.grid(linewidth=0.5, alpha=0.4)
    axes.legend(fontsize=_FONT)
    return figure


def _panels(count: int, width: float, height: float) -> tuple[Figure, list[Axes]]:
    columns = min(count, _COLUMNS)
    rows = math.ceil(count / columns)
    figure = Figure(figsize=(width * columns, height * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for axes in panels[count:]:
        axes.remove()
    return figure, panels[:count]


def _per_cent(value: float, _: object) -> str:
    return f"{100 * value:.3g} %"


def _per_cent_of_1_2_5(value: float, _: object) -> str:
    leading = round(value / 10.0 ** math.floor(math.log10(value)))
    return _per_cent(value, None) if leading in (2, 5) else ""


_DRAWN: dict[str, Callable[[Sequence[Any]], Figure]] = {
    "quick": courses,
    "frontier": courses,
    "large": courses,
    "bound": bounds,
    "led": leds,
    "mitsuba": tracers,
    "paper": page,
}
