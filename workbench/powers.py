"""Numbers as text, with a power of ten before the unit in place of many zeros: 52.34 · 10⁻⁶ mm."""

import math
import re

import numpy as np

from workbench.units import METRES, sized

_PLAIN = 1e-2, 1e5  # range of the largest number of a scale without a power
_LEAST_ALONE = 1e-3  # least single number without a power
_MICRO = 1e-5  # metres, below which lengths are in micrometres
_HIGH = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_POWER = re.compile(r"10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+ ")


def power_of(low: float, high: float) -> int:
    """Return the exponent for a scale between two ends: a multiple of 3, 0 for no power.

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


def written(value: float, unit: str = "", digits: int = 4) -> str:
    """Return a number with its unit, at most ``digits`` significant digits, without end zeros.

    Without a unit the exponent may be any, else it is a multiple of 3. Lengths of less than 10 µm
    are in micrometres, except those in inches.

    Examples
    --------
    >>> written(-6.024e-5, "/ mm²"), written(0.00123, "mm"), written(12_345, "lx", 3)
    ('-60.24 · 10⁻⁶ / mm²', '1.23 µm', '12300 lx')
    >>> written(6.02e-7), written(1e-6), written(30.0, "°"), written(2.5e6, "cd")
    ('6.02 · 10⁻⁷', '10⁻⁶', '30°', '2.5 · 10⁶ cd')
    """
    if unit in METRES and unit != "inch" and 0 < abs(value) * float(METRES[unit]) < _MICRO:
        value, unit = value * float(METRES[unit] * 10**6), "µm"
    value = rounded(value, digits)
    power = 0 if _LEAST_ALONE <= abs(value) < _PLAIN[1] else power_of(value, value)
    if not power:
        return _with_unit(_positional(value), unit)
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    if not unit:
        power = int(exponent)
    number = _positional(rounded(float(mantissa) * 10.0 ** (int(exponent) - power), digits))
    ten = _ten(power)
    return ten if number == "1" and not unit else _with_unit(f"{number} · {ten}", unit)


def with_power(name: str, power: int) -> str:
    """Return the label of an axis with a power before its unit.

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
    unit, ten = name[start:], _ten(power)
    ours = ten + unit.removeprefix("1") if unit.startswith("1 /") else f"{ten} {unit}"
    return name[:start] + ours


def without_power(name: str) -> str:
    """Return the label of an axis without a power.

    Examples
    --------
    >>> without_power("mean curvature (10⁻³ / mm)"), without_power("10³ lx"), without_power("%")
    ('mean curvature (1 / mm)', 'lx', '%')
    """
    return _POWER.sub(lambda ten: "1 " if name[ten.end()] == "/" else "", name, count=1)


def rounded(value: float, digits: int) -> float:
    """Round to significant digits; zero has no sign.

    Examples
    --------
    >>> rounded(-129.4939478, 5), rounded(0.012345, 2)
    (-129.49, 0.012)
    """
    return float(f"{value:.{digits}g}") + 0.0


def _positional(value: float) -> str:
    return np.format_float_positional(value, trim="-")


def _with_unit(number: str, unit: str) -> str:
    return sized(number, unit) if unit else number


def _ten(power: int) -> str:
    return "10" + str(power).translate(_HIGH)
