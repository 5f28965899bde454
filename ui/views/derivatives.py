"""Derivative maps as views ask for them, in a thread beside the window."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.threads.background import Task

if TYPE_CHECKING:
    from workbench.analysis.derivatives import DerivativeMap
    from workbench.geometry.faces import ControlHeights, ControlPoint
    from workbench.scene import Scene


@dataclass(frozen=True, eq=False)
class DerivativeRequest:
    """Request for a derivative map."""

    scene: "Scene"
    heights: "ControlHeights"
    point: "ControlPoint"


def derivative(request: DerivativeRequest, task: Task) -> "DerivativeMap":
    """Return the map of a request; called in a thread."""
    # Late: torch comes with it, and the window shows before that.
    from workbench.analysis.derivatives import irradiance_derivative

    point = request.point
    return irradiance_derivative(request.scene, request.heights, point.index, face=point.face)
