"""Error of a lens as made beside that as designed, and the share of each process."""

from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

from workbench.analysis.scatter import CorrectedDistance, tracing_independently
from workbench.arrays import Array
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene
from workbench.scene.part import title_of


class MadeStep(NamedTuple):
    """Error of a lens after a process and those before it."""

    title: str  # of the process; empty for the lens as designed
    error: CorrectedDistance  # relative L2 distance of the first image to its target

    def to_data(self) -> dict[str, Any]:
        """The step by names, for JSON."""
        low, high = self.error.interval
        return {
            "process": self.title or None,
            "relative_l2": self.error.distance,
            "interval": [low, high],
        }


def tracing_made(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    accuracy: float = 1e-3,
    rays: int = 1_000_000,
) -> Steps[tuple[MadeStep, ...]]:
    """Find the errors as designed and after each process, by independent random rays.

    Each has at most four times ``rays``. Raises `Refused` as `workbench.analysis.validation`.
    """
    first, *_ = scene.single
    count, found = len(scene.processes) + 1, []
    for number in range(count):
        part = first.model_copy(update={"processes": scene.processes[:number]})
        steps = tracing_independently(part, heights, target, accuracy, random_rays=rays)
        error = yield from within(steps, partial(of_equal, count, number))
        title = title_of(type(scene.processes[number - 1])) if number else ""
        found.append(MadeStep(title, error.unscattered))
    return tuple(found)
