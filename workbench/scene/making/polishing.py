"""Polishing with a soft lap."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import ConfigDict

from workbench.levels import EXPERT
from workbench.powers import rounded
from workbench.scene.element import Element
from workbench.scene.fields import LENGTH, about
from workbench.scene.making.process import Process, check_width
from workbench.scene.part import NonNegative, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_WIDEST = 0.25  # of the half-width


class Polishing(Process):
    """Polishing: high spots go first, so that the face becomes an average of itself.

    Material is removed in proportion to pressure (Preston, The theory and design of plate glass
    polishing machines, 1927). A soft lap presses harder on high spots, and heights relax to their
    mean about each place: a Gaussian, whose width grows with the root of the time.
    """

    model_config = ConfigDict(title="Polishing")

    kind: Literal["polishing"] = "polishing"
    width: Annotated[
        Positive,
        LENGTH,
        about(
            "Width",
            "Rms width of the Gaussian by which polishing averages the face. Half of the "
            "step-over removes scallops; details of the lens that are not much wider go, too.",
        ),
    ]
    depth: Annotated[
        NonNegative,
        LENGTH,
        EXPERT,
        about("Depth", "Thickness of the layer that polishing removes."),
    ] = 0.0

    @property
    def smoothing(self) -> float:
        """Its width."""
        return self.width

    @property
    def removed(self) -> float:
        """Its depth."""
        return self.depth

    def check_for(self, element: Element) -> None:
        """Refuse a lap that leaves no shape."""
        check_width("width", self.width, element, _WIDEST)
        check_width("depth", self.depth, element, _WIDEST)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """A width that leaves the details of most lenses."""
        return {"width": rounded(0.002 * min(scene.optic.half_width), 1)}
