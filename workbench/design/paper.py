"""The method of the paper: Adam on the control heights through tanh, or through a network."""

from collections.abc import Generator
from typing import NoReturn

import torch

from workbench.design.lens_state import LensState
from workbench.design.loss import (
    check_finite,
    check_gradient,
    check_light,
    measure_of,
    paper_loss,
    share,
)
from workbench.design.networks import build
from workbench.design.room import Room
from workbench.design.smoothness import Smoothness
from workbench.design.step import Step
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan, device_of
from workbench.scene import PaperRun


def paper_steps(room: Room, settings: PaperRun) -> Generator[Step, None, NoReturn]:
    """Evaluate lens after lens, for ever; see `workbench.design.run.run`.

    The inputs of the tanh are those of the undesigned lens, or of the start, plus how far the
    parametrisation has moved since its own start. So a run with a network goes on from any
    heights exactly, as if the biases of its last layer had been set to them.

    Raises
    ------
    RunFailed
        If the loss or its gradient is not finite.
    """
    scene, start = room.scene, room.start
    device = device_of(scene)
    plan = Plan(scene, locked=room.locked)
    net = ControlNet.of(scene.lens)
    free = room.height_range(device)
    wanted = torch.as_tensor(share(room.target), dtype=torch.float32, device=device)
    relative = measure_of(scene.receiver, device)
    smoothness = Smoothness.of(scene, room.target, device)
    shift = build(net, settings, device)
    rest = free.rest
    if start is not None:
        rest = free.parameters(start) - shift().detach()
    optimiser = torch.optim.Adam(shift.parameters(), lr=settings.rate, fused=True)
    while True:
        shaped = free.heights(rest + shift())
        # The light's gradient ends at the heights, where it is checked; the network's begins.
        heights = {face: each.detach().requires_grad_() for face, each in shaped.items()}
        traced = plan.trace(heights)
        check_light(traced.flux.detach(), traced.account)
        loss = paper_loss(traced.flux, wanted, relative)
        check_finite(loss, traced.account)
        measure = scene.receiver.pixel_measure
        state = LensState.traced(heights, traced.flux, measure, loss, traced.account)
        step = Step(state, plan.notes)
        if smoothness is not None:
            loss = smoothness.merit(loss, smoothness.penalty(heights))
            step = step._replace(merit=loss.item())
        yield step
        gradients = torch.autograd.grad(loss, list(heights.values()))
        for gradient in gradients:
            check_gradient(gradient)
        optimiser.zero_grad()  # gives the memory back before the next gradient needs it
        torch.autograd.backward(list(shaped.values()), gradients)
        optimiser.step()
        plan.next_iteration()
