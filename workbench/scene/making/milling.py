"""Milling with a ball cutter."""

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import ConfigDict

from workbench.levels import EXPERT
from workbench.powers import rounded, written
from workbench.scene.element import Element
from workbench.scene.fields import ANGLE, LENGTH, about
from workbench.scene.making.process import BallCut, Process, check_step, check_width
from workbench.scene.making.relief import Grooves
from workbench.scene.part import NonNegative, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_BALL, _STEP = 0.03, 0.1  # of a new process: radius over the half-width, step-over over the radius


class Milling(Process):
    """Milling with a ball cutter in straight parallel passes."""

    model_config = ConfigDict(title="Milling")

    kind: Literal["milling"] = "milling"
    ball_radius: Annotated[Positive, LENGTH, about("Ball radius", "Radius of the ball cutter.")]
    step_over: Annotated[
        Positive,
        LENGTH,
        about(
            "Step-over",
            "Distance of neighbouring passes, seen along z. The scallops between them are about "
            "step² / 8 R high.",
        ),
    ]
    direction: Annotated[
        float,
        ANGLE,
        EXPERT,
        about("Direction", "Direction of the passes against x.", ge=-180, le=180),
    ] = 0.0
    feed_per_tooth: Annotated[
        NonNegative,
        LENGTH,
        EXPERT,
        about("Feed per tooth", "Distance of the marks along each pass; 0 for none."),
    ] = 0.0

    @property
    def scallop(self) -> float:
        """Height of the scallops on a plane across the axis, scene units."""
        return self.ball_radius - math.sqrt(self.ball_radius**2 - self.step_over**2 / 4)

    @property
    def ball_cut(self) -> BallCut:
        """See `Process.ball_cut`."""
        return BallCut(self.ball_radius, self.step_over)

    @property
    def reliefs(self) -> tuple[Grooves, ...]:
        """Scallops between passes, and marks along them."""
        turn = math.radians(self.direction)
        along = math.cos(turn), math.sin(turn)
        made = [Grooves(self.ball_radius, self.step_over, (-along[1], along[0]))]
        if self.feed_per_tooth:
            made.append(Grooves(self.ball_radius, self.feed_per_tooth, along))
        return tuple(made)

    def check_for(self, element: Element) -> None:
        """Refuse a cutter that is larger than the element, and passes with ridges between."""
        check_width("ball_radius", self.ball_radius, element, 1.0)
        check_step("step_over", self.step_over, self.ball_radius)
        check_step("feed_per_tooth", self.feed_per_tooth, self.ball_radius)

    def remarks(self) -> dict[str, str]:
        """The height of the scallops."""
        return {"step_over": f"scallops {written(self.scallop, digits=2)}"}

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """A ball that is small beside the lens."""
        radius = rounded(_BALL * min(scene.optic.half_width), 1)
        return {"ball_radius": radius, "step_over": _STEP * radius}
