"""How the lens is searched for."""

from typing import Annotated, Literal

from pydantic import Field, Tag

from workbench.refusals import told_by
from workbench.scene.lens import NetSize
from workbench.scene.part import LENGTH, Part, Positive
from workbench.scene.screen import FilterField
from workbench.scene.source import SourceField


class Stage(Part):
    """A part of the run, before the scene itself is run, with some things different.

    Attributes
    ----------
    iterations : int
        Upper limit of this stage; counted within those of the whole run.
    source, filter : optional
        In place of the scene's.
    control_points : tuple[int, int], optional
        A coarser net; the lens is carried on to the next net by knot insertion.
    method : str, optional
        "auto" or "paper", the latter with the plain settings if the scene's method is another.
    learning_rate : float, optional
        For the paper's method.
    """

    iterations: Annotated[int, Field(ge=1, le=1_000_000)]
    source: SourceField | None = None
    filter: FilterField | None = None
    control_points: tuple[NetSize, NetSize] | None = None
    method: Literal["auto", "paper"] | None = None
    learning_rate: Positive | None = None


class RunSettings(Part):
    """What every design run has: an upper limit of iterations, a seed, where it computes.

    ``stages`` come first; the scene as it stands is run for the iterations that they leave.

    Attributes
    ----------
    smoothness : float, optional
        Weight of the exit face's bending energy, to be added to the square of the image's relative
        error; none if left out. It has no unit.
    min_radius : float, optional
        Smallest radius of curvature that the exit face may have, concave or convex, scene units;
        any if left out.
    """

    iterations: Annotated[int, Field(ge=0, le=1_000_000)] = 300
    stages: tuple[Stage, ...] = ()
    seed: Annotated[int, Field(ge=0, lt=2**63)] = 0
    device: Literal["cpu", "cuda"] = "cpu"
    smoothness: Positive | None = None
    min_radius: Annotated[Positive | None, LENGTH] = None


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
