"""The stages of a run, as scenes of their own."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.run import AutoRun, PaperRun, Run, RunSettings, Stage

if TYPE_CHECKING:
    from workbench.scene.task import Scene

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
