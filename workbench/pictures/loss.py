"""Loss of a run, with other runs for comparison."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator

from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.axes import FONT, UpdatedPicture, label_curves
from workbench.powers import written

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.lines import Line2D

Against = Literal["iterations", "seconds"]

_EXTREMES = 1e-200, 1e200  # of an axis: ticks far beyond the ends are still finite
_SHORT_RANGE = 50
_NAME = 13  # width of a legend entry, in letters
_MARK = "#8a8f98"  # seen on light and dark
THIS_RUN = "#2f86d1"
CHECKED = "#d9822b"
# Okabe and Ito's colours that are visible on light and dark, with different strokes; those least
# like the colour of checks first.
OTHERS = (
    ("#009e73", "--"),
    ("#cc79a7", "-."),
    ("#56b4e9", (0, (1, 1))),
    ("#d55e00", (0, (7, 2))),
    ("#e69f00", (0, (3, 1, 1, 1, 1, 1))),
)


class LossCourse(NamedTuple):
    """Losses (k,) of a run and run times (k,) in seconds at the end of each iteration."""

    name: str
    losses: Array
    times: Array


class Verified(NamedTuple):
    """Verified loss of a lens, with the iterations and seconds of the run before it."""

    iteration: int
    seconds: float
    loss: float


class LossPicture(UpdatedPicture):
    """Loss against iterations or seconds, on axes of the caller.

    The limits are 1, 2 or 5 times a power of ten and change only when a curve leaves them.
    ``logarithmic`` says whether x and y have a logarithmic scale.
    """

    def __init__(
        self,
        axes: "Axes",
        against: Against = "iterations",
        logarithmic: tuple[bool, bool] = (False, True),
    ) -> None:
        self._axes = axes
        self._against = against
        self._logarithmic = logarithmic
        name = Message("iteration") if against == "iterations" else f"{Message('time')} (s)"
        label_curves(axes, name, Message("loss"))
        axes.set_xscale("log" if logarithmic[0] else "linear")
        axes.set_yscale("log" if logarithmic[1] else "linear")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
        axes.yaxis.set_major_formatter(FuncFormatter(_tick))
        self._others: list[Line2D] = []
        self._runs: tuple[LossCourse, ...] = ()
        self._has_points = False
        # Columns, top and lines of the legend.
        self._legend: tuple[int, float, list[Line2D]] = (0, 0.0, [])
        look = {"color": THIS_RUN, "linewidth": 1.5, "zorder": 3}
        (self._line,) = axes.plot([], [], **look, label=Message("this run"))  # type: ignore[arg-type]
        (self._points,) = axes.plot(
            [],
            [],
            "o",
            color=CHECKED,
            markersize=5,
            zorder=4,
            clip_on=False,
            label=Message("verified"),
        )
        self._points.set_in_layout(False)  # where there are none, they lie at 0, 0
        (self._end,) = axes.plot([], [], "o", color=THIS_RUN, markersize=4, zorder=3.5)
        self._end.set_clip_on(False)
        self._end.set_in_layout(False)
        self._value = axes.text(
            0.97, 0.94, "", transform=axes.transAxes, ha="right", va="top", fontsize=FONT + 1
        )
        self._stage_lines: list[Artist] = []
        self._stages_at: tuple[float, ...] = ()
        self._limits = (0.0, 0.0, 0.0, 0.0)
        self._set_limits((self._first_x(np.zeros(0)), 10.0, 1e-1, 1.0))
        self.artists = [self._line, self._points, self._end, self._value]

    def compare(self, runs: Sequence[LossCourse]) -> None:
        """Show other runs as well; the whole figure changes."""
        for line in self._others:
            line.remove()
        self._runs = tuple(runs)
        self._others = []
        for number, run in enumerate(runs):
            colour, stroke = OTHERS[number % len(OTHERS)]
            (line,) = self._axes.plot(
                self._x_values(run.losses, run.times),
                run.losses,
                color=colour,
                linestyle=stroke,
                linewidth=1.3,
                label=run.name,
            )
            self._others.append(line)
        self._update_legend()

    def update(
        self,
        losses: Array,
        iterations: int,
        stage_starts: tuple[int, ...] = (),
        times: Array | None = None,
        verified: Sequence[Verified] = (),
        loss: float | None = None,
    ) -> bool:
        """Show losses; return whether the whole figure has to be redrawn.

        `losses` (k,): after each iteration; `iterations`: least length of the axis; `stage_starts`:
        index of the first loss of each stage but the first; `times` (k,): run time at the end of
        each iteration; `verified`: checks of lenses of the run; `loss`: of the shown lens, by
        default the last one. It is higher after the last look of a run, in light of beams that the
        lens was not fitted to, and lower where an earlier lens was the best.
        """
        by_time = self._against == "seconds"
        x = self._x_values(losses, np.zeros(0) if times is None else times)
        self._line.set_data(x, losses)
        self._points.set_data(
            [v.seconds if by_time else v.iteration for v in verified], [v.loss for v in verified]
        )
        self._has_points = bool(verified)
        named = self._update_legend()
        last = losses[-1:] if loss is None else np.full(min(losses.size, 1), loss)
        self._end.set_data(x[-1:], last)
        self._value.set_text(written(last[0]) if last.size else "")
        starts = (float(x[start - 1]) for start in stage_starts if 0 < start <= x.size)
        marked = self._mark_stages(
            tuple(starts) if by_time else tuple(n + 0.5 for n in stage_starts)
        )
        x_values = np.concatenate([x, *(self._x_values(r.losses, r.times) for r in self._runs)])
        right = float(x_values.max(initial=0.0))
        right = _round(right, down=False) if by_time and right else max(right, iterations, 1.0)
        checked = np.array([v.loss for v in verified], dtype=np.float64)
        everything = np.concatenate([losses, last, checked, *(run.losses for run in self._runs)])
        seen = everything[np.isfinite(everything) & (everything > 0)]
        low, high = self._limits[2:]
        if seen.size:
            low, high = _round(float(seen.min()), down=True), _round(float(seen.max()), down=False)
        return self._set_limits((self._first_x(x_values), right, low, high)) or marked or named

    def _update_legend(self) -> bool:
        points = [self._points] if self._has_points else []
        named = [self._line, *points, *self._others]
        box = self._axes.bbox
        em = FONT * self._axes.get_figure(root=True).dpi / 72  # type: ignore[union-attr]
        line = 1.3 * em
        top = round(0.94 - line / max(box.height, line), 2)  # below the value
        rows, columns = int(top * box.height / line), int(box.width / (_NAME * em))
        columns = min(columns, math.ceil(len(named) / max(rows, 1)))
        if len(named) == 1 or rows * columns < len(named):
            columns = 0
        if (columns, top, named) == self._legend:
            return False
        self._legend = columns, top, named
        if legend := self._axes.get_legend():
            legend.remove()
        if columns:
            self._axes.legend(
                handles=named,
                loc="upper right",
                bbox_to_anchor=(1.0, top),  # curves fall from the left
                borderaxespad=0.2,
                ncols=columns,
                fontsize=FONT,
                frameon=False,
                labelcolor="linecolor",
                labelspacing=0.2,
            )
        return True

    def _x_values(self, losses: Array, times: Array) -> Array:
        if self._against == "seconds":
            return times
        return np.arange(1.0, losses.size + 1)

    def _first_x(self, x_values: Array) -> float:
        if not self._logarithmic[0]:
            return 0.0
        positive = x_values[x_values > 0]
        if self._against == "iterations" or not positive.size:
            return 1.0
        return _round(float(positive.min()), down=True)

    def _mark_stages(self, x_values: tuple[float, ...]) -> bool:
        if x_values == self._stages_at:
            return False
        for line in self._stage_lines:
            line.remove()
        self._stage_lines = [
            self._axes.axvline(x, color=_MARK, linewidth=1.0, linestyle=":") for x in x_values
        ]
        self._stages_at = x_values
        return True

    def _set_limits(self, limits: tuple[float, float, float, float]) -> bool:
        if limits == self._limits:
            return False
        self._limits = limits
        left, right, low, high = limits
        log_x, log_y = self._logarithmic
        right = max(right, 2 * left)  # a logarithmic axis with a single point
        self._axes.set_xlim(left, right)
        self._axes.set_ylim(low if log_y else 0.0, high)
        _set_ticks(self._axes.xaxis, log_x, left, right)
        _set_ticks(self._axes.yaxis, log_y, low, high)
        return True


def draw_courses(axes: "Axes", runs: Sequence[LossCourse]) -> None:
    """Draw the losses of several runs against iterations."""
    label_curves(axes, Message("iteration"), Message("loss"))
    axes.set_yscale("log")
    for run, (colour, stroke) in zip(runs, ((THIS_RUN, "-"), *OTHERS), strict=False):
        x_values = np.arange(1, run.losses.size + 1)
        axes.plot(x_values, run.losses, color=colour, linestyle=stroke, label=run.name)
    axes.legend(fontsize=FONT, frameon=False, labelcolor="linecolor")


def _set_ticks(axis: "Axis", logarithmic: bool, low: float, high: float) -> None:
    if logarithmic:
        short = high / low <= _SHORT_RANGE
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if short else (1.0,)))
    else:
        axis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))


def _tick(loss: float, _: int) -> str:
    return written(loss, digits=2)


def _round(value: float, *, down: bool) -> float:
    value = min(max(value, _EXTREMES[0]), _EXTREMES[1])
    decade = 10.0 ** math.floor(math.log10(value))
    steps = [step * decade for step in (0.5, 1, 2, 5, 10)]
    if down:
        return max(step for step in steps if step < value)
    return min(step for step in steps if step > value)
