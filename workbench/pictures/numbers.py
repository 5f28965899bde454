"""Numbers at axes and colour bars, with as many decimals as they need and no more.

A scale that ends at 0.00005 has numbers of seven signs. Its name tells a power of ten in front of
the unit instead, as in "height (10⁻⁶ mm)", and the numbers go from 0 to 50.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from matplotlib.ticker import Formatter, ScalarFormatter

from workbench.arrays import Array
from workbench.powers import power_of, with_power

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Direction = Literal["x", "y"]

_MOST_DECIMALS = 12
_SLACK = 1e-4  # of the length of the scale that numbers may be rounded by


class Numbers(Formatter):
    """Writes the numbers of an even scale as multiples of its power of ten.

    Attributes
    ----------
    power : int
        The exponent.
    """

    power = 0

    def __call__(self, x: float, pos: int | None = None) -> str:
        """One number."""
        return self.format_ticks([x])[0]

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        """Numbers with one count of decimals."""
        low, high = self.axis.get_view_interval()  # type: ignore[union-attr]
        ten = 10.0**self.power
        numbers, slack = np.asarray(values) / ten, _SLACK * abs(high - low) / ten
        fits = (n for n in range(_MOST_DECIMALS) if _rounding(numbers, n) <= slack)
        decimals = next(fits, _MOST_DECIMALS)
        rounded = numbers.round(decimals) + 0.0  # for zeros that would be written as -0
        return [self.fix_minus(f"{number:.{decimals}f}") for number in rounded]


def write_numbers(axes: "Axes", direction: Direction) -> None:
    """Write the numbers of an axis so from now on, also when its limits or its scale change.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Their axis has its name already; a later one gets the power when limits are set next.
    direction : {"x", "y"}
        Which axis.
    """
    axis = getattr(axes, f"{direction}axis")
    axis.set_major_formatter(Numbers())
    axes.callbacks.connect(f"{direction}lim_changed", lambda _: _tell_power(axis))
    _tell_power(axis)


def write_bar_numbers(bar: Any) -> None:
    """Write the numbers of an upright colour bar so, as far as they are even."""
    bar.formatter = Numbers()
    bar.ax.callbacks.connect("ylim_changed", lambda _: _tell_power(bar.ax.yaxis))
    _tell_power(bar.ax.yaxis)


def _rounding(numbers: Array, decimals: int) -> float:
    """By how much numbers with so many decimals are off at most."""
    return float(np.abs(numbers.round(decimals) - numbers).max(initial=0.0))


def _tell_power(axis: Any) -> None:
    """Choose the power of an axis by its limits, and name it with that."""
    if isinstance(axis.get_major_formatter(), ScalarFormatter):  # a bar gets it with another norm
        axis.set_major_formatter(Numbers())
    formatter, power = axis.get_major_formatter(), 0
    if isinstance(formatter, Numbers):
        formatter.power = power = power_of(*axis.get_view_interval())
    axis.set_label_text(with_power(axis.get_label_text(), power))
