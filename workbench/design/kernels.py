"""All that numba compiles for a design, got ready before it is needed."""

from collections.abc import Callable

import numpy as np

from workbench.design.transport.envelope import c_transform
from workbench.design.transport.push import mapped, push
from workbench.optics.kernels import ready


def compile_all(goes_on: Callable[[], bool] = lambda: True) -> None:
    """Compile the transport start and all kernels of the trace, or take them from disk.

    Parameters
    ----------
    goes_on : callable
        Asked before each part; the rest is left out once it says no.
    """
    if goes_on():
        mass = np.full((2, 2), 0.25)
        push(mass, *mapped(c_transform(np.zeros((2, 2)), 1.0, 1.0), 1.0, 1.0))
    ready.compile_all(goes_on)
