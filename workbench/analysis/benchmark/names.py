"""The benchmarks by name, and their settings. Nothing slow is imported: help comes at once."""

from typing import NamedTuple

BENCHMARKS = {
    "quick": "verified error against time on two small scenes, within two minutes",
    "pictures": "real pictures and words: error, time, memory, images",
    "frontier": "verified error against time: every kind of scene, each method",
    "bound": "lenses for four pictures in the sun, and what no lens is below",
    "led": "lenses close to an LED: light on a rectangle, evenness",
    "mitsuba": "the check beside Mitsuba 3, for an hour or so",
    "trains": "the same of trains and of white light, designed first",
    "paper": "all experiments of the paper: a table, and a page of pictures",
}
"""What each measures."""

WITH_CURVES = ("quick", "frontier")
"""Those that measure error against time."""

WITH_PICTURES = "pictures"
"""The one whose pictures can be chosen."""

DEFAULT = "quick"
"""What runs when none is named."""


class Settings(NamedTuple):
    """Effort of benchmarks."""

    iterations: int | None = None  # of every design; None leaves it to each scene
    pixels: int | None = None  # a side of each picture; None: as many as usual
    only: tuple[str, ...] = ()  # names of pictures; empty for all
