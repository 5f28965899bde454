"""The method of the paper: Adam on the control heights through tanh, or through a network."""

from collections.abc import Generator
from typing import NoReturn

import torch

from workbench.design.filtered_image import FilteredImage
from workbench.design.loss import check_gradient
from workbench.design.networks import build
from workbench.design.parametrisation import check_memory
from workbench.design.room import Room
from workbench.design.smoothness import Smoothness
from workbench.design.step import Step
from workbench.errors import Refused
from workbench.geometry.surface import nets_of
from workbench.optics.plan import device_of
from workbench.said import Said
from workbench.scene import Scene


def check_paper(scene: Scene) -> None:
    """Refuse several images, one without a gradient, or a network that does not fit into memory.

    Raises `Refused` with the path of the field.
    """
    if not scene.filter.smooth:
        raise Refused(
            "filter.kind",
            Said(
                "'box' is constant within a pixel and gives the paper's method no gradient; "
                "'gaussian'"
            ),
        )
    scene.check_one_image(Said("the paper's method"))
    scene.check_no_diffuser(Said("the paper's method"))
    check_memory(scene)


def paper_steps(room: Room) -> Generator[Step, None, NoReturn]:
    """Evaluate lens after lens, for ever; see `workbench.design.run.run`.

    The inputs of the tanh are those of the undesigned lens, apart from the ends, or of the start,
    plus how far the parametrisation has moved since its own start. So a run with a network goes on
    from any heights exactly, as if the biases of its last layer had been set to them.

    Raises `RunFailed` if the loss or its gradient is not finite.
    """
    scene, start = room.scene, room.start
    device = device_of(scene)
    image = FilteredImage(scene, room.target)
    free = room.height_range(device)
    smoothness = Smoothness.of(scene, room.target, device)
    shifts = {face: build(net, scene.run, device) for face, net in nets_of(scene).items()}
    rest = free.apart
    if start is not None:
        rest = {face: z - shifts[face]().detach() for face, z in free.parameters(start).items()}
    numbers = [number for shift in shifts.values() for number in shift.parameters()]
    optimiser = torch.optim.Adam(numbers, lr=scene.run.rate, fused=True)
    while True:
        shaped = free.heights({face: z + shifts[face]() for face, z in rest.items()})
        # The light's gradient ends at the heights, where it is checked; the network's begins.
        heights = {face: each.detach().requires_grad_() for face, each in shaped.items()}
        loss, step = image.compare(heights)
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
        image.next_iteration()
