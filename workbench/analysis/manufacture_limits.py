"""Limits of manufacture, and whether a lens meets them."""

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

from workbench.analysis.manufacture import Extreme, FaceFigures, Manufacture

State = Literal["met", "open", "broken"]
_Asked = tuple[str, float | None, bool, Extreme]  # name, limit, whether a lower one, figure

_ROUNDING = 1e-9  # relative, of a figure on its limit


@dataclass(frozen=True)
class Limits:
    """Limits of a workshop; None for no limit."""

    # Along z, scene units.
    min_thickness: float | None = None
    max_thickness: float | None = None
    # Angle between each freeform face and a plane across the axis, degrees.
    max_slope: float | None = None
    min_radius: float | None = None  # radius of curvature of hollows and of humps, scene units
    # Radius of the ball cutter that has to fit everywhere, scene units.
    min_tool_radius: float | None = None


class Verdict(NamedTuple):
    """Verdict on one limit."""

    name: str  # of the limited figure
    limit: float  # scene units or degrees
    at_least: bool  # whether it is a lower limit
    found: Extreme  # figure of the lens
    # "broken" if a sampled point exceeds the limit, "met" if the bound is within it, else "open".
    state: State

    def wanted(self, unit: str) -> str:
        """The limit in words."""
        return f"at {'least' if self.at_least else 'most'} {self.limit:g}{self.behind(unit)}"

    def behind(self, unit: str) -> str:
        """Unit of the figure, as it follows a number."""
        return "°" if "slope" in self.name else f" {unit}"


def verdicts(found: Manufacture, limits: Limits) -> list[Verdict]:
    """Compare a lens with all given limits."""
    asked: list[_Asked] = [
        ("thickness", limits.min_thickness, True, found.thinnest),
        ("thickness", limits.max_thickness, False, found.thickest),
        *_of_face(found, limits, ""),
    ]
    if found.entrance is not None:
        asked += _of_face(found.entrance, limits, "entrance ")
    return [
        Verdict(name, limit, at_least, extreme, _state(limit, at_least, extreme))
        for name, limit, at_least, extreme in asked
        if limit is not None
    ]


def _of_face(found: FaceFigures, limits: Limits, face: str) -> list[_Asked]:
    return [
        (f"{face}slope", limits.max_slope, False, found.steepest),
        (f"{face}concave radius", limits.min_radius, True, found.tightest_concave),
        (f"{face}convex radius", limits.min_radius, True, found.tightest_convex),
        (f"{face}ball cutter", limits.min_tool_radius, True, found.tool_radius),
    ]


def _state(limit: float, at_least: bool, found: Extreme) -> State:
    sign = 1 if at_least else -1

    def keeps(value: float) -> bool:
        return math.isinf(value) or sign * (value - limit) >= -_ROUNDING * abs(limit)

    if not keeps(found.value):
        return "broken"
    return "met" if keeps(found.bound) else "open"
