"""The benchmarks by name, and their settings. Nothing slow is imported: help comes at once."""

from typing import NamedTuple

BENCHMARKS = {
    "quick": "verified error against time on two small scenes, within two minutes",
    "pictures": "photographs, words and line art: error, time, memory, and all images",
    "frontier": "verified error against time: every kind of scene, each method",
    "bound": "lenses for four pictures in the sun, and what no lens is below",
    "led": "lenses close to an LED: how much light lands on a rectangle, and how evenly",
    "mitsuba": "the check beside Mitsuba 3: every source, receiver and outline; an hour or so",
    "trains": "the same of the examples of several elements and of white light, designed first",
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
