"""Error of a lens as made beside that as designed, and the share of each process."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.scatter import tracing_independently
from workbench.analysis.validation import validating
from workbench.analysis.validation_figures import MadeStep, Validation
from workbench.arrays import Array
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene
from workbench.scene.part import title_of


def checking(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    rays: int = 4_000_000,
    threads: int | None = None,
) -> Steps[Validation]:
    """Check a lens thoroughly in steps: as made, as designed, and between its processes.

    Each further error comes from at most as many random rays. Raises `Refused` and `RunFailed` as
    `workbench.analysis.validation.validate`.
    """
    count = len(scene.processes)
    steps = validating(scene, target, heights, rays, threads=threads, accuracy=ACCURACY)
    found = yield from within(steps, partial(of_equal, count + 1, 0))
    if count == 0:
        return found
    first, *_ = scene.single
    clearest, errors = found.by_cells or found, []
    for number in range(count):
        part = first.model_copy(update={"processes": scene.processes[:number]})
        more = tracing_independently(
            part, heights, target, ACCURACY, threads=threads, random_rays=rays // 4
        )
        error = (yield from within(more, partial(of_equal, count + 1, number + 1))).unscattered
        errors.append((error.distance, error.interval))
    errors.append((clearest.relative_l2_corrected, clearest.relative_l2_corrected_interval))
    return replace(found, steps=_steps(scene, errors))


def _steps(
    scene: Scene, errors: Sequence[tuple[float, tuple[float, float]]]
) -> tuple[MadeStep, ...]:
    titles = ("", *(title_of(type(process)) for process in scene.processes))
    before = (errors[0], *errors)
    return tuple(
        MadeStep(title, error, interval, error - last)
        for title, (error, interval), (last, _) in zip(titles, errors, before, strict=False)
    )
