"""How the design is found."""

from typing import Any

from PySide6.QtWidgets import QLabel

from ui.panels.edits import value_at
from ui.panels.fields import LENGTH, Changes, ChoiceRow, NumberRow, Row
from ui.panels.optional import OptionalRow
from ui.panels.panel import Panel
from workbench.design.parametrisation import (
    as_bytes,
    memory_bytes,
    parameter_count,
)
from workbench.files.session import Session
from workbench.scene import RunSettings, Scene
from workbench.scene.run import LEARNING_RATES

METHODS = [("auto", "Automatic"), ("paper", "As in the paper")]
RATE_TIP = "Step of the optimiser. Too large and the loss jumps, too small and it creeps."


class RunPanel(Panel):
    """Bound to ``scene.run``."""

    def __init__(self) -> None:
        self._size = _SizeRow()
        super().__init__(
            "Run",
            [
                ChoiceRow(
                    "run.method",
                    "Method",
                    "Automatic uses the best that this program knows; the other follows the "
                    "published method, for comparison.",
                    METHODS,
                    changes=self._change_method,
                ),
                NumberRow(
                    "run.iterations",
                    "Iterations",
                    "Upper limit of iterations. Automatic may stop sooner, when nothing improves.",
                    whole=True,
                ),
                ChoiceRow(
                    "run.parametrisation",
                    "Optimises",
                    "What the optimiser moves: one number per control height, or the weights of a "
                    "network that puts the heights out. In a sparse network the neurons of control "
                    "points that share a piece of the face are linked, in a dense one all are.",
                    [
                        ("none", "Control heights"),
                        ("sparse", "Sparse network"),
                        ("dense", "Dense network"),
                    ],
                ),
                self._size,
                ChoiceRow(
                    "run.start",
                    "Start",
                    "Parameters before the first iteration: all zero, in ±0.0001, or drawn from "
                    "the seed so that the lens is crooked. A network that starts with zeros "
                    "behaves as if there were none.",
                    [("zeros", "Flat"), ("uniform", "Faint noise"), ("random", "Random")],
                ),
                OptionalRow(
                    "run.learning_rate",
                    "Learning rate",
                    RATE_TIP + " Left empty, it is the one that suits what is optimised.",
                    lambda data: [LEARNING_RATES[value_at(data, "run.parametrisation")]],
                    present=_as_in_the_paper,
                ),
                OptionalRow(
                    "run.smoothness",
                    "Smoothness",
                    "Weight of the exit face's bending energy beside the square of the image's "
                    "error; it has no unit. 0.001 calms ripples, 0.01 costs sharpness. Left empty, "
                    "the face may bend as it likes.",
                    lambda data: ["none"],
                ),
                OptionalRow(
                    "run.min_radius",
                    "Smallest radius",
                    "Smallest radius of curvature that the exit face may have, in hollows and on "
                    "humps: that of the tool. A run that has settled keeps to it; dark edges get "
                    "softer. Left empty, any will do.",
                    lambda data: ["none"],
                    LENGTH,
                ),
                NumberRow(
                    "run.seed",
                    "Seed",
                    "Start of the random numbers; the same seed repeats the same run.",
                    whole=True,
                ),
                ChoiceRow(
                    "run.device",
                    "Computes on",
                    "The graphics card needs a CUDA device and a PyTorch built for it.",
                    [("cpu", "Processor"), ("cuda", "Graphics card (CUDA)")],
                ),
            ],
        )

    def show_session(self, session: Session, pending: set[str]) -> None:
        """Show a session's values, and what they come to."""
        super().show_session(session, pending)
        self._size.show_size(session.scene)

    def _change_method(self, choice: str) -> Changes:
        run = self.session.scene.to_data()["run"]
        kept = {name: value for name, value in run.items() if name in RunSettings.model_fields}
        if choice == "auto":  # which has no learning rate, also in stages that follow it
            for stage in kept["stages"]:
                if "method" not in stage:
                    stage.pop("learning_rate", None)
        return {"run": {"method": choice, **kept}}


class _SizeRow(Row):
    """What a parametrisation costs, known before it is built."""

    def __init__(self) -> None:
        super().__init__(
            "run.parameters",
            "Parameters",
            "How many numbers are optimised, and the memory that they take with their gradient "
            "and the optimiser's two moments. A network that does not fit is refused at the start.",
            present=_as_in_the_paper,
        )
        self._text = QLabel()
        self._add(self._text)

    def show_size(self, scene: Scene) -> None:
        """Show what a scene's parametrisation comes to."""
        self._text.setText(f"{parameter_count(scene):,} ({as_bytes(memory_bytes(scene))})")

    @property
    def text(self) -> str:
        """What is shown."""
        return self._text.text()


def _as_in_the_paper(data: dict[str, Any]) -> bool:
    return bool(data["run"]["method"] == "paper")
