"""How the lens is searched for: method, stages, and how rays become an image."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from workbench.errors import Refused
from workbench.levels import EXPERT, LIMITS
from workbench.messages import Message
from workbench.scene.faces import NetSize
from workbench.scene.fields import LENGTH, Choices, Fallback, ForMethod, LeftOut, Measure, about
from workbench.scene.part import Kinds, Part, Positive
from workbench.scene.sources import Source

if TYPE_CHECKING:
    from workbench.scene.task import Scene


def _odd(size: int) -> int:
    if size % 2 == 0:
        raise PydanticCustomError("even", "is even")
    return size


FilterSize = Annotated[int, Field(ge=1, le=99), AfterValidator(_odd)]
_Fraction = Annotated[float, Field(gt=0, le=1)]


class BoxFilter(Part):
    """Every ray counts fully in the pixel that it hits."""

    model_config = ConfigDict(title="Box")

    kind: Literal["box"] = "box"
    # As a Gaussian that is no wider than a pixel.
    size: ClassVar[tuple[int, int]] = (1, 1)
    alpha: ClassVar[float] = 0.0
    smooth: ClassVar[bool] = False
    """Whether the image changes as a ray moves within a pixel, so that it has a derivative."""


class GaussianFilter(Part):
    """Light falls off over some pixels, so that a design feels where in a pixel a ray lands."""

    model_config = ConfigDict(title="Gaussian")

    smooth: ClassVar[bool] = True

    kind: Literal["gaussian"] = "gaussian"
    size: Annotated[
        tuple[FilterSize, FilterSize],
        Measure("px", "pixels"),
        about("Size", "Pixels along x and y that one ray reaches; odd numbers."),
    ] = (3, 3)
    alpha: Annotated[
        float,
        Measure("px⁻²", "per pixel²"),
        about(
            "Alpha",
            "How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.",
            ge=1e-6,
            le=1e6,
        ),
    ] = 1.0


Filter = Annotated[GaussianFilter | BoxFilter, Kinds("kind", default="gaussian")]
_AUTO, _PAPER = "Automatic", "As in the paper"
_RATE = "Step of the optimiser. Too large and the loss jumps, too small and it creeps."

# Steps of Adam after which top hats of 24² to 64² control points were best, from all starts: the
# more links a neuron has, the farther one step of all of them carries it.
LEARNING_RATES = {"none": 3e-3, "sparse": 1e-3, "dense": 1e-4}

# Control points along each axis that suit it: a dense network grows with the square of their
# number.
_NETS = {"none": 64, "sparse": 64, "dense": 32}

_AS_THE_SCENE = LeftOut("As the scene")


class Stage(Part):
    """A part of the run, before the scene itself is run, with some things different."""

    iterations: Annotated[
        int,
        about(
            "Iterations",
            "Upper limit of iterations of this stage. They count within those of the run; what "
            "all stages leave is for the scene itself.",
            ge=1,
            le=1_000_000,
        ),
    ]
    method: Annotated[
        Literal["auto", "paper"] | None,
        Choices((("auto", _AUTO), ("paper", _PAPER))),
        _AS_THE_SCENE,
        about("Method", "How the lens is searched for in this stage."),
    ] = None
    learning_rate: Annotated[
        Positive | None,
        ForMethod("paper"),
        Fallback("run.rate"),
        about("Learning rate", f"{_RATE} Left empty, it is that of the scene."),
    ] = None
    control_points: Annotated[
        tuple[NetSize, NetSize] | None,
        Fallback("optic.net_shape"),
        about(
            "Control points",
            "Numbers of control points along x and y in this stage. A coarse net moves light over "
            "long distances soon; the next stage goes on with the same surface on a finer one. "
            "Left empty, they are the lens's.",
        ),
    ] = None
    source: Annotated[
        Source | None, _AS_THE_SCENE, about("Source", "Where the light comes from.")
    ] = None
    filter: Annotated[
        Filter | None,
        _AS_THE_SCENE,
        about(
            "Image filter",
            "How a ray's light is shared among pixels, by the paper's method and in derivative "
            "maps. Automatic has no filter.",
        ),
    ] = None


RADII = ("min_radius", "min_tool_radius")
"""Fields of a run that are radii of the faces."""


class RunSettings(Part):
    """What every design run has.

    ``stages`` come first; the scene as it stands is run for the iterations that they leave.
    """

    iterations: Annotated[
        int,
        EXPERT,
        about(
            "Iterations",
            "Upper limit of iterations. Automatic may stop sooner, when nothing improves.",
            ge=0,
            le=1_000_000,
        ),
    ] = 300
    stages: Annotated[
        tuple[Stage, ...],
        EXPERT,
        about("Stages", "What the run goes through before the scene as it stands."),
    ] = ()
    smoothness: Annotated[
        Positive | None,
        EXPERT,
        about(
            "Smoothness",
            "Weight of the exit face's bending energy beside the square of the image's error; it "
            "has no unit. 0.001 calms ripples, 0.01 costs sharpness. Left empty, the face may "
            "bend as it likes.",
        ),
    ] = None
    min_radius: Annotated[
        Positive | None,
        LENGTH,
        LIMITS,
        about(
            "Smallest radius",
            "Smallest radius of curvature that the exit face may have, concave and convex: "
            "that of the tool. A run that has settled keeps to it; dark edges get softer. Left "
            "empty, any will do.",
        ),
    ] = None
    min_tool_radius: Annotated[
        Positive | None,
        LENGTH,
        LIMITS,
        about(
            "Ball cutter radius",
            "Radius of the ball cutter that has to fit everywhere on the freeform faces. Hollows "
            "keep to it; humps may be sharper. Manufacture shows whether it fits. Left empty, any "
            "will do.",
        ),
    ] = None
    max_error: Annotated[
        _Fraction | None,
        LIMITS,
        about(
            "Error at most",
            "Goal for the relative L2 error: 0.02 is 2 %. The run ends as soon as its lens meets "
            "it. Left empty, the run goes on as long as it gains.",
        ),
    ] = None
    min_light: Annotated[
        _Fraction | None,
        LIMITS,
        about(
            "Light at least",
            "Goal for the part of the emitted light on the receiver: 0.9 is 90 %. It is judged "
            "and does not change the run.",
        ),
    ] = None
    min_uniformity: Annotated[
        _Fraction | None,
        LIMITS,
        about(
            "Uniformity at least",
            "Goal for U₀, the minimum over the average irradiance where the target is lit; 1 is "
            "uniform. It is judged and does not change the run.",
        ),
    ] = None
    seed: Annotated[
        int,
        EXPERT,
        about(
            "Seed",
            "Start of the random numbers; the same seed repeats the same run.",
            ge=0,
            lt=2**63,
        ),
    ] = 0
    device: Annotated[
        Literal["cpu", "cuda"],
        Choices((("cpu", "Processor"), ("cuda", "Graphics card (CUDA)"))),
        EXPERT,
        about("Computes on", "The graphics card needs a CUDA device and a PyTorch built for it."),
    ] = "cpu"

    @property
    def bends(self) -> dict[str, float]:
        """What is asked of the bends of the faces, by the names of fields, where it is."""
        asked = {name: getattr(self, name) for name in ("smoothness", *RADII)}
        return {name: value for name, value in asked.items() if value is not None}

    @property
    def rate(self) -> float:
        """Step of the optimiser of the paper's method."""
        return LEARNING_RATES["none"]

    @property
    def usual_net(self) -> int | None:
        """Control points along each axis that suit the method; None where the task decides."""
        return None


