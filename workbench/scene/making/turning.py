"""Diamond turning with a slow tool servo."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import ConfigDict

from workbench.powers import rounded
from workbench.scene.element import Element
from workbench.scene.fields import LENGTH, about
from workbench.scene.making.process import Process, check_step, check_width
from workbench.scene.making.relief import Grooves
from workbench.scene.part import Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_NOSE, _FEED = 0.01, 0.01  # of a new process: radius over the half-width, feed over the radius


class Turning(Process):
    """Diamond turning with a slow tool servo: a spiral about the axis of the element."""

    model_config = ConfigDict(title="Diamond turning")

    kind: Literal["turning"] = "turning"
    nose_radius: Annotated[
        Positive, LENGTH, about("Nose radius", "Radius of the tip of the diamond.")
    ]
    feed: Annotated[
        Positive,
        LENGTH,
        about("Feed", "Distance of neighbouring turns. The ridges between are feed² / 8 R high."),
    ]

    @property
    def reliefs(self) -> tuple[Grooves, ...]:
        """Ridges between turns."""
        return (Grooves(self.nose_radius, self.feed),)

    def check_for(self, element: Element) -> None:
        """Refuse a tool that is larger than the element, and turns with ridges between."""
        check_width("nose_radius", self.nose_radius, element, 1.0)
        check_step("feed", self.feed, self.nose_radius)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """A tool that is small beside the lens."""
        radius = rounded(_NOSE * min(scene.optic.half_width), 1)
        return {"nose_radius": radius, "feed": _FEED * radius}
