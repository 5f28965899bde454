"""Units of length and their conversion."""

from fractions import Fraction

METRES = {
    "mm": Fraction(1, 1000),
    "cm": Fraction(1, 100),
    "m": Fraction(1),
    "inch": Fraction(254, 10_000),
}
"""The units that a scene can have, in metres."""


def ratio(unit: str, other: str) -> Fraction:
    """Return one unit in another unit, exactly."""
    return METRES[unit] / METRES[other]


def sized(number: str, unit: str) -> str:
    """A number with its unit; the sign of degrees follows without a space."""
    return f"{number}{unit}" if unit == "°" else f"{number} {unit}"


def times(number: float, factor: Fraction) -> float:
    """Multiply the decimal number as written: 0.3 mm are 0.03 cm, not 0.03 + 3e-18."""
    return float(Fraction(repr(number)) * factor)


WRITTEN = METRES | {
    "in": METRES["inch"],
    '"': METRES["inch"],
    "µm": METRES["mm"] / 1000,  # the micro sign, and the Greek letter
    "μm": METRES["mm"] / 1000,
    "um": METRES["mm"] / 1000,
    "nm": METRES["mm"] / 1_000_000,
}
"""Units that may be typed after a length, in metres."""