class AutoRun(RunSettings):
    """The best that this program knows; it may stop before all iterations are done."""

    model_config = ConfigDict(title=_AUTO)

    method: Literal["auto"] = "auto"
    # As the paper's method without a network that begins with a flat lens.
    parametrisation: ClassVar[Literal["none"]] = "none"
    start: ClassVar[Literal["zeros"]] = "zeros"

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """The scene's stages; there is no learning rate in those that follow this method."""
        stages = scene.run.stages
        return {
            "stages": tuple(
                stage if stage.method else stage.model_copy(update={"learning_rate": None})
                for stage in stages
            )
        }


class PaperRun(RunSettings):
    """The published method, for comparison: Adam on control heights, or through a network."""

    model_config = ConfigDict(title=_PAPER)

    method: Literal["paper"] = "paper"
    parametrisation: Annotated[
        Literal["none", "sparse", "dense"],
        Choices(
            (
                ("none", "Control heights"),
                ("sparse", "Sparse network"),
                ("dense", "Dense network"),
            )
        ),
        EXPERT,
        about(
            "Optimises",
            "What the optimiser moves: one number per control height, or the weights of a network "
            "that puts the heights out. In a sparse network the neurons of control points that "
            "share a piece of the face are linked, in a dense one all are.",
        ),
    ] = "none"
    start: Annotated[
        Literal["zeros", "uniform", "random"],
        Choices((("zeros", "Flat"), ("uniform", "Faint noise"))),
        EXPERT,
        about(
            "Start",
            "Parameters before the first iteration: all zero, in ±0.0001, or drawn from the seed "
            "so that the lens is crooked. A network that starts with zeros behaves as if there "
            "were none.",
        ),
    ] = "zeros"
    learning_rate: Annotated[
        Positive | None,
        Fallback("run.rate"),
        EXPERT,
        about("Learning rate", f"{_RATE} Left empty, it is the one that suits what is optimised."),
    ] = None

    @property
    def rate(self) -> float:
        """Step of the optimiser: as set, or what suits what is optimised."""
        return self.learning_rate or LEARNING_RATES[self.parametrisation]

    @property
    def usual_net(self) -> int:
        """One like the paper's: with finer nets its own loss falls and the verified error rises."""
        return _NETS[self.parametrisation]


