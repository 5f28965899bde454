"""Brings a kernel with a hand-written adjoint into torch's automatic differentiation."""

from typing import Any, NamedTuple, Protocol

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import AnyArray
from workbench.geometry.surface import ControlNet


class Sums(NamedTuple):
    """Flux that reached the screen, passed it by, or was lost at the exit face or before it."""

    on_screen: float
    off_screen: float
    total_reflection: float
    reflected: float
    missed: float = 0.0
    absorbed: float = 0.0


class Passes(Protocol):
    """A trace and its adjoint, for one screen and filter."""

    def forward(self, heights: AnyArray) -> tuple[AnyArray, Sums]:
        """Image (n_y, n_x) and sums of a lens with heights (n_u, n_v) in the trace's float type."""
        ...

    def backward(self, heights: AnyArray, cotangent: AnyArray) -> AnyArray:
        """Cotangent of the heights (n_u, n_v) from that of the image (n_y, n_x)."""
        ...


def kind_of(dtype: torch.dtype) -> type[np.floating[Any]]:
    """Numpy's name of a float type of torch."""
    return np.float32 if dtype == torch.float32 else np.float64


def trace(
    heights: Tensor, net: ControlNet, level: float, dtype: torch.dtype, passes: Passes
) -> tuple[Tensor, Sums]:
    """Run a kernel so that torch can differentiate its image.

    Parameters
    ----------
    heights : Tensor, shape (n_u, n_v)
        Control heights of any float type, on the CPU.
    net : ControlNet
        Control net that the kernel is made for.
    level : float
        Taken off the heights before they become ``dtype``, so that float32 keeps their digits.
    dtype : torch.dtype
        Float type of the kernel.
    passes : Passes
        The kernel and its adjoint.

    Returns
    -------
    tuple of Tensor and Sums
        Flux in each pixel, shape (n_y, n_x), differentiable; and the sums.

    Raises
    ------
    ValueError
        If these are heights of a net of another size.
    """
    check_size(heights, net)
    sums: list[Sums] = []
    flux = _Trace.apply(passes, sums, (heights - level).to(dtype))  # type: ignore[no-untyped-call]
    return flux, sums[0]


def check_size(heights: Tensor, net: ControlNet) -> None:
    """Refuse heights of another size than the net that a kernel is made for."""
    if heights.shape != net.shape:
        ours, theirs = (" × ".join(map(str, shape)) for shape in (net.shape, heights.shape))
        raise ValueError(f"the kernel traces {ours} control heights, not {theirs}")


class _Trace(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, passes: Passes, sums: list[Any], heights: Tensor) -> Tensor:
        ctx.passes = passes
        ctx.save_for_backward(heights)
        made, found = passes.forward(as_array(heights))
        sums.append(found)
        return torch.from_numpy(made)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[None, None, Tensor]:
        (heights,) = ctx.saved_tensors
        gradient = ctx.passes.backward(as_array(heights), as_array(cotangent))
        return None, None, torch.from_numpy(gradient).to(heights.dtype)


def as_array(values: Tensor) -> AnyArray:
    """Return the values of a tensor on the CPU, contiguous."""
    return np.asarray(values.contiguous().numpy())
