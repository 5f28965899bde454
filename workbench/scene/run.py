"""How the lens is searched for."""

from typing import Annotated, Literal

from pydantic import Field, Tag

from workbench.refusals import told_by
from workbench.scene.part import Part, Positive


class RunSettings(Part):
    """What every design run has: an upper limit of iterations, a seed, where it computes."""

    iterations: Annotated[int, Field(ge=0, le=1_000_000)] = 300
    seed: Annotated[int, Field(ge=0, lt=2**63)] = 0
    device: Literal["cpu", "cuda"] = "cpu"


class AutoRun(RunSettings):
    """The best this program knows; may stop before ``iterations`` when nothing improves."""

    method: Literal["auto"] = "auto"


class PaperRun(RunSettings):
    """Adam on the control heights through tanh, or through a network, as in the paper.

    Attributes
    ----------
    parametrisation : str
        What is optimised: "none", one number per control height; "sparse" or "dense", the
        weights and biases of a network that puts the heights out.
    start : str
        Those numbers before the first step: "zeros", "uniform" on ±1e-4, or "random".
    learning_rate : float, optional
        Step of Adam; left out, the one that suits the parametrisation.
    """

    method: Literal["paper"] = "paper"
    parametrisation: Literal["none", "sparse", "dense"] = "none"
    start: Literal["zeros", "uniform", "random"] = "zeros"
    learning_rate: Positive | None = None


Run = AutoRun | PaperRun
RunField = Annotated[
    Annotated[AutoRun, Tag("auto")] | Annotated[PaperRun, Tag("paper")],
    told_by("method", "auto", "paper", otherwise="auto"),
]
