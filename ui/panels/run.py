"""How the design is found."""

from ui.panels.fields import Changes, ChoiceRow, NumberRow
from ui.panels.panel import Panel
from workbench.scene import RunSettings


class RunPanel(Panel):
    """Bound to ``scene.run``."""

    def __init__(self) -> None:
        super().__init__(
            "Run",
            [
                ChoiceRow(
                    "run.method",
                    "Method",
                    "Automatic uses the best that this program knows; the other follows the "
                    "published method, for comparison.",
                    [("auto", "Automatic"), ("paper", "As in the paper")],
                    changes=self._change_method,
                ),
                NumberRow(
                    "run.iterations",
                    "Iterations",
                    "Upper limit of iterations. Automatic may stop sooner, when nothing improves.",
                    whole=True,
                ),
                ChoiceRow(
                    "run.start",
                    "Start",
                    "Control heights before the first iteration: in the middle of their range, "
                    "or drawn at random from the seed.",
                    [("zeros", "Flat"), ("uniform", "Faint noise"), ("random", "Random")],
                ),
                NumberRow(
                    "run.learning_rate",
                    "Learning rate",
                    "Step of the optimiser. Too large and the loss jumps, too small and it creeps.",
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

    def _change_method(self, choice: str) -> Changes:
        run = self.session.scene.run
        kept = {name: getattr(run, name) for name in RunSettings.model_fields}
        return {"run": {"method": choice, **kept}}
