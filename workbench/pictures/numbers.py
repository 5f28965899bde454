"""Numbers at axes and colour bars, with as many decimals as they need and no more.

A scale that ends at 0.00005 has numbers of seven signs. Its name tells a power of ten in front of
the unit instead, as in "height (10⁻⁶ mm)", and the numbers go from 0 to 50. The powers are those of
the prefixes of units.
"""

import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from matplotlib.ticker import Formatter, ScalarFormatter

from workbench.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Direction = Literal["x", "y"]

_PLAIN = 1e-2, 1e5  # largest numbers that are written without a power, and from where on not
_MOST_DECIMALS = 12
_SLACK = 1e-4  # of the length of the scale that numbers may be rounded by
_HIGH = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_POWER = re.compile(r"10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+ ")


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


def power_of(low: float, high: float) -> int:
    """The exponent for a scale between two ends: a multiple of 3; 0 where no power is needed.

    Examples
    --------
    >>> power_of(0, 5e-5), power_of(-0.004, 0.002), power_of(0, 0.01), power_of(0, 250_000)
    (-6, -3, 0, 3)
    """
    largest = max(abs(low), abs(high))
    if not 0 < largest < math.inf or _PLAIN[0] <= largest < _PLAIN[1]:
        return 0
    exponent = int(f"{largest:e}".partition("e")[2])
    return 3 * (exponent // 3)


def with_power(name: str, power: int) -> str:
    """What stands at an axis, with a power in front of its unit.

    Examples
    --------
    >>> with_power("height (mm)", -6)
    'height (10⁻⁶ mm)'
    >>> with_power("mean curvature (1 / mm)", -3), with_power("lx", 3)
    ('mean curvature (10⁻³ / mm)', '10³ lx')
    """
    name = without_power(name)
    if not power:
        return name
    start = name.rindex(" (") + 2 if " (" in name else 0
    unit, ten = name[start:], "10" + str(power).translate(_HIGH)
    ours = ten + unit.removeprefix("1") if unit.startswith("1 /") else f"{ten} {unit}"
    return name[:start] + ours


def without_power(name: str) -> str:
    """What stands at an axis, in the unit itself.

    Examples
    --------
    >>> without_power("mean curvature (10⁻³ / mm)"), without_power("10³ lx"), without_power("%")
    ('mean curvature (1 / mm)', 'lx', '%')
    """
    return _POWER.sub(lambda ten: "1 " if name[ten.end()] == "/" else "", name, count=1)


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
