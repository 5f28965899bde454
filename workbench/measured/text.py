"""Text of measured light: any encoding, line ends of any system, decimal points or commas."""

import re

import numpy as np

from workbench.errors import visible
from workbench.said import Said

_GAPS = re.compile(r"[\s,;]+")
_SPACES = re.compile(r"[\s;]+")
_END = "\x1a"  # which old programs write behind a text
_QUOTED = 20  # characters of a word that is wrong


def lines_of(content: bytes) -> list[str]:
    """Lines of a text in UTF-8 or, where it is none, in Latin-1; without spaces around them."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    text = text.replace("\r\n", "\n").replace("\r", "\n").rstrip(_END + "\0\n\t ")
    return [line.strip() for line in text.split("\n")]


def readings(text: str) -> tuple[list[str], ...]:
    """Words that may be numbers: with commas between them, and with commas as decimal points."""
    apart = [word for word in _GAPS.split(text) if word]
    if "," not in text:
        return (apart,)
    return apart, [word.replace(",", ".") for word in _SPACES.split(text) if word]


def number(word: str) -> float:
    """A finite number.

    Raises
    ------
    ValueError
        With what is wrong, if it is none.
    """
    try:
        value = float(word)
    except ValueError:
        raise ValueError(
            Said("{word!r} stands where a number is needed", word=word[:_QUOTED])
        ) from None
    if not np.isfinite(value):
        raise ValueError(
            Said("{word!r} stands where a finite number is needed", word=word[:_QUOTED])
        )
    return value


def count(word: str, least: int, most: int) -> int:
    """A whole number within limits.

    Raises
    ------
    ValueError
        With what is wrong, if it is none.
    """
    value = number(word)
    if value != int(value) or not least <= value <= most:
        raise ValueError(
            Said(
                "{word!r} stands where a whole number from {least} to {most} has to",
                word=word[:_QUOTED],
                least=least,
                most=most,
            )
        )
    return int(value)


def wrong_length(found: int, needed: int) -> Said:
    """What is wrong with a file that has another number of values than needed."""
    return Said("it is cut off") if found < needed else Said("it goes on behind its end")


def problem_in(error: ValueError) -> str:
    """What a reader says is wrong with a file, for a refusal."""
    problem = error.args[0] if error.args else ""
    return problem if isinstance(problem, Said) else visible(str(error))
