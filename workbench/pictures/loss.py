"""The loss curve of a run."""

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

Array = npt.NDArray[np.float64]

_FONT = 8
_SHORT_RANGE = 50
_MARK = "#8a8f98"  # seen on light and dark


class LossCurve:
    """Loss over iterations, logarithmic, on axes that the caller owns.

    The limits are 1, 2 or 5 times a power of ten and change only when the curve leaves them.

    Attributes
    ----------
    artists : list of matplotlib.artist.Artist
        What `update` changes; the caller may blit them.
    """

    def __init__(self, axes: "Axes") -> None:
        self._axes = axes
        axes.set_yscale("log")
        axes.yaxis.set_minor_locator(NullLocator())
        axes.yaxis.set_major_formatter(FuncFormatter(lambda loss, _: f"{loss:.0e}"))
        axes.set_xlabel("iteration", fontsize=_FONT, labelpad=2)
        axes.set_ylabel("loss", fontsize=_FONT, labelpad=2)
        axes.tick_params(which="both", labelsize=_FONT)
        axes.grid(visible=True, which="major", linewidth=0.6, alpha=0.35)
        (self._line,) = axes.plot([], [], color="#2f86d1", linewidth=1.5)
        self._value = axes.text(
            0.97, 0.94, "", transform=axes.transAxes, ha="right", va="top", fontsize=_FONT + 1
        )
        self._marks: list[Artist] = []
        self._marked: tuple[int, ...] = ()
        self._limits = (0.0, 0.0, 0.0)  # right end, lower and upper end
        self._set_limits(10.0, 1e-1, 1.0)
        self.artists: list[Artist] = [self._line, self._value]

    def update(self, losses: Array, iterations: int, stage_starts: tuple[int, ...] = ()) -> bool:
        """Show another course of the loss.

        Parameters
        ----------
        losses : ndarray, shape (k,)
            Loss after each iteration; on a logarithmic axis only positive ones are seen.
        iterations : int
            Iterations that the axis should hold at least.

        stage_starts : tuple of int
            Numbers of losses before each stage but the first; marked by upright lines.

        Returns
        -------
        bool
            Whether more than `artists` changed, so that the whole figure has to be drawn.
        """
        steps = np.arange(1, losses.size + 1)
        self._line.set_data(steps, losses)
        self._value.set_text(f"{losses[-1]:.3g}" if losses.size else "")
        marked = self._mark(stage_starts)
        right = float(max(iterations, losses.size, 1))
        seen = losses[np.isfinite(losses) & (losses > 0)]
        if not seen.size:
            return self._set_limits(right, *self._limits[1:]) or marked
        low, high = _round(float(seen.min()), down=True), _round(float(seen.max()), down=False)
        return self._set_limits(right, low, high) or marked

    def _mark(self, stage_starts: tuple[int, ...]) -> bool:
        if stage_starts == self._marked:
            return False
        for line in self._marks:
            line.remove()
        self._marks = [
            self._axes.axvline(start + 0.5, color=_MARK, linewidth=1.0, linestyle=":")
            for start in stage_starts
        ]
        self._marked = stage_starts
        return True

    def _set_limits(self, right: float, low: float, high: float) -> bool:
        if (right, low, high) == self._limits:
            return False
        self._limits = (right, low, high)
        self._axes.set_xlim(0, right)
        self._axes.set_ylim(low, high)
        # Few enough labels for a low dock, and still two on a short range.
        short = high / low <= _SHORT_RANGE
        steps = (1.0, 2.0, 5.0) if short else (1.0,)
        self._axes.yaxis.set_major_locator(LogLocator(subs=steps))
        return True


def _round(value: float, *, down: bool) -> float:
    """The nearest 1, 2 or 5 times a power of ten strictly below or above ``value``."""
    decade = 10.0 ** math.floor(math.log10(value))
    steps = [step * decade for step in (0.5, 1, 2, 5, 10)]
    if down:
        return max(step for step in steps if step < value)
    return min(step for step in steps if step > value)
