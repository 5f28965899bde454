"""Kinds of values that arguments take."""

import argparse
import math
from collections.abc import Callable
from contextlib import suppress

from workbench.analysis.tracing.ray_limit import MOST_RAYS

_MOST_DISTANCES = 1000
_MOST_STOPS = 20.0
_LARGEST_EXACT = 2.0**53  # above it, a float64 stands for several whole numbers


def positive(text: str) -> float:
    """A number greater than 0; may be infinite."""
    with suppress(ValueError):
        if (number := float(text)) > 0:
            return number
    raise argparse.ArgumentTypeError(f"{text!r}; a number greater than 0 is needed")


def length(text: str) -> float:
    """A finite number greater than 0."""
    number = positive(text)
    if math.isinf(number):
        raise argparse.ArgumentTypeError(f"{text!r}; a finite number is needed")
    return number


def ranged(least: float, most: float, unit: str) -> Callable[[str], float]:
    """Numbers within a range."""

    def read(text: str) -> float:
        with suppress(ValueError):
            if least <= (number := float(text)) <= most:
                return number
        raise argparse.ArgumentTypeError(
            f"{text!r}; a number from {least:g} to {most:,g} {unit} is needed"
        )

    return read


def stops(text: str) -> float:
    """An exposure: powers of two of brightness."""
    with suppress(ValueError):
        if abs(number := float(text)) <= _MOST_STOPS:
            return number
    most = _MOST_STOPS
    raise argparse.ArgumentTypeError(f"{text!r}; a number from {-most:g} to {most:g} is needed")


def count(text: str) -> int:
    """A whole number greater than 0; 1e6 and 16e6 too."""
    with suppress(ValueError):
        if (number := int(text)) > 0:
            return number
    with suppress(ValueError):
        if (written := float(text)).is_integer() and 0 < written <= _LARGEST_EXACT:
            return int(written)
    raise argparse.ArgumentTypeError(f"{text!r}; a whole number greater than 0 is needed")


def rays(text: str) -> int:
    """A number of rays that a check may have."""
    number = count(text)
    if number > MOST_RAYS:
        raise argparse.ArgumentTypeError(f"{text!r} are too many; at most {MOST_RAYS}")
    return number


def distances(text: str) -> tuple[float, ...]:
    """Equal steps: ``first:last:number``."""
    with suppress(ValueError):
        first, last, number = text.split(":")
        low, high, steps = float(first), float(last), int(number)
        if math.isfinite(high - low) and high > low and 2 <= steps <= _MOST_DISTANCES:
            return tuple(low + (high - low) * step / (steps - 1) for step in range(steps))
    raise argparse.ArgumentTypeError(
        f"{text!r}; first:last:number is needed, as in 4:6:9, with 2 to {_MOST_DISTANCES} of them"
    )
