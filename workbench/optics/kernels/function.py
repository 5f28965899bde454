"""Brings a kernel with a hand-written adjoint into torch's automatic differentiation."""

from typing import Any, NamedTuple, Protocol

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

AnyArray = npt.NDArray[np.floating[Any]]


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


def trace(heights: Tensor, level: float, dtype: torch.dtype, passes: Passes) -> tuple[Tensor, Sums]:
    """Run a kernel so that torch can differentiate its image.

    Parameters
    ----------
    heights : Tensor, shape (n_u, n_v)
        Control heights of any float type, on the CPU.
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
    """
    sums: list[Sums] = []
    flux = _Trace.apply((heights - level).to(dtype), passes, sums)  # type: ignore[no-untyped-call]
    return flux, sums[0]


class _Trace(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, heights: Tensor, passes: Passes, sums: list[Sums]) -> Tensor:
        ctx.passes = passes
        ctx.save_for_backward(heights)
        image, found = passes.forward(heights.contiguous().numpy())
        sums.append(found)
        return torch.from_numpy(image)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[Tensor, None, None]:
        (heights,) = ctx.saved_tensors
        gradient = ctx.passes.backward(heights.contiguous().numpy(), cotangent.contiguous().numpy())
        return torch.from_numpy(gradient).to(heights.dtype), None, None
