"""A design run, a generator of immutable snapshots, by one of the methods of design.

Whoever runs it stops it by leaving the loop and pauses it by not asking for the next snapshot,
so both take effect within one iteration.
"""

import math
import time
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Mask
from workbench.design.auto import auto_judged, auto_steps
from workbench.design.bounds import Bounds
from workbench.design.checks import grazed, reversed_on_lit_side
from workbench.design.images import AnyImage
from workbench.design.lens_state import LensState, Step
from workbench.design.levels import finest_image
from workbench.design.limits import CLOSEST, HeightLimits
from workbench.design.loss import relative_error
from workbench.design.memory import check_auto, memory_notes
from workbench.design.net import definite
from workbench.design.paper import FilteredImage, check_paper, paper_steps
from workbench.design.snapshot import DONE, LOCKED, MET, Result, Snapshot
from workbench.design.transport.entrance import out_of_reach
from workbench.errors import Refused, RunFailed
from workbench.extended.bound import percent
from workbench.geometry.body import check_body
from workbench.geometry.faces import NO_LOCKS, ControlHeights, FaceArrays
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.optics.plan import device_of, tensors_of
from workbench.optics.sources import emitter_of
from workbench.scene import AutoNet, Scene
from workbench.scene.run import refused_in_stage

# Places of the element along each axis at which its source has to shine somewhere.
_LOOKED_AT = 65
_FULL_CARD = Message(
    "the graphics card has too little free memory; compute on the processor, or take fewer pixels"
)


class Method(NamedTuple):
    """A way to search for a lens."""

    # Evaluates lens after lens within bounds and returns why it ended.
    steps: Callable[[Bounds], Generator[Step, None, str]]
    # What it judges lenses by: for a scene, a target and the heights of a lens like those to come.
    image: Callable[[Scene, Array, Mapping[str, Tensor]], AnyImage | FilteredImage]
    check: Callable[[Scene], None]  # refuses a scene that it cannot design
    # What a run of a scene says of itself from the beginning.
    notes: Callable[[Scene], tuple[str, ...]]
    # The best lens of a run in light that it was not fitted to, of a scene, a target and the
    # control heights; None where the run has seen it so.
    judged: Callable[[Scene, Array, ControlHeights], Step | None]


def method_of(scene: Scene) -> Method:
    """The method that a scene asks for."""
    return _METHODS[scene.run.method]


_METHODS = {
    "auto": Method(auto_steps, finest_image, check_auto, memory_notes, auto_judged),
    "paper": Method(
        paper_steps,
        lambda scene, target, heights: FilteredImage(scene, target),
        check_paper,
        notes=lambda scene: (),
        judged=lambda scene, target, heights: None,
    ),
}


def run(
    scene: Scene,
    target: Array,
    start: Mapping[str, Array] | None = None,
    locked: Mapping[str, Mask] = NO_LOCKS,
) -> Generator[Snapshot, None, str]:
    """Design a lens.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `start` (n_u, n_v): control
    heights of each freeform face to go on from, by its name; by default the run begins with the
    undesigned lens; `locked` (n_u, n_v): control points of each face that keep the heights that
    they begin with, exactly; none by default. A run whose control points are all locked ends with
    its first design. Yields first the lens before any step, then one after each iteration; at last,
    unless the run has seen it so, the best lens once more, in the light of beams that it was not
    fitted to, or one that was looked at and is better there. Returns why there are no more, as
    `History.follow` keeps it. Raises `Refused` if the scene or one of its stages cannot be run
    here; before any of them is; `RunFailed` if the run cannot go on; the snapshots up to then stay
    good.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "tophat-none-zeros.json"))
    >>> for snapshot in run(task.scene, task.target):
    ...     if snapshot.iteration == 2:
    ...         break
    >>> snapshot.state.heights["lens.back"].shape == task.scene.optic.net_shape
    True
    """
    scene = definite(scene, target)
    scenes = scene.stage_scenes()
    nets = nets_of(scene)
    locked = {face: mask for face, mask in locked.items() if mask.any()}
    locked |= {face: np.ones(nets[face].shape, bool) for face in scene.fixed_faces}
    done = all(face in locked and locked[face].all() for face in nets)
    # Given heights stand at the end of all stages already.
    first = 0 if start is None and not done else len(scenes) - 1
    check_stages(scenes, first, start, locked)
    scene_notes = _scene_notes(scene, target)
    iteration, goal = 0, _Goal(scene, target)
    seconds = 0.0  # time spent here, not where the snapshots go: a pause is not run time
    for stage, stage_scene in enumerate(scenes[first:], first):
        # The first design of a later stage counts as an iteration: its loss is one of another task.
        most = 1 if done else stage_scene.run.iterations + (stage == first)
        bounds = Bounds(stage_scene, target, start, locked)
        method = method_of(stage_scene)
        steps, notes = method.steps(bounds), (*scene_notes, *method.notes(stage_scene))
        lowest = math.inf
        best_heights: ControlHeights | None = None
        light: Step | None = None  # the best that was looked at in other light
        for _ in range(most):
            resumed = time.perf_counter()
            try:
                step = next(steps)
            except StopIteration as end:
                ended: str = end.value
                break
            except (RunFailed, torch.OutOfMemoryError) as error:
                raise _stopped(iteration, error, bounds, scene) from None
            merit = _merit(step)
            if step.judged and (light is None or _merit(step.judged) < _merit(light)):
                light = step.judged
            # The first one is the best so far even if its light falls beside the screen.
            best = best_heights is None or merit < lowest
            state = _finished(step.state, bounds, scene)
            seconds += time.perf_counter() - resumed
            snapshot = Snapshot(
                state,
                iteration=iteration,
                iterations=scene.run.iterations,
                seconds=seconds,
                merit=merit,
                best=best,
                stage=stage,
                stages=len(scenes),
                notes=(*notes, *step.notes, *bounds.notes),
            )
            if best:
                lowest, best_heights, kept = merit, step.state.heights, snapshot
            yield snapshot
            iteration += 1
            if best and stage + 1 == len(scenes) and (met := goal.met_by(state)):
                ended = met
                break
        else:
            ended = Message(LOCKED if done else DONE)
        if stage + 1 < len(scenes) and best_heights is not None:
            start = _carried(best_heights, stage_scene, scenes[stage + 1])
    del steps  # and its images, before others are made
    return (yield from _judged(scene, target, bounds, kept, snapshot, light, ended))


