"""A design run: a generator of immutable snapshots.

Whoever runs it stops it by leaving the loop and pauses it by not asking for the next snapshot,
so both take effect within one iteration.
"""

import math
import time
from collections.abc import Iterator
from itertools import islice

import numpy as np
import numpy.typing as npt

from workbench.design.auto import auto_steps
from workbench.design.paper import paper_steps
from workbench.design.snapshot import Snapshot
from workbench.design.step import Step
from workbench.errors import RunFailed
from workbench.geometry.surface import ControlNet
from workbench.scene import PaperRun, Scene

Array = npt.NDArray[np.float64]


def run(scene: Scene, target: Array, start: Array | None = None) -> Iterator[Snapshot]:
    """Design a lens.

    Parameters
    ----------
    scene : Scene
        The design task.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.
    start : ndarray, shape (n_u, n_v), optional
        Control heights to go on from; by default the run begins with the undesigned lens.

    Yields
    ------
    Snapshot
        First the lens before any step, then one after each iteration.

    Raises
    ------
    Refused
        If the scene cannot be run here.
    RunFailed
        If the run cannot go on; the snapshots up to then stay good.
    """
    # Given heights stand at the end of all stages already.
    parts = scene.parts()
    first = 0 if start is None else len(parts) - 1
    finished = ControlNet.of(scene.lens)
    iteration = 0
    seconds = 0.0  # time spent here, not where the snapshots go: a pause is not run time
    for stage, part in enumerate(parts[first:], first):
        net = ControlNet.of(part.lens)
        # The first lens of a later stage counts as an iteration: its loss is one of another task.
        steps = islice(_steps(part, target, start), part.run.iterations + (stage == first))
        lowest = math.inf
        while True:
            resumed = time.perf_counter()
            try:
                step = next(steps, None)
            except RunFailed as error:
                raise RunFailed(f"stopped at iteration {iteration}: {error}") from None
            if step is None:
                break
            heights = step.heights.cpu().double().numpy()
            best = step.loss < lowest
            if best:
                lowest, best_heights = step.loss, heights
            control_points = heights if net == finished else net.carry(heights, finished)
            irradiance = step.flux.cpu().double().numpy() / scene.screen.pixel_area
            seconds += time.perf_counter() - resumed
            yield Snapshot(
                iteration=iteration,
                iterations=scene.run.iterations,
                loss=step.loss,
                control_points=_frozen(control_points),
                irradiance=_frozen(irradiance),
                ledger=step.ledger,
                seconds=seconds,
                best=best,
                stage=stage,
                stages=len(parts),
                notes=step.notes,
            )
            iteration += 1
        if stage + 1 < len(parts):
            start = net.carry(best_heights, ControlNet.of(parts[stage + 1].lens))


def _steps(scene: Scene, target: Array, start: Array | None) -> Iterator[Step]:
    if isinstance(scene.run, PaperRun):
        return paper_steps(scene, target, scene.run, start)
    return auto_steps(scene, target, start)


def _frozen(values: Array) -> Array:
    copy = values.copy()
    copy.flags.writeable = False
    return copy
