"""How many samples a lens needs along an axis, by the pixels that they light and by its net."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Density:
    """Samples along an axis, or cells between them."""

    # For each pixel along it, and for each control point, at least.
    per_pixel: float
    per_control_point: float
    # So many for each pixel are enough also for the control points of a fine net, as long as there
    # are ``seen`` of them for each.
    enough: float
    # For each control point, whatever is enough: waves of the face between samples are seen by
    # none.
    seen: float

    def along(self, pixels: int, points: int) -> float:
        """Samples along an axis of so many pixels and control points."""
        wanted = max(self.per_pixel * pixels, self.per_control_point * points)
        return min(wanted, max(self.enough * pixels, self.seen * points))
