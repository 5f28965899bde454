"""Figure error: random waves of a face."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import ConfigDict

from workbench.levels import EXPERT
from workbench.powers import rounded
from workbench.scene.fields import LENGTH, Measure, about
from workbench.scene.making.process import Process
from workbench.scene.making.relief import RandomRelief
from workbench.scene.part import NonNegative, Positive

if TYPE_CHECKING:
    from workbench.scene.task import Scene


class FigureError(Process):
    """Figure error: random waves of a known slope and length, whatever makes them."""

    model_config = ConfigDict(title="Figure error")

    kind: Literal["figure_error"] = "figure_error"
    slope: Annotated[
        NonNegative,
        Measure("mrad"),
        about("Slope", "Rms of the gradient of the error.", le=200),
    ] = 0.5
    length: Annotated[
        Positive,
        LENGTH,
        about("Correlation length", "Distance at which the autocorrelation falls to 1/e."),
    ]
    seed: Annotated[
        int, EXPERT, about("Seed", "Another number makes other waves.", ge=0, le=2**31 - 1)
    ] = 0

    @property
    def errors(self) -> tuple[RandomRelief, ...]:
        """Its waves."""
        return (RandomRelief(self.slope / 1000, self.length, self.seed),)

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Waves a tenth of the lens long."""
        return {"length": rounded(0.2 * min(scene.optic.half_width), 1)}
