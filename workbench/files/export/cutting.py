"""How a shop cuts a face."""

from dataclasses import dataclass

from workbench.errors import Refused
from workbench.said import Said


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
        Millimetres a minute.
    negative : bool
        Whether a mould of the face is cut, which is turned over like the face itself.
    """

    tool_radius: float | None = None
    scallop: float | None = None
    rim: float = 0.0
    safe_height: float | None = None
    feed: float = 600.0
    negative: bool = False

    def __post_init__(self) -> None:
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
