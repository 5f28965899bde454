"""A design run: a generator of immutable snapshots.

Whoever runs it stops it by leaving the loop and pauses it by not asking for the next snapshot,
so both take effect within one iteration.
"""

import math
import time
from collections.abc import Iterator
from itertools import count, islice

import numpy as np
import numpy.typing as npt
from torch import Tensor

from workbench.design.auto import auto_steps
from workbench.design.paper import paper_steps
from workbench.design.snapshot import Snapshot
from workbench.design.step import Step
from workbench.errors import RunFailed
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
    settings = scene.run
    steps = islice(_steps(scene, target, start), settings.iterations + 1)
    lowest = math.inf
    seconds = 0.0  # time spent here, not where the snapshots go: a pause is not run time
    for iteration in count():
        resumed = time.perf_counter()
        try:
            step = next(steps, None)
        except RunFailed as error:
            raise RunFailed(f"stopped at iteration {iteration}: {error}") from None
        if step is None:
            return
        best = step.loss < lowest
        lowest = min(lowest, step.loss)
        control_points = _frozen(step.heights)
        irradiance = _frozen(step.flux / scene.screen.pixel_area)
        seconds += time.perf_counter() - resumed
        yield Snapshot(
            iteration=iteration,
            iterations=settings.iterations,
            loss=step.loss,
            control_points=control_points,
            irradiance=irradiance,
            ledger=step.ledger,
            seconds=seconds,
            best=best,
        )


def _steps(scene: Scene, target: Array, start: Array | None) -> Iterator[Step]:
    if isinstance(scene.run, PaperRun):
        return paper_steps(scene, target, scene.run, start)
    return auto_steps(scene, target, start)


def _frozen(values: Tensor) -> Array:
    copy = values.cpu().double().numpy().copy()
    copy.flags.writeable = False
    return copy
