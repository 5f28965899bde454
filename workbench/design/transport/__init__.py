"""A first design by optimal transport: where the light should go, and faces for that."""

from collections.abc import Callable, Sequence

import numpy as np
import torch

from workbench.design.transport.back_and_forth import c_transform, mapped, push
from workbench.design.transport.cells import between, in_perspective, met, whence
from workbench.design.transport.first_design import (
    First,
    behind_flat_entrance,
    first_design,
    first_of,
)
from workbench.design.transport.one_face import transport_start
from workbench.design.transport.refit import refitted
from workbench.optics import ready

__all__ = [
    "First",
    "behind_flat_entrance",
    "compile_all",
    "first_design",
    "first_of",
    "refitted",
    "transport_start",
]


def compile_all(
    goes_on: Callable[[], bool] = lambda: True, dtypes: Sequence[torch.dtype] = (torch.float32,)
) -> None:
    """Compile all kernels of a design before they are needed, or take them from disk.

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
