"""Time of one evaluation of loss and gradient: ``python -m tests.benchmarks.kernels``.

The reference in torch and the compiled kernels take turns in one process: another program that
takes a core for a while slows both alike.
"""

import time
from collections.abc import Callable
from statistics import median

import numpy as np
import torch

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.arrays import Array
from workbench.design.limits import HeightLimits
from workbench.design.loss import paper_loss, share
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan, device_of
from workbench.scene import Scene

_EXAMPLES = ("flame", "flame-point", "flame-grid")  # collimated, one point, a grid of points
_ROUNDS = 7


def wavy(scene: Scene) -> Array:
    """Return control heights of a lens that bends light everywhere, by a tenth of the screen."""
    x, y = ControlNet.of(scene.optic).positions
    r_x, r_y = scene.optic.half_width
    rise = np.cos(np.pi * x / r_x)[:, None] * np.cos(1.5 * np.pi * y / r_y + 0.5)[None, :]
    receiver = scene.receiver
    # A slope s bends light by (n − 1) s.
    wide = zip(receiver.half_extent, receiver.per_radian(scene.optic.base.height), strict=True)
    slope = min(0.1 * r / far for r, far in wide) / scene.optic.deflection
    height = slope * min(r_x, r_y) / (1.5 * np.pi)
    limits = HeightLimits.of(scene.optic, ControlNet.of(scene.optic))
    height = min(height, 0.4 * float((limits.upper - limits.lower).min()))
    return np.asarray(limits.undesigned + height * rise)


def evaluation(example: BenchmarkTask, fused: bool) -> Callable[[], torch.Tensor]:
    """A call that returns the gradient by the control heights, of another lens each time."""
    device = device_of(example.scene)
    plan = Plan(example.scene, dtype=torch.float32, fused=fused)
    wanted = torch.as_tensor(share(example.target), dtype=torch.float32, device=device)
    heights = wavy(example.scene)
    # The search for intersections begins where it ended for the lens before.
    moved = heights.mean() + 0.98 * (heights - heights.mean())
    lenses = [torch.tensor(each, device=device, requires_grad=True) for each in (heights, moved)]

    def evaluate() -> torch.Tensor:
        lenses.reverse()
        loss = paper_loss(plan.trace({"lens.back": lenses[0]}).flux, wanted)
        (gradient,) = torch.autograd.grad(loss, lenses[:1])
        return gradient.cpu()

    return evaluate


def milliseconds(calls: dict[str, Callable[[], object]], rounds: int = _ROUNDS) -> dict[str, float]:
    """Median time of each call; the first round warms up and does not count."""
    taken: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds + 1):
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            taken[name].append(1e3 * (time.perf_counter() - start))
    return {name: median(each[1:]) for name, each in taken.items()}


if __name__ == "__main__":
    for name in _EXAMPLES:
        task = BenchmarkTask.of(name)
        ways = {"reference": False, "kernels": True}
        times = milliseconds({way: evaluation(task, fused) for way, fused in ways.items()})
        print(name, *(f"{way} {each:.1f} ms" for way, each in times.items()), sep="  ", flush=True)
