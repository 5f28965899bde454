"""What plans of a shop are asked for, with titles, tips and units."""

from dataclasses import dataclass
from typing import ClassVar

from workbench.option_groups import FEED, LENGTH, MINUTES, PERCENT, OptionGroup, option


@dataclass(frozen=True)
class PlanOptions(OptionGroup):
    """Wanted error, cutter, and what times of a plan are computed with; lengths in scene units."""

    called: ClassVar[str] = "plan"

    error: float | None = option(
        "Wanted error as made",
        "Relative L2 error of the image as made. Empty: 1.1 times the error as designed.",
        unit=PERCENT,
        most=1000.0,
        above=True,
        empty="1.1 times as designed",
    )
    ball: float | None = option(
        "Ball radius",
        "Radius of the ball cutter. Empty: the largest standard cutter that fits everywhere.",
        unit=LENGTH,
        above=True,
        empty="standard",
    )
    feed: float = option(
        "Feed", "Feed rate while cutting.", 600.0, unit=FEED, least=1, most=100_000
    )
    # No measured figure: the user enters that of the shop.
    polish_time: float = option(
        "Polish time",
        "Time to polish 1 cm² over a width of 0.1 mm, which grows with the square of the width. "
        "The default is an assumption.",
        0.2,
        unit=MINUTES,
        most=1e6,
        above=True,
    )
