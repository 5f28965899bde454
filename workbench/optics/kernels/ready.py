"""Which kernels are compiled, and compiling them before they are needed.

Numba compiles a kernel at its first call, some seconds long, and keeps it on disk. A window lets a
thread of its own do that (`compile_all`, after `announce`); a plan asks `is_ready` before each
trace and takes the reference as long as that thread is not done with the kernel. Where there is
none, a plan compiles what it needs at once: a program without a window may as well wait.
"""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

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
_announced = threading.Event()
_held_back = threading.Event()


def is_ready(name: str, dtype: torch.dtype) -> bool:
    """Whether a kernel can be called now; compiles it unless another thread does or will."""
    if _held_back.is_set():
        return False
    if (name, dtype) in _ready:
        return True
    if _announced.is_set() and dtype == torch.float32:
        return False
    if not _compiling.acquire(blocking=False):
        return False
    try:
        _compile(name, dtype)
    finally:
        _compiling.release()
    return True


def announce() -> None:
    """Say that `compile_all` will be called by this or another thread."""
    _announced.set()


def compile_all(goes_on: Callable[[], bool] = lambda: True) -> None:
    """Compile all kernels for float32, which designs use, one after the other.

    Parameters
    ----------
    goes_on : callable
        Asked before each kernel; the rest is left out once it says no.
    """
    try:
        for name in _COMPILERS:
            if not goes_on():
                return
            with _compiling:
                _compile(name, torch.float32)
    finally:
        _announced.clear()


@contextmanager
def held_back() -> Iterator[None]:
    """Have all traces done by the reference, as if no kernel were ever ready: for comparisons."""
    _held_back.set()
    try:
        yield
    finally:
        _held_back.clear()


def _compile(name: str, dtype: torch.dtype) -> None:
    if (name, dtype) not in _ready:
        _COMPILERS[name](dtype)
        _ready.add((name, dtype))
