"""Loss of a run, with other runs for comparison."""

import math
from collections.abc import Sequence
from itertools import chain, cycle
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator

from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.axes import FONT, label_curves
from workbench.powers import written

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_EXTREMES = 1e-200, 1e200  # of the axis: ticks far beyond the ends are still finite
_SHORT_RANGE = 50
_MARK = "#8a8f98"  # seen on light and dark
THIS_RUN = "#2f86d1"
CHECKED = "#d9822b"
OTHERS = (
    ("#009e73", "--"),
    ("#cc79a7", "-."),
    ("#56b4e9", (0, (1, 1))),
    ("#d55e00", (0, (7, 2))),
    ("#e69f00", (0, (3, 1, 1, 1, 1, 1))),
)
"""Okabe and Ito's colours that are visible on light and dark, with different strokes; those least
like the colour of checks first."""


class LossCourse(NamedTuple):
    """Losses (k,) of a run at the end of each iteration."""

    name: str
    losses: Array


class Verified(NamedTuple):
    """Verified loss of a lens, with the iterations of the run before it."""

    iteration: int
    loss: float


def draw_loss(
    axes: "Axes",
    losses: Array,
    stage_starts: Sequence[int] = (),
    loss: float | None = None,
    verified: Sequence[Verified] = (),
    others: Sequence[LossCourse] = (),
) -> None:
    """Draw the loss of a run over its iterations, on axes of the caller.

    `losses` (k,): after each iteration; `stage_starts`: index of the first loss of each stage but
    the first; `loss`: of the shown lens, by default the last one; `verified`: checks of lenses of
    the run; `others`: runs for comparison. The loss of the shown lens is higher after the last look
    of a run, in light of beams that the lens was not fitted to, and lower where an earlier lens was
    the best.
    """
    draw_courses(axes, [LossCourse(Message("this run"), losses), *others])
    for start in stage_starts:
        axes.axvline(start + 0.5, color=_MARK, linewidth=1.0, linestyle=":")
    at, checked = np.array(verified).reshape(-1, 2).T
    if verified:
        axes.plot(at, checked, "o", color=CHECKED, markersize=5, label=Message("verified"))
    last = losses[-1:] if loss is None else np.full(min(losses.size, 1), loss)
    _fit(axes, np.concatenate([losses, checked, last, *(other.losses for other in others)]))
    if losses.size:
        axes.plot([losses.size], last, "o", color=THIS_RUN, markersize=4, clip_on=False)
        axes.text(
            0.97,
            0.94,
            written(last[0]),
            transform=axes.transAxes,
            ha="right",
            va="top",
            fontsize=FONT,
        )
    legend = axes.get_legend()
    if verified or others:
        axes.legend(fontsize=FONT, frameon=False, labelcolor="linecolor", loc="center right")
    elif legend is not None:
        legend.remove()


def draw_courses(axes: "Axes", runs: Sequence[LossCourse]) -> None:
    """Draw the losses of several runs over their iterations."""
    label_curves(axes, Message("iteration"), Message("loss"))
    axes.set_yscale("log")
    looks = chain([(THIS_RUN, "-")], cycle(OTHERS))
    for run, (colour, stroke) in zip(runs, looks, strict=False):
        x_values = np.arange(1, run.losses.size + 1)
        axes.plot(x_values, run.losses, color=colour, linestyle=stroke, label=run.name)
    axes.legend(fontsize=FONT, frameon=False, labelcolor="linecolor")
    _fit(axes, np.concatenate([np.zeros(0), *(run.losses for run in runs)]))


def _fit(axes: "Axes", every: Array) -> None:
    seen = every[np.isfinite(every) & (every > 0)]
    if seen.size:
        low, high = _round(float(seen.min()), down=True), _round(float(seen.max()), down=False)
        axes.set_ylim(low, high)
        subs = (1.0, 2.0, 5.0) if high / low <= _SHORT_RANGE else (1.0,)
        axes.yaxis.set_major_locator(LogLocator(subs=subs))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda loss, _: written(loss, digits=2)))
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True))
    axes.set_xlim(left=0)


def _round(value: float, *, down: bool) -> float:
    value = min(max(value, _EXTREMES[0]), _EXTREMES[1])
    decade = 10.0 ** math.floor(math.log10(value))
    steps = [step * decade for step in (0.5, 1, 2, 5, 10)]
    if down:
        return max(step for step in steps if step < value)
    return min(step for step in steps if step > value)
