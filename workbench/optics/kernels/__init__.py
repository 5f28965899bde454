"""Fused kernels for the CPU: the twins of the torch reference that do a whole trace in one pass."""

from typing import Any

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import AnyArray
from workbench.geometry.surface import ControlNet


def kind_of(dtype: torch.dtype) -> type[np.floating[Any]]:
    """Numpy's name of a float type of torch."""
    return np.float32 if dtype == torch.float32 else np.float64


def check_size(heights: Tensor, net: ControlNet) -> None:
    """Refuse heights of another size than the net that a kernel is made for."""
    if heights.shape != net.shape:
        ours, theirs = (" × ".join(map(str, shape)) for shape in (net.shape, heights.shape))
        raise ValueError(f"the kernel traces {ours} control heights, not {theirs}")


def as_array(values: Tensor) -> AnyArray:
    """Return the values of a tensor on the CPU, contiguous."""
    return np.asarray(values.contiguous().numpy())
