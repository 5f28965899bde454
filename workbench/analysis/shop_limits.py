"""Limits of a workshop, with their titles, tips and units."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from workbench.option_groups import DEGREES, LENGTH, OptionGroup, option

if TYPE_CHECKING:
    from workbench.scene import Element, Scene


def _limit(title: str, tip: str, unit: str = LENGTH, **more: Any) -> Any:
    return option(title, tip, unit=unit, above=True, **more)


@dataclass(frozen=True)
class Limits(OptionGroup):
    """Limits of a workshop; None for no limit. Lengths in scene units."""

    called: ClassVar[str] = "limits"

    min_thickness: float | None = _limit("Thinnest", "Least thickness of the element")
    max_thickness: float | None = _limit("Thickest", "Largest thickness of the element")
    max_slope: float | None = _limit(
        "Slope",
        "Largest angle between a freeform face and a plane across the axis, in degrees",
        DEGREES,
        most=90.0,
    )
    min_radius: float | None = _limit(
        "Concave radius", "Least radius of curvature that a tool can cut, concave or convex"
    )
    min_tool_radius: float | None = _limit(
        "Largest ball cutter",
        "Radius of the ball cutter that must fit everywhere on the face. A larger ball leaves "
        "material in hollows",
    )

    @classmethod
    def asked(cls, scene: "Scene", optic: "Element") -> "Limits":
        """Return the limits that a design task asks of one of its elements."""
        return cls(
            min_thickness=optic.least_thickness or None,
            min_radius=scene.run.min_radius,
            min_tool_radius=scene.bends.get("min_tool_radius"),
        )
