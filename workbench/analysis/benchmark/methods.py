"""The design methods that are compared: each yields (seconds, control points), ever better."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.benchmark.examples import Example
from workbench.design.run import run
from workbench.scene import Scene

Array = npt.NDArray[np.float64]
Method = Callable[[Example, int | None], Iterator[tuple[float, Array]]]

_PAPER_ITERATIONS = 1000  # as in the paper


def _auto(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    return _designed(example, {"method": "auto"}, iterations or example.scene.run.iterations)


def _paper(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    return _designed(example, {"method": "paper"}, iterations or _PAPER_ITERATIONS)


def _designed(
    example: Example, settings: dict[str, Any], iterations: int
) -> Iterator[tuple[float, Array]]:
    before = example.scene.run
    kept = {"iterations": iterations, "seed": before.seed, "device": before.device}
    scene = Scene.from_data(example.scene.to_data() | {"run": settings | kept})
    for snapshot in run(scene, example.target):
        if snapshot.best:
            best = snapshot.control_points
        yield snapshot.seconds, best


METHODS: dict[str, Method] = {"paper": _paper, "auto": _auto}
"""What is compared, by name. The first is the one that others are measured against."""
