"""The design methods that are compared: each yields (seconds, control points), ever better."""

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.benchmark.examples import Example
from workbench.design.limits import HeightLimits
from workbench.design.run import run
from workbench.design.transport import transport_start
from workbench.errors import RunFailed
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels.ready import held_back
from workbench.scene import Scene

Array = npt.NDArray[np.float64]
Method = Callable[[Example, int | None], Iterator[tuple[float, Array]]]

_PAPER_ITERATIONS = 1000  # as in the paper
# With a finer net and the paper's rays its own loss falls and the verified error rises.
_PAPER_NET = 64


def _auto(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    return _designed(example, {"method": "auto"}, iterations or example.scene.run.iterations)


def _paper(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    n_u, n_v = example.scene.lens.control_points
    net = {"control_points": (min(n_u, _PAPER_NET), min(n_v, _PAPER_NET))}
    lens = example.scene.lens.model_copy(update=net)
    coarse = replace(example, scene=example.scene.model_copy(update={"lens": lens}))
    return _designed(coarse, {"method": "paper"}, iterations or _PAPER_ITERATIONS)


def _paper_on_torch(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    """As printed: the same in plain torch, without the kernels."""
    with held_back():
        yield from _paper(example, iterations)


def _transport(example: Example, iterations: int | None) -> Iterator[tuple[float, Array]]:
    """The first lens of ``auto`` alone."""
    begun = time.perf_counter()
    first = transport_start(example.scene, example.target)
    if first is None:
        raise RunFailed("no light leaves the lens, so there is none to transport")
    limits = HeightLimits.of(example.scene.lens, ControlNet.of(example.scene.lens))
    yield time.perf_counter() - begun, limits.nearest(first)


def _designed(
    example: Example, settings: dict[str, Any], iterations: int
) -> Iterator[tuple[float, Array]]:
    before = example.scene.run
    kept = {"iterations": iterations, "seed": before.seed, "device": before.device}
    scene = Scene.from_data(example.scene.to_data() | {"run": settings | kept})
    for snapshot in run(scene, example.target):
        if snapshot.best:
            best = snapshot.state.heights["exit"]
        yield snapshot.seconds, best


METHODS: dict[str, Method] = {
    "paper on torch": _paper_on_torch,
    "paper": _paper,
    "transport": _transport,
    "auto": _auto,
}
"""What is compared, by name. The first is the one that others are measured against."""
