"""Which kernels are compiled, and compiling them before they are needed.

Numba compiles a kernel at its first call, some seconds long, and keeps it on disk. A window lets a
thread of its own do that (`compile_all`); a plan asks `is_ready` before each trace and takes the
reference while another thread is still at it. Where nobody is, a plan compiles what it needs at
once: a program without a window may as well wait.
"""

import threading
from collections.abc import Callable

import torch

from workbench.optics.kernels import collimated, face, point

# What compiles a kernel for a float type, by tiny calls.
_COMPILERS: dict[str, Callable[[torch.dtype], None]] = {
    "collimated": collimated.compile_for,
    "face": face.compile_for,
    "point": point.compile_for,
}

_ready: set[tuple[str, torch.dtype]] = set()
_compiling = threading.Lock()


def is_ready(name: str, dtype: torch.dtype) -> bool:
    """Whether a kernel can be called now; compiles it unless another thread is compiling."""
    if (name, dtype) in _ready:
        return True
    if not _compiling.acquire(blocking=False):
        return False
    try:
        _compile(name, dtype)
    finally:
        _compiling.release()
    return True


def compile_all(goes_on: Callable[[], bool] = lambda: True) -> None:
    """Compile all kernels for float32, which designs use, one after the other.

    Parameters
    ----------
    goes_on : callable
        Asked before each kernel; the rest is left out once it says no.
    """
    for name in _COMPILERS:
        if not goes_on():
            return
        with _compiling:
            _compile(name, torch.float32)


def _compile(name: str, dtype: torch.dtype) -> None:
    if (name, dtype) not in _ready:
        _COMPILERS[name](dtype)
        _ready.add((name, dtype))