def check_stages(
    scenes: Sequence[Scene],
    first: int,
    start: Mapping[str, Array] | None,
    locked: Mapping[str, Mask],
) -> None:
    """Refuse a run that could not be carried to its end.

    `scenes`: as `Scene.stage_scenes` gives them; the last is the scene itself; `first`: number of
    the stage that the run begins with. Raises `Refused` with the path of the field, in its stage if
    it is one.
    """
    finished = scenes[-1]
    for stage, part in enumerate(scenes[first:], first):
        with refused_in_stage(stage, len(scenes) - 1, part):
            device_of(part)
            method_of(part).check(part)
            _check_lit(part)
            _check_fixed(part, start or {})
            if locked:
                _check_net(part, finished)
    if locked and start is not None:
        limits = HeightLimits.of_scene(finished, CLOSEST)
        kept = {face: limits[face].kept(each, locked.get(face)) for face, each in start.items()}
        check_body(finished, kept)


def _check_lit(part: Scene) -> None:
    """Refuse a source that shines away from the element, as a lamp that is turned around."""
    places = torch.linspace(-1, 1, _LOOKED_AT, dtype=torch.float64)
    source, first = part.entrance
    r_x, r_y = first.half_width
    x, y = torch.cartesian_prod(r_x * places, r_y * places).T
    if not emitter_of(source, first).towards(x, y).flux.any():
        raise Refused(
            "source",
            Message(
                "none of its light goes to the {optic}; turn or move it", optic=part.optic.called
            ),
        )


def _check_fixed(part: Scene, start: Mapping[str, Array]) -> None:
    for number, element in enumerate(part.elements):
        for placed, face in element.fixed_faces:
            if face.content is None and placed.name not in start:
                raise Refused(
                    f"elements[{number}].{placed.path}.heights",
                    Message("the control heights of the fixed face are missing; a file (.npy)"),
                )


def _check_net(part: Scene, finished: Scene) -> None:
    """Refuse another net than that of the finished lens, which the locks are about."""
    if nets_of(part) != nets_of(finished):
        raise Refused(
            f"{part.face_path()}.control_points",
            Message(
                "{net} are not the control points of the finished {optic} that are locked; leave "
                "the stage's net out or unlock them",
                net=list(part.optic.net_shape),
                optic=part.optic.called,
            ),
        )


# Part of a goal at which a run ends: the check finds slightly more than the design, 10.93 % and not
# 10.87 % for an LED that lights a rectangle.
_OF_GOAL = 0.98


