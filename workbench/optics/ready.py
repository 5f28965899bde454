"""Which kernels are compiled, and compiling them before they are needed.

1. A run waits for its kernel, whoever compiles it: a seed gives the same lens whether kernels were
   compiled before or not. All kernels take half a minute, a run in torch ten times its usual time.
2. What only shows a lens does not wait (`without_waiting`): torch traces it meanwhile.
3. A kernel that cannot be compiled is tried once. Then torch traces, and `failure` and the log of
   each run give the reason.
"""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from enum import Enum

import torch

from workbench.optics.kernels import beam_image, box_image
from workbench.optics.train import compiled
from workbench.progress import given_up_when

# What compiles a kernel for a float type, by tiny calls.
_COMPILERS: dict[str, Callable[[torch.dtype], None]] = {
    "train": compiled.compile_for,
    "beams": beam_image.compile_for,
    "boxes": box_image.compile_for,
}


class _Use(Enum):
    """Which kernels the traces of a thread take."""

    ALL = "all, after compiling if need be"
    READY = "those that are ready"
    NONE = "none"


_use = ContextVar("_use", default=_Use.ALL)
_ready: set[tuple[str, torch.dtype]] = set()
_failures: dict[tuple[str, torch.dtype], Exception] = {}
_compiling = threading.Lock()
_next = threading.Lock()  # held by whoever waits for `_compiling`: so they get it in turns


def obtain(name: str, dtype: torch.dtype) -> bool:
    """Whether a kernel can be called; compiles it, or waits for it, if this thread may.

    `name`: "train", "beams" or "boxes"; `dtype`: float type of the trace.
    """
    use, kernel = _use.get(), (name, dtype)
    if use is _Use.NONE:
        return False
    if use is _Use.ALL:
        _compile(name, dtype)
    return kernel in _ready


def failure(name: str, dtype: torch.dtype) -> Exception | None:
    """Why a kernel could not be compiled, if that was tried."""
    return _failures.get((name, dtype))


def is_compiled(dtype: torch.dtype = torch.float32) -> bool:
    """Whether no trace has to wait for a kernel of this float type any more."""
    return all(kernel in _ready or kernel in _failures for kernel in _kernels(dtype))


def compile_all(
    goes_on: Callable[[], bool] = lambda: True, dtype: torch.dtype = torch.float32
) -> None:
    """Compile all kernels for a float type, one after the other.

    `goes_on`: asked before each kernel; the rest is left out once it says no; `dtype`: float type
    of the traces; designs use float32 unless a scene needs more. Raises `Exception` why the first
    of those that cannot be compiled cannot; the others are compiled before.
    """
    for kernel in _kernels(dtype):
        if not goes_on():
            return
        _compile(*kernel)
    for kernel in _kernels(dtype):
        if kernel in _failures:
            raise _failures[kernel]


@contextmanager
def without_waiting() -> Iterator[None]:
    """Let traces of this thread take the reference as long as their kernel is not ready."""
    with _using(_Use.READY):
        yield


@contextmanager
def held_back() -> Iterator[None]:
    """Have all traces of this thread done by the reference: for comparisons."""
    with _using(_Use.NONE):
        yield


def _kernels(dtype: torch.dtype) -> list[tuple[str, torch.dtype]]:
    return [(name, dtype) for name in _COMPILERS]


def _compile(name: str, dtype: torch.dtype) -> None:
    kernel = name, dtype
    if kernel in _ready or kernel in _failures:
        return
    with _next:
        _compiling.acquire()
    try:
        if kernel not in _ready and kernel not in _failures:
            # The kernel is for all later work: it is compiled even if the work of this thread is
            # given up meanwhile, which would otherwise count as a kernel that cannot be compiled.
            with given_up_when(lambda: False):
                _COMPILERS[name](dtype)
            _ready.add(kernel)
    except Exception as error:  # of any kind: compilers have many; `failure` keeps it
        _failures[kernel] = error
    finally:
        _compiling.release()


@contextmanager
def _using(use: _Use) -> Iterator[None]:
    before = _use.set(use)
    try:
        yield
    finally:
        _use.reset(before)
