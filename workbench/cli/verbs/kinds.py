"""Kinds of values that arguments take."""

import argparse
import math
from contextlib import suppress


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


def count(text: str) -> int:
    """A whole number greater than 0."""
    with suppress(ValueError):
        if (number := int(text)) > 0:
            return number
    raise argparse.ArgumentTypeError(f"{text!r}; a whole number greater than 0 is needed")