class _Goal:
    """The error that a run shall reach; it ends there."""

    def __init__(self, scene: Scene, target: Array) -> None:
        self._scene, self._target = scene, target
        # Radii are kept by a run that has settled: it does not end before.
        self._goal = 0.0 if scene.bends else scene.run.max_error or 0.0
        self._least = _OF_GOAL * self._goal
        self._needed = self._least  # in the run's own light, before a lens is judged

    def met_by(self, state: LensState) -> Message | None:
        """Why a run ends with this lens; None if its error in light of its own is above the goal.

        In the light of beams that the lens was not fitted to its error is higher. It is judged
        anew once the run has lowered the error by as much.
        """
        own = relative_error(state, self._target)
        if not self._goal or own > self._needed:
            return None
        light = method_of(self._scene).judged(self._scene, self._target, state.heights)
        error = own if light is None else relative_error(light.state, self._target)
        if error > self._least:
            self._needed = own * self._least / error
            return None
        return Message(MET, error=percent(error), goal=percent(self._goal))


def _merit(step: Step) -> float:
    return step.state.loss if step.merit is None else step.merit


def _finished(state: LensState, bounds: Bounds, scene: Scene) -> LensState:
    shortfall = bounds.shortfall(state.heights)
    heights = _carried(state.heights, bounds.scene, scene)
    return replace(state, shortfall=shortfall, heights=heights)


def _judged(
    scene: Scene,
    target: Array,
    bounds: Bounds,
    best: Snapshot,
    last: Snapshot,
    earlier: Step | None,
    ended: str,
) -> Generator[Snapshot, None, str]:
    """The best lens of a run in light that it was not fitted to, if it has not been seen so.

    `earlier`: the best of those that were looked at in such light before.
    """
    resumed = time.perf_counter()
    try:
        light = method_of(scene).judged(scene, target, best.state.heights)
    except torch.OutOfMemoryError as error:
        raise _stopped(last.iteration, error, bounds, scene) from None
    if light is not None:
        if earlier is not None and _merit(earlier) < _merit(light):
            light = earlier
        state = _finished(light.state, bounds, scene)
        seconds = last.seconds + time.perf_counter() - resumed
        yield replace(last, state=state, merit=best.merit, best=True, seconds=seconds, judged=True)
    return ended


def _stopped(
    iteration: int, error: RunFailed | torch.OutOfMemoryError, bounds: Bounds, scene: Scene
) -> RunFailed:
    """What ends a run, with what the first design cannot meet where that is why."""
    why = error.args[0] if isinstance(error, RunFailed) else _FULL_CARD
    short = bounds.shortfall(bounds.begin)
    if short is not None:
        why = Message("{why}. {limit}", why=why, limit=short.in_full(scene))
    return RunFailed(
        Message("stopped at iteration {iteration}: {why}", iteration=iteration, why=why)
    )


def _scene_notes(scene: Scene, target: Array) -> tuple[str, ...]:
    """The net of the finished lens, where the program has chosen it, and what may surprise."""
    n_u, n_v = scene.optic.net_shape
    net = Message("control points: {n_u} × {n_v}, chosen for this task", n_u=n_u, n_v=n_v)
    chosen = isinstance(scene.optic.control_points, AutoNet)
    surprises = (
        grazed(scene),
        reversed_on_lit_side(scene, target),
        out_of_reach(scene, target),
    )
    return tuple(filter(None, (net if chosen else None, *surprises)))


def _carried(heights: ControlHeights, scene: Scene, other: Scene) -> ControlHeights:
    nets, others = nets_of(scene), nets_of(other)
    if nets == others:
        return heights
    return FaceArrays(
        {face: nets[face].carry(each, others[face]) for face, each in heights.items()}
    )


class Evaluator:
    """Judges lenses as a run of the scene would: by the same rays, filter and loss.

    All that does not depend on the lens is computed once, here.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `heights`: control heights of a
    lens like those to come, scene units; says how far their light falls. Raises `Refused` if the
    scene asks for a device that is not there.
    """

    def __init__(self, scene: Scene, target: Array, heights: ControlHeights) -> None:
        self._scene, self._target = scene, target
        self._image = method_of(scene).image(scene, target, tensors_of(heights, scene))

    def suits(self, scene: Scene, target: Array) -> bool:
        """Whether it can judge lenses of this scene and target."""
        return scene is self._scene and target is self._target

    def snapshot(self, heights: ControlHeights, earlier: Result | None = None) -> Snapshot:
        """A lens and its light, as the last of its run.

        `earlier`: where the lens comes from; its iterations and seconds are counted in. Raises
        `RunFailed` if no light reaches the screen.
        """
        with torch.no_grad():
            _, step = self._image.compare(tensors_of(heights, self._scene))
        scene, count = self._scene, earlier.iterations if earlier else 0
        return Snapshot(
            step.state,
            iteration=count,
            iterations=max(scene.run.iterations, count),
            seconds=earlier.seconds if earlier else 0.0,
            merit=_merit(step),
            best=True,
            stage=len(scene.run.stages),
            stages=1 + len(scene.run.stages),
            notes=step.notes,
        )
