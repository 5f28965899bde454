"""The design methods that are compared: each yields lens after lens, ever better."""

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import takewhile
from typing import NamedTuple

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.metrics import relative_l2
from workbench.arrays import Array
from workbench.design.limits import HeightLimits
from workbench.design.run import run
from workbench.design.transport import transport_start
from workbench.errors import RunFailed
from workbench.geometry.surface import ControlNet
from workbench.optics.ready import held_back
from workbench.scene import Scene


class MethodLens(NamedTuple):
    """A lens that a method has found."""

    seconds: float  # time of the method up to here
    # (n_u, n_v), control heights of the exit face, on a net that may be the method's own.
    heights: Array
    # Relative L2 error of the image as the method itself sees it, if it does.
    own: float | None = None


Method = Callable[[BenchmarkTask, int | None], Iterator[MethodLens]]

_PAPER_ITERATIONS = 1000  # as in the paper
# With a finer net and the paper's rays its own loss falls and the verified error rises.
_PAPER_NET = 64
_PAPER_SECONDS = 10.0  # no longer, so that all scenes together end soon


def _auto(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    return _designed(example, "auto", iterations or example.scene.run.iterations)


def _paper(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    n_u, n_v = example.scene.optic.net_shape
    net = min(n_u, _PAPER_NET), min(n_v, _PAPER_NET)
    lens = example.scene.optic.shaped(control_points=net)
    coarse = replace(example, scene=example.scene.with_optic(lens))
    lenses = _designed(coarse, "paper", iterations or _PAPER_ITERATIONS)
    return takewhile(lambda lens: lens.seconds <= _PAPER_SECONDS, lenses)


def _paper_on_torch(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    """As printed: the same in plain torch, without the kernels."""
    with held_back():
        yield from _paper(example, iterations)


def _transport(example: BenchmarkTask, iterations: int | None) -> Iterator[MethodLens]:
    """The first lens of ``auto`` alone."""
    start = time.perf_counter()
    first = transport_start(example.scene, example.target)
    if first is None:
        raise RunFailed("no light leaves the lens, so there is none to transport")
    limits = HeightLimits.of(example.scene.optic, ControlNet.of(example.scene.optic))
    yield MethodLens(time.perf_counter() - start, limits.nearest(first))


def _designed(example: BenchmarkTask, method: str, iterations: int) -> Iterator[MethodLens]:
    before = example.scene.run
    settings = {"iterations": iterations, "seed": before.seed, "device": before.device}
    scene = Scene.from_data(example.scene.to_data() | {"run": {"method": method} | settings})
    for snapshot in run(scene, example.target):
        if snapshot.best:
            heights = snapshot.state.heights[example.scene.optic.designed_face]
            own = relative_l2(snapshot.state.irradiance, example.target)
        yield MethodLens(snapshot.seconds, heights, own)


METHODS: dict[str, Method] = {
    "paper on torch": _paper_on_torch,
    "paper": _paper,
    "transport": _transport,
    "auto": _auto,
}
"""What is compared, by name."""
