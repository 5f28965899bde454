"""How a shop cuts a face."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from workbench.errors import Refused
from workbench.said import Said


class Range(NamedTuple):
    """Values that a field of `Cutting` may have, and their unit."""

    least: float
    most: float
    unit: str


FEED, SPINDLE, DWELL = "mm/min", "rpm", "s"
RANGES = {
    "feed": Range(1, 100_000, FEED),
    "plunge_feed": Range(1, 100_000, FEED),
    "spindle_speed": Range(1, 200_000, SPINDLE),
    "dwell": Range(0, 600, DWELL),
}
"""Fields that are no lengths."""


@dataclass(frozen=True)
class Cutting:
    """A finishing pass of a ball cutter; lengths in scene units.

    Attributes
    ----------
    tool_radius : float, optional
        Radius of the ball; by default that of the scene's cutter, or one that fits.
    scallop : float, optional
        Largest height of the ridges between cuts; 1e-4 of the larger half-width by default.
    rim : float
        Width of stock around the lens, to clamp it by.
    safe_height : float, optional
        How far over its highest cut the cutter travels; its diameter by default.
    feed : float
        Speed of cuts, millimetres a minute.
    plunge_feed : float
        Speed at which the cutter goes down into the stock, millimetres a minute.
    spindle_speed : float
        Revolutions a minute.
    dwell : float
        Seconds that the cutter waits above the stock until the spindle is at its speed.
    negative : bool
        Whether a mould of the face is cut, which is turned over like the face itself.

    Raises
    ------
    Refused
        If a value is not within its range, or ridges are as high as the ball.
    """

    tool_radius: float | None = None
    scallop: float | None = None
    rim: float = 0.0
    safe_height: float | None = None
    feed: float = 600.0
    plunge_feed: float = 150.0
    spindle_speed: float = 10_000.0
    dwell: float = 3.0
    negative: bool = False

    def __post_init__(self) -> None:
        for name in ("tool_radius", "scallop", "safe_height"):
            value = getattr(self, name)
            if value is not None and not 0 < value < math.inf:
                raise Refused(name, Said("{value:g}; a length above 0", value=value))
        if not 0 <= self.rim < math.inf:
            raise Refused("rim", Said("{value:g}; a length of 0 or more", value=self.rim))
        for name, (least, most, unit) in RANGES.items():
            value = getattr(self, name)
            if not least <= value <= most:
                raise Refused(
                    name,
                    Said(
                        "{value:g} {unit}; from {least:g} to {most:,} {unit}",
                        value=value,
                        unit=unit,
                        least=least,
                        most=most,
                    ),
                )
        radius, ridge = self.tool_radius, self.scallop
        if radius is not None and ridge is not None and ridge >= radius:
            raise Refused(
                "scallop",
                Said(
                    "{ridge:g}; less than the cutter's radius {radius:g} is needed",
                    ridge=ridge,
                    radius=radius,
                ),
            )


PLAIN = Cutting()
"""Nothing is said of it."""
