"""A linear step on arrays, as one that torch differentiates."""

from collections.abc import Callable
from typing import Any

import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from workbench.arrays import Array

Step = Callable[[Array], Array]


def linear_step(forward: Step, adjoint: Step, values: Tensor) -> Tensor:
    """Return ``forward`` of values on their device; cotangents go through ``adjoint``."""
    found: Tensor = _Linear.apply(forward, adjoint, values)  # type: ignore[no-untyped-call]
    return found


class _Linear(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, forward: Step, adjoint: Step, values: Tensor) -> Tensor:
        ctx.adjoint = adjoint
        return _of(forward, values)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, cotangent: Tensor) -> tuple[None, None, Tensor]:
        return None, None, _of(ctx.adjoint, cotangent)


def _of(step: Step, values: Tensor) -> Tensor:
    found = step(values.detach().double().cpu().numpy())
    return torch.as_tensor(found, dtype=values.dtype, device=values.device)
