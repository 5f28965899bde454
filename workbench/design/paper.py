"""The method of the paper: Adam on the control heights through tanh, or through a network.

De Koning et al. (2023), sections 2.3 and 2.3.1. A network has the input 1: it is another set of
coordinates for the space of lenses. The paper gives the dense one three layers of the net's size
and leaves the depth of the sparse one open; it gets three as well.
"""

import math
from collections.abc import Generator, Mapping
from typing import Literal, NoReturn

import numpy as np
import torch
from torch import Tensor, nn

from workbench.arrays import Array
from workbench.design.bounds import Bounds
from workbench.design.lens_state import LensState, Step
from workbench.design.loss import (
    check_finite,
    check_gradient,
    check_light,
    measure_of,
    paper_loss,
    share,
)
from workbench.design.net import check_memory
from workbench.design.smoothness import Smoothness
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.optics.plan import Plan, device_of
from workbench.scene import Run, Scene
from workbench.scene.making.uncertainty import Uncertainty


class FilteredImage:
    """Compares lenses with the target by the light that lands on the screen.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y. Raises `Refused` if the scene
    asks for a device that is not there, or for several images.
    """

    def __init__(self, scene: Scene, target: Array) -> None:
        scene.check_one_image("the paper's method")
        device = device_of(scene)
        self._scene, self._plan = scene, Plan(scene)
        self._wanted = torch.as_tensor(share(target), dtype=torch.float32, device=device)
        self._relative = measure_of(scene.receiver, device)
        self._pixel_measure = scene.receiver.pixel_measure

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """The loss, and the step to report.

        Raises `RunFailed` if no light reaches the screen, or the loss is not finite.
        """
        traced = self._plan.trace(heights)
        check_light(traced.flux.detach(), traced.account, self._scene)
        loss = paper_loss(traced.flux, self._wanted, self._relative)
        check_finite(loss, traced.account)
        state = LensState.traced(heights, traced.flux, self._pixel_measure, loss, traced.account)
        return loss, Step(state, self._plan.notes)

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        self._plan.next_iteration()


# Half-width of the interval that the paper draws from.
_UNIFORM = 1e-4

# Standard deviation of what goes into the last tanh of a random start, for all parametrisations:
# it makes a visibly crooked lens. What torch's layers would put out, some twenty times as much,
# makes one so rough that it throws nearly all light beside the screen and never recovers.
_RANDOM = 1e-2


class Parameters(nn.Module):
    """No network: one number per control height."""

    def __init__(self, net: ControlNet) -> None:
        super().__init__()
        self.numbers = nn.Parameter(torch.zeros(net.shape, dtype=torch.float64))

    def forward(self) -> Tensor:
        """What goes into the tanh of each control height, shape (n_u, n_v)."""
        return self.numbers

    def scatter(self) -> dict[nn.Parameter, float]:
        """Half-width of the interval in which each parameter begins at random."""
        return {self.numbers: 1.0}

    def last(self) -> tuple[nn.Parameter, ...]:
        """The parameters to which the output is proportional."""
        return (self.numbers,)


class FullLinks(nn.Module):
    """Layer whose neurons see every neuron of the layer before.

    `weight` (outputs, inputs); `bias` (outputs,); `inputs`: links into a neuron.
    """

    def __init__(self, inputs: int, outputs: int, dtype: torch.dtype) -> None:
        super().__init__()
        self.inputs = inputs
        self.weight = nn.Parameter(torch.zeros(outputs, inputs, dtype=dtype))
        self.bias = nn.Parameter(torch.zeros(outputs, dtype=dtype))

    def forward(self, signal: Tensor) -> Tensor:
        """Weighted sums plus the biases, shape (outputs,)."""
        return torch.addmv(self.bias, self.weight, signal)


class LocalLinks(nn.Module):
    """Layer whose neurons see the neurons within the degrees (p, q) of their own place.

    As a convolution with a kernel of (2p + 1) × (2q + 1), but every link has its own weight and
    every neuron its own bias. Those neurons are linked whose basis functions overlap. Links that
    would reach beyond the border do not exist.

    `weight` (links,); `bias` (n_u * n_v,); `inputs`: links into a neuron that is not near the
    border.
    """

    # (links,), neurons before and after each link, counted along v first.
    source: Tensor
    target: Tensor

    def __init__(self, net: ControlNet, dtype: torch.dtype) -> None:
        super().__init__()
        near_u, near_v = (
            np.abs(np.subtract.outer(np.arange(n), np.arange(n))) <= p
            for n, p in zip(net.shape, net.degree, strict=True)
        )
        (to_u, from_u), (to_v, from_v) = np.nonzero(near_u), np.nonzero(near_v)
        target = np.add.outer(to_u * net.shape[1], to_v).ravel()
        source = np.add.outer(from_u * net.shape[1], from_v).ravel()
        self.register_buffer("target", torch.from_numpy(target), persistent=False)
        self.register_buffer("source", torch.from_numpy(source), persistent=False)
        self.inputs = math.prod(2 * p + 1 for p in net.degree)
        self.weight = nn.Parameter(torch.zeros(len(target), dtype=dtype))
        self.bias = nn.Parameter(torch.zeros(math.prod(net.shape), dtype=dtype))

    def forward(self, signal: Tensor) -> Tensor:
        """Weighted sums of the neighbours plus the biases, shape (n_u * n_v,)."""
        along = self.weight * signal.index_select(0, self.source)
        return self.bias.index_add(0, self.target, along)