Run = Annotated[AutoRun | PaperRun, Kinds("method", default="auto", title="Method", level=EXPERT)]
_MOST = 100  # each is checked as a scene of its own


def stage_scenes(scene: "Scene") -> tuple["Scene", ...]:
    """The run of a scene as scenes without stages; see `Scene.stage_scenes`."""
    stages = scene.run.stages
    if not stages:
        return (scene,)
    if len(stages) > _MOST:
        many = Message("{count} are given; at most {most}", count=len(stages), most=_MOST)
        raise Refused("run.stages", many)
    left = scene.run.iterations - sum(stage.iterations for stage in stages)
    if left < 1:
        raise Refused(
            "run.stages",
            Message(
                "they leave none of the {count} iterations for the scene itself; more than "
                "{least} in all are needed",
                count=scene.run.iterations,
                least=scene.run.iterations - left,
            ),
        )
    parts = []
    for number, stage in enumerate(stages):
        with refused_in_stage(number, len(stages), scene):
            parts.append(_in_stage(scene, stage))
    last = scene.run.model_copy(update={"stages": (), "iterations": left})
    return (*parts, scene.model_copy(update={"run": last}))


@contextmanager
def refused_in_stage(number: int, count: int, scene: "Scene") -> Iterator[None]:
    """Give refusals of a stage's scene their paths from the whole scene.

    `number`: number of the stage, an index of `Scene.stage_scenes`; `count`: how many stages there
    are; the scene behind them is the whole one; `scene`: the whole one.
    """
    try:
        yield
    except Refused as refused:
        if number == count:
            raise
        path = refused.path.removeprefix(f"{scene.face_path()}.").removeprefix("run.")
        raise Refused(f"run.stages[{number}].{path}", refused.reason) from None


def _in_stage(scene: "Scene", stage: Stage) -> "Scene":
    """The scene with what a stage changes."""
    optic = scene.optic
    if stage.control_points is not None:
        scene = scene.with_optic(optic.shaped(control_points=stage.control_points))
    return scene.altered(
        source=stage.source or scene.source,
        filter=stage.filter or scene.filter,
        run=_run_in_stage(scene.run, stage),
    )


def _run_in_stage(run: Run, stage: Stage) -> Run:
    """Settings of a run in one of its stages."""
    changes = {name: getattr(run, name) for name in RunSettings.model_fields}
    changes |= {"iterations": stage.iterations, "stages": ()}
    if stage.method not in (None, run.method):
        # Settings of the one method mean nothing to the other.
        run = PaperRun() if stage.method == "paper" else AutoRun()
    if stage.learning_rate is not None:
        if "learning_rate" not in type(run).model_fields:
            unknown = Message("unknown field; the automatic method has none")
            raise Refused("run.learning_rate", unknown)
        changes["learning_rate"] = stage.learning_rate
    return run.model_copy(update=changes)
