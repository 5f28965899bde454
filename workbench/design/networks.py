"""What the paper's method optimises: control heights, or a network that puts them out.

De Koning et al. (2023), sections 2.3 and 2.3.1. A network has the input 1, so it approximates no
function: it is another set of coordinates for the space of lenses, in which Adam takes other
steps. The paper gives the dense one three layers of control-net size and leaves the depth of the
sparse one open; it gets three as well, so that the two differ in their links alone and, with two
layers of links, a control height depends on the neighbours of its neighbours.
"""

import math
from typing import Literal

import numpy as np
import torch
from torch import Tensor, nn

from workbench.geometry.surface import ControlNet
from workbench.scene import Run

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
