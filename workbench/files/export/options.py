"""Options of exports: cutting of a face, and the unit of meshes."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from workbench.errors import Refused, shown
from workbench.messages import Message
from workbench.units import METRES

MILLIMETRES, SCENE_UNIT = "mm", "scene"
"""The unit that programs assume for a mesh without a unit, and the name for the scene's unit."""
MESH_UNITS = (*METRES, SCENE_UNIT)
"""Names of units of a mesh."""


class Range(NamedTuple):
    """Range of a field of `Cutting`, and its unit."""

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
"""Ranges of fields that are not lengths."""


@dataclass(frozen=True)
class Cutting:
    """Options of a finishing pass with a ball cutter; lengths in scene units.

    Raise Refused if a value is out of range, or scallops are as high as the ball's radius.

    Attributes
    ----------
    tool_radius : float, optional
        Radius of the ball; by default that of the scene's cutter, or one that fits.
    scallop : float, optional
        Largest scallop height; 1e-4 of the larger half-width by default.
    rim : float
        Width of stock around the lens, for clamping.
    safe_height : float, optional
        Height of travel above the highest cut; the cutter's diameter by default.
    feed : float
        Speed of cuts, mm/min.
    plunge_feed : float
        Speed into the stock, mm/min.
    spindle_speed : float
        Revolutions per minute.
    dwell : float
        Seconds that the cutter waits above the stock for the spindle.
    negative : bool
        Whether a mould of the face is cut.
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
                raise Refused(name, Message("{value:g}; a length above 0", value=value))
        if not 0 <= self.rim < math.inf:
            raise Refused("rim", Message("{value:g}; a length of 0 or more", value=self.rim))
        for name, (least, most, unit) in RANGES.items():
            value = getattr(self, name)
            if not least <= value <= most:
                raise Refused(
                    name,
                    Message(
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
                Message(
                    "{ridge:g}; less than the cutter's radius {radius:g} is needed",
                    ridge=ridge,
                    radius=radius,
                ),
            )


PLAIN = Cutting()
"""Default options."""


def mesh_unit_of(asked: str, scene_unit: str) -> str:
    """Return the unit of length for a requested name; raise Refused if it is unknown."""
    if asked not in MESH_UNITS:
        known = ", ".join(MESH_UNITS)
        raise Refused(
            "mesh_unit", Message("{unit}; one of {known}", unit=shown(asked), known=known)
        )
    return scene_unit if asked == SCENE_UNIT else asked