class Network(nn.Module):
    """Multi-layer perceptron with input 1 and tanh after every layer.

    The tanh after the last layer is that of the height range.

    `net`: each layer has one neuron per control point; `links`: "sparse" or "dense": how the second
    and third layer are linked to the one before; `dtype`: single precision is enough: the heights
    themselves are kept in double precision.
    """

    one: Tensor

    def __init__(
        self,
        net: ControlNet,
        links: Literal["sparse", "dense"],
        dtype: torch.dtype = torch.float32,
    ) -> None:
        super().__init__()
        self._shape = net.shape
        neurons = math.prod(net.shape)
        self.register_buffer("one", torch.ones(1, dtype=dtype), persistent=False)
        self.first = FullLinks(1, neurons, dtype)
        self.second, self.third = (
            LocalLinks(net, dtype) if links == "sparse" else FullLinks(neurons, neurons, dtype)
            for _ in range(2)
        )

    def forward(self) -> Tensor:
        """What goes into the tanh of each control height, shape (n_u, n_v)."""
        signal = torch.tanh(self.first(self.one))
        signal = torch.tanh(self.second(signal))
        output: Tensor = self.third(signal)
        return output.view(self._shape)

    def scatter(self) -> dict[nn.Parameter, float]:
        """Half-width of the interval in which each parameter begins at random.

        That of torch's own layers: one over the root of the number of links into a neuron.
        """
        return {
            parameter: 1 / math.sqrt(layer.inputs)
            for layer in (self.first, self.second, self.third)
            for parameter in (layer.weight, layer.bias)
        }

    def last(self) -> tuple[nn.Parameter, ...]:
        """The parameters to which the output is proportional."""
        return self.third.weight, self.third.bias


def build(
    net: ControlNet, settings: Run, device: torch.device | str = "cpu"
) -> Parameters | Network:
    """What a run optimises, at its start.

    "zeros" makes a network behave as none: signals and hence all gradients but those of the last
    biases stay 0. "random" draws as torch's layers do, and then scales the last layer so that
    all parametrisations begin with lenses that are equally crooked.

    `net`: control net of the heights; `settings`: which parametrisation, from which start, drawn by
    which seed; `device`: where it computes.
    """
    kind = settings.parametrisation
    module = Parameters(net) if kind == "none" else Network(net, kind)
    module.to(device)
    if settings.start == "zeros":
        return module
    generator = torch.Generator(device).manual_seed(settings.seed)
    with torch.no_grad():
        for parameter, width in module.scatter().items():
            bound = width if settings.start == "random" else _UNIFORM
            parameter.uniform_(-bound, bound, generator=generator)
        if settings.start == "random":
            factor = _RANDOM / module().std()
            for parameter in module.last():
                parameter.mul_(factor)
    return module


def check_paper(scene: Scene) -> None:
    """Refuse several images, one without a gradient, or a network that does not fit into memory.

    Raises `Refused` with the path of the field.
    """
    if not scene.filter.smooth:
        raise Refused(
            "filter.kind",
            Message(
                "'box' is constant within a pixel and gives the paper's method no gradient; "
                "'gaussian'"
            ),
        )
    scene.check_one_image(Message("the paper's method"))
    scene.check_no_diffuser(Message("the paper's method"))
    for name, given in (
        ("processes", scene.processes),
        ("uncertainty", scene.uncertainty != Uncertainty()),
    ):
        if given:
            exact = Message("the paper's method designs for the exact set-up; method 'auto'")
            raise Refused(name, exact)
    check_memory(scene)


def paper_steps(bounds: Bounds) -> Generator[Step, None, NoReturn]:
    """Evaluate lens after lens, for ever; see `workbench.design.run.run`.

    The inputs of the tanh are those of the undesigned lens, apart from the ends, or of the start,
    plus how far the parametrisation has moved since its own start. So a run with a network goes on
    from any heights exactly, as if the biases of its last layer had been set to them.

    Raises `RunFailed` if the loss or its gradient is not finite.
    """
    scene, start = bounds.scene, bounds.start
    device = device_of(scene)
    image = FilteredImage(scene, bounds.target)
    free = bounds.height_range(device)
    smoothness = Smoothness.of(scene, bounds.target, device)
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
