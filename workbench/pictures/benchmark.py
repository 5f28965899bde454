"""Pictures of benchmarks.

What is drawn has the attributes that the protocols name; see `workbench.analysis.benchmark`.
"""

import math
import textwrap
from collections.abc import Callable, Sequence
from itertools import groupby
from typing import Any, BinaryIO, Protocol

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from workbench.pictures.experiments import page

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
_BAR = "#2f86d1"
_KINDS = (("image", "o"), ("loss", "s"), ("gradient", "^"))
_TRACED = (("difference", "o"), ("noise", "|"))
_ERRORS = (("sharp", "s"), ("bound", "|"), ("spots", "1"), ("light", "o"), ("lens", "^"))
_LIT = (("efficiency", "o"), ("merit", "^"), ("deviation", "|"))


class CourseRow(Protocol):
    """Verified error of a method over time."""

    @property
    def scene(self) -> str:
        """Name of the scene."""

    @property
    def method(self) -> str:
        """Name of the method."""

    @property
    def times(self) -> Sequence[float]:
        """Seconds."""

    @property
    def errors(self) -> Sequence[float]:
        """Relative L2 errors at these times."""

    @property
    def own_curve(self) -> Sequence[tuple[float, float]]:
        """Time and the method's own error after each iteration."""


class TimeRow(Protocol):
    """Time of a variant."""

    @property
    def question(self) -> str:
        """What is compared."""

    @property
    def variant(self) -> str:
        """Which of it this is."""

    @property
    def milliseconds(self) -> float:
        """Median time."""

    @property
    def ratio(self) -> float:
        """Times the first variant of the question."""


class DifferenceRow(Protocol):
    """Float32 against float64."""

    @property
    def scene(self) -> str:
        """Name of the scene."""

    @property
    def image(self) -> float:
        """Relative difference of the image."""

    @property
    def loss(self) -> float:
        """The same of the loss."""

    @property
    def gradient(self) -> float:
        """The same of the gradient."""


class BoundRow(Protocol):
    """Errors of a lens and of what it could be."""

    @property
    def scene(self) -> str:
        """Name of the scene."""

    @property
    def sharp(self) -> float:
        """Of the sharp lens, blurred."""

    @property
    def bound(self) -> float:
        """What no lens is below."""

    @property
    def spots(self) -> float:
        """What no light in spots is below."""

    @property
    def light(self) -> float:
        """Of the best light."""

    @property
    def lens(self) -> float:
        """Of the designed lens."""


class LedRow(Protocol):
    """Light of an LED on a rectangle."""

    @property
    def scene(self) -> str:
        """The faces of the lens."""

    @property
    def efficiency(self) -> float:
        """Part of the light that lands on the rectangle."""

    @property
    def deviation(self) -> float:
        """Relative standard deviation of the irradiance there."""

    @property
    def merit(self) -> float:
        """Efficiency × (1 − deviation)."""


class TracedRow(Protocol):
    """One lens in two tracers."""

    @property
    def scene(self) -> str:
        """What is traced."""

    @property
    def difference(self) -> float:
        """Of both images."""

    @property
    def noise(self) -> float:
        """What it would be by the scatter of rays alone."""


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


def courses(rows: Sequence[CourseRow]) -> Figure:
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


def comparisons(rows: Sequence[TimeRow]) -> Figure:
    """Times as bars, a panel for each question."""
    questions = [(name, list(each)) for name, each in groupby(rows, lambda row: row.question)]
    figure, panels = _panels(len(questions), width=4.6, height=2.2)
    for axes, (question, variants) in zip(panels, questions, strict=True):
        places = range(len(variants))
        times = [each.milliseconds for each in variants]
        axes.barh(places, times, color=_BAR, height=0.6)
        for place, each in zip(places, variants, strict=True):
            caption = f" {each.milliseconds:{'.0f' if each.milliseconds >= 100 else '.3g'}} ms"
            if place:
                caption += f", × {each.ratio:.2g}"
            axes.text(each.milliseconds, place, caption, va="center", fontsize=_FONT)
        axes.set_yticks(places, [each.variant for each in variants])
        axes.set_xlim(0, 1.45 * max(times))
        axes.set_ylim(len(variants) - 0.5, -0.5)
        axes.set_title(question, fontsize=_FONT + 1, loc="left")
        axes.tick_params(labelsize=_FONT)
        axes.spines[["top", "right"]].set_visible(False)
    return figure


def differences(rows: Sequence[DifferenceRow]) -> Figure:
    """Relative differences as marks on one logarithmic scale."""
    return _marks(rows, _KINDS, "relative difference of float32 from float64")


def bounds(rows: Sequence[BoundRow]) -> Figure:
    """Errors of lenses beside their bounds as marks on one logarithmic scale."""
    return _marks(rows, _ERRORS, "relative L2 error")


def leds(rows: Sequence[LedRow]) -> Figure:
    """How much light lands on a rectangle, and how evenly, as marks on one logarithmic scale."""
    return _marks(rows, _LIT, "part of the light; relative deviation of the irradiance")


def tracers(rows: Sequence[TracedRow]) -> Figure:
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
    "kernels": comparisons,
    "precision": differences,
    "skips": comparisons,
    "bound": bounds,
    "led": leds,
    "mitsuba": tracers,
    "paper": page,
}
