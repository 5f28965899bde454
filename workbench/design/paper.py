"""The method of the paper: flat start, Adam on the control heights through tanh."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.design.heights import HeightRange
from workbench.design.loss import check_finite, check_gradient, paper_loss, share
from workbench.design.step import Step
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan, device_of
from workbench.scene import BoxFilter, PaperRun, Scene

Array = npt.NDArray[np.float64]

# Half-widths of the interval, and the scatter, of the start's parameters: small enough to leave
# the lens flat to the eye, and large enough to make a visibly crooked one.
_UNIFORM, _RANDOM = 1e-4, 1e-2


def paper_steps(
    scene: Scene, target: Array, settings: PaperRun, start: Array | None
) -> Iterator[Step]:
    """Evaluate lens after lens, for ever; see `workbench.design.run.run`.

    Raises
    ------
    Refused
        If the filter has no gradient.
    RunFailed
        If the loss or its gradient is not finite.
    """
    if isinstance(scene.filter, BoxFilter):
        raise Refused(
            "filter.kind",
            "'box' is constant within a pixel and gives the paper's method no gradient; 'gaussian'",
        )
    device = device_of(scene)
    plan = Plan(scene)
    free = HeightRange.of(scene.lens, ControlNet.of(scene.lens), device)
    wanted = torch.as_tensor(share(target), dtype=torch.float32, device=device)
    parameters = _start(free, settings) if start is None else free.parameters(start)
    parameters.requires_grad_()
    optimiser = torch.optim.Adam([parameters], lr=settings.learning_rate)
    while True:
        heights = free.heights(parameters)
        traced = plan.trace(heights)
        loss = paper_loss(traced.flux, wanted)
        check_finite(loss, traced.ledger)
        yield Step(loss.item(), heights.detach(), traced.flux.detach(), traced.ledger)
        (parameters.grad,) = torch.autograd.grad(loss, [parameters])
        check_gradient(parameters.grad)
        optimiser.step()


def _start(free: HeightRange, settings: PaperRun) -> Tensor:
    noise = torch.zeros_like(free.rest)
    generator = torch.Generator(noise.device).manual_seed(settings.seed)
    if settings.start == "uniform":
        noise.uniform_(-_UNIFORM, _UNIFORM, generator=generator)
    elif settings.start == "random":
        noise.normal_(0, _RANDOM, generator=generator)
    return free.rest + noise
