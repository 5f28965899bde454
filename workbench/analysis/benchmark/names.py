"""The benchmarks by name. Nothing else is imported here, so that help comes at once."""

BENCHMARKS = {
    "quick": "verified error against time on two small scenes, within two minutes",
    "frontier": "verified error against time: every kind of scene, each method",
    "large": "the same for a photograph of 256², 512² and 1024² pixels: time a pixel, memory",
    "bound": "lenses for four pictures in the sun, and what no lens is below",
    "led": "lenses close to an LED: how much light lands on a rectangle, and how evenly",
    "mitsuba": "the check beside Mitsuba 3: every source, receiver and outline; an hour or so",
    "trains": "the same of the examples of several elements and of white light, designed first",
    "paper": "all experiments of the paper: a table, and a page of pictures",
}
"""What each measures."""

WITH_CURVES = ("quick", "frontier", "large")
"""Those that measure error against time."""

DEFAULT = "quick"
"""What runs when none is named."""
