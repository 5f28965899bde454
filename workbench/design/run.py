"""A design run: a generator of immutable snapshots.

Whoever runs it stops it by leaving the loop and pauses it by not asking for the next snapshot,
so both take effect within one iteration.
"""

import math
import time
from collections.abc import Generator, Mapping
from dataclasses import replace

import numpy as np
import torch

from workbench.arrays import Array, Mask
from workbench.design.bounds import Bounds
from workbench.design.checks import check_stages, grazed, reversed_on_lit_side
from workbench.design.lens_state import LensState
from workbench.design.methods import method_of
from workbench.design.net import definite
from workbench.design.snapshot import DONE, LOCKED, Snapshot
from workbench.errors import RunFailed
from workbench.geometry.faces import NO_LOCKS, ControlHeights, FaceArrays
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.scene import AutoNet, Scene

_FULL_CARD = Message(
    "the graphics card has too little free memory; compute on the processor, or take fewer pixels"
)


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
    its first lens. Yields first the lens before any step, then one after each iteration; at last,
    unless the run has seen it so, the best lens once more, in the light of beams that it was not
    fitted to. Returns why there are no more, as `History.follow` keeps it. Raises `Refused` if the
    scene or one of its stages cannot be run here; before any of them is; `RunFailed` if the run
    cannot go on; the snapshots up to then stay good.

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
    said = _scene_notes(scene, target)
    iteration = 0
    seconds = 0.0  # time spent here, not where the snapshots go: a pause is not run time
    for stage, stage_scene in enumerate(scenes[first:], first):
        # The first lens of a later stage counts as an iteration: its loss is one of another task.
        most = 1 if done else stage_scene.run.iterations + (stage == first)
        bounds = Bounds(stage_scene, target, start, locked)
        method = method_of(stage_scene)
        steps, notes = method.steps(bounds), (*said, *method.notes(stage_scene))
        lowest = math.inf
        best_heights: ControlHeights | None = None
        for _ in range(most):
            resumed = time.perf_counter()
            try:
                step = next(steps)
            except StopIteration as end:
                ended: str = end.value
                break
            except (RunFailed, torch.OutOfMemoryError) as error:
                raise _stopped(iteration, error, bounds, scene) from None
            merit = step.state.loss if step.merit is None else step.merit
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
        else:
            ended = Message(LOCKED if done else DONE)
        if stage + 1 < len(scenes) and best_heights is not None:
            start = _carried(best_heights, stage_scene, scenes[stage + 1])
    del steps  # and its images, before others are made
    return (yield from _judged(scene, target, bounds, kept, snapshot, ended))


def _finished(state: LensState, bounds: Bounds, scene: Scene) -> LensState:
    """The lens of a stage as one of the whole design."""
    shortfall = bounds.shortfall(state.heights)
    heights = _carried(state.heights, bounds.scene, scene)
    return replace(state, shortfall=shortfall, heights=heights)


def _judged(
    scene: Scene, target: Array, bounds: Bounds, best: Snapshot, last: Snapshot, ended: str
) -> Generator[Snapshot, None, str]:
    """The best lens of a run in light that it was not fitted to, if it has not been seen so."""
    resumed = time.perf_counter()
    try:
        light = method_of(scene).judged(scene, target, best.state.heights)
    except torch.OutOfMemoryError as error:
        raise _stopped(last.iteration, error, bounds, scene) from None
    if light is not None:
        state = replace(light.state, shortfall=best.state.shortfall)
        seconds = last.seconds + time.perf_counter() - resumed
        yield replace(last, state=state, merit=best.merit, best=True, seconds=seconds, judged=True)
    return ended


def _stopped(
    iteration: int, error: RunFailed | torch.OutOfMemoryError, bounds: Bounds, scene: Scene
) -> RunFailed:
    """What ends a run, with what the first lens cannot meet where that is why."""
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
    surprises = grazed(scene), reversed_on_lit_side(scene, target)
    return tuple(filter(None, (net if chosen else None, *surprises)))


def _carried(heights: ControlHeights, scene: Scene, other: Scene) -> ControlHeights:
    """Control heights of a scene on the nets of another one."""
    nets, others = nets_of(scene), nets_of(other)
    if nets == others:
        return heights
    return FaceArrays(
        {face: nets[face].carry(each, others[face]) for face, each in heights.items()}
    )
