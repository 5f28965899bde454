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
from workbench.scene import PaperRun

# Half-width of the interval that the paper draws from; and, without a network, the scatter that
# makes a visibly crooked lens, where networks take the scatter that is usual for them.
_UNIFORM, _RANDOM = 1e-4, 1e-2


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
        return {self.numbers: math.sqrt(3) * _RANDOM}


class LocalLinks(nn.Module):
    """Layer whose neurons see the neurons within the degrees (p, q) of their own place.

    As a convolution with a kernel of (2p + 1) × (2q + 1), but every link has its own weight and
    every neuron its own bias. Those neurons are linked whose basis functions overlap. Links that
    would reach beyond the border do not exist.

    Attributes
    ----------
    source, target : Tensor of int64, shape (links,)
        Neurons before and after each link, counted along v first.
    weight : Tensor, shape (links,)
    bias : Tensor, shape (n_u * n_v,)
    """

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
        self.weight = nn.Parameter(torch.zeros(len(target), dtype=dtype))
        self.bias = nn.Parameter(torch.zeros(math.prod(net.shape), dtype=dtype))
        self.in_features = math.prod(2 * p + 1 for p in net.degree)

    def forward(self, signal: Tensor) -> Tensor:
        """Weighted sums of the neighbours plus the biases, shape (n_u * n_v,)."""
        along = self.weight * signal.index_select(0, self.source)
        return self.bias.index_add(0, self.target, along)


class Network(nn.Module):
    """Multi-layer perceptron with input 1 and tanh after every layer.

    The tanh after the last layer is that of the height range.

    Parameters
    ----------
    net : ControlNet
        Each layer has one neuron per control point.
    links : str
        "sparse" or "dense": how the second and third layer are linked to the one before.
    dtype : torch.dtype
        Single precision is enough: the heights themselves are kept in double precision.
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
        self.layers = nn.ModuleList([_full_links(1, neurons, dtype)])
        for _ in range(2):
            self.layers.append(
                LocalLinks(net, dtype)
                if links == "sparse"
                else _full_links(neurons, neurons, dtype)
            )

    def forward(self) -> Tensor:
        """What goes into the tanh of each control height, shape (n_u, n_v)."""
        signal = self.one
        *hidden, last = self.layers
        for layer in hidden:
            signal = torch.tanh(layer(signal))
        output: Tensor = last(signal)
        return output.view(self._shape)

    def scatter(self) -> dict[nn.Parameter, float]:
        """Half-width of the interval in which each parameter begins at random.

        That of torch's own layers: one over the root of the number of links into a neuron.
        """
        return {
            parameter: layer.in_features**-0.5
            for layer in self.layers
            for parameter in (layer.weight, layer.bias)
        }


def build(
    net: ControlNet, settings: PaperRun, device: torch.device | str = "cpu"
) -> Parameters | Network:
    """What a run optimises, at its start.

    Parameters
    ----------
    net : ControlNet
        Control net of the heights.
    settings : PaperRun
        Which parametrisation, from which start, drawn by which seed.
    device : torch.device or str
        Where it computes.
    """
    kind = settings.parametrisation
    module = Parameters(net) if kind == "none" else Network(net, kind)
    module.to(device)
    if settings.start != "zeros":
        generator = torch.Generator(device).manual_seed(settings.seed)
        with torch.no_grad():
            for parameter, width in module.scatter().items():
                reach = width if settings.start == "random" else _UNIFORM
                parameter.uniform_(-reach, reach, generator=generator)
    return module


def _full_links(inputs: int, outputs: int, dtype: torch.dtype) -> nn.Linear:
    # Without the random numbers that torch would begin with: 33 million take their time.
    layer = nn.utils.skip_init(nn.Linear, inputs, outputs, dtype=dtype)
    for parameter in layer.parameters():
        nn.init.zeros_(parameter)
    return layer
