"""Why runs end, in words, and how these are found again in what a file says.

A session keeps the English sentence alone, as other programs read it.
"""

import re
from string import Formatter

from workbench.said import Said

DONE = "all iterations are done"
LOCKED = "all control points are locked"
STOPPED = "stopped"
SMALL = "converged: error below {error:g} %"
LOWEST = "converged: no step makes the image better"
SLOW = "converged: less than {gain:g} % better in {patience} iterations"
FLAT = "converged: error less than {points:g} percentage points lower in {patience} iterations"
IN_VAIN = "{ended}; no iteration made the lens better"
NO_IMAGE = "{ended}; the exit face alone makes no image"
GAINED = (
    "{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that "
    "of the exit face behind a flat entrance"
)
FAILED = "failed: {why}"

ENDINGS = (DONE, LOCKED, STOPPED, SMALL, LOWEST, SLOW, FLAT, IN_VAIN, NO_IMAGE, GAINED)
"""All but failures, whose reasons are without number."""


class _AsRead(str):
    """A value as a sentence had it, whatever format it is put in again with."""

    def __format__(self, spec: str) -> str:
        return str(self)


def ending(text: str) -> str:
    """Why a run ended, as a sentence with values where it is one of `ENDINGS`.

    Parameters
    ----------
    text : str
        As a file has it.

    Examples
    --------
    >>> ending("converged: error below 0.1 %; no iteration made the lens better").words
    '{ended}; no iteration made the lens better'
    >>> ending("by hand")
    'by hand'
    """
    for words in ENDINGS:
        if found := re.fullmatch(_pattern(words), text):
            values = {name: _AsRead(value) for name, value in found.groupdict().items()}
            if "ended" in values:
                return Said(words, **values | {"ended": ending(values["ended"])})
            return Said(words, **values)
    return text


def _pattern(words: str) -> str:
    return "".join(
        re.escape(literal) + (f"(?P<{name}>.+)" if name else "")
        for literal, name, _, _ in Formatter().parse(words)
    )
