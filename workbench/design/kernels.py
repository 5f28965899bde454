"""All that numba compiles for a design, got ready before it is needed."""

from collections.abc import Callable, Sequence

import numpy as np
import torch

from workbench.design.transport.between import between, whence
from workbench.design.transport.envelope import c_transform
from workbench.design.transport.meeting import met
from workbench.design.transport.perspective import in_perspective
from workbench.design.transport.push import mapped, push
from workbench.optics import ready


def compile_all(
    goes_on: Callable[[], bool] = lambda: True, dtypes: Sequence[torch.dtype] = (torch.float32,)
) -> None:
    """Compile the transport start and all kernels of the trace, or take them from disk.

    Parameters
    ----------
    goes_on : callable
        Asked before each part; the rest is left out once it says no.
    dtypes : sequence of torch.dtype
        Float types of the traces; few scenes need float64.
    """
    try:
        if goes_on():
            mass = np.full((2, 2), 0.25)
            push(mass, *mapped(c_transform(np.zeros((2, 2)), 1.0, 1.0), 1.0, 1.0))
            pair = mass, mass
            between(mass, whence(pair, pair, pair))
            met((mass, mass, mass), (1.0, 1.0), pair, pair)
            in_perspective(mass, np.eye(3), cells=2, samples=1)
    finally:  # what cannot be compiled is raised, and keeps no other kernel from being ready
        for dtype in dtypes:
            ready.compile_all(goes_on, dtype)
