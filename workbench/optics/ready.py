"""Which kernels are compiled, and compiling them before they are needed.

1. A run waits for its kernel, whoever compiles it: a seed gives the same lens whether kernels were
   compiled before or not. All kernels take half a minute, a run in torch ten times its usual time.
2. What only shows a lens does not wait (`without_waiting`): torch traces it meanwhile.
3. A kernel that cannot be compiled is tried once. Then torch traces, and `failure` and the log of
   each run give the reason.
"""

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager
from contextvars import ContextVar
from enum import Enum

import torch

from workbench.optics.kernels import beam_image, box_image
from workbench.optics.train import compiled
from workbench.progress import check_given_up

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


_Kernel = tuple[str, torch.dtype]

_use = ContextVar("_use", default=_Use.ALL)
# In threads of their own, one after the other. A kernel is for all later work: it is compiled even
# if the work that asked for it is given up meanwhile.
_compilations: dict[_Kernel, Future[None]] = {}
_asking = threading.Lock()
_LOOK = 0.1  # seconds between two looks whether waiting work is given up


def obtain(name: str, dtype: torch.dtype) -> bool:
    """Whether a kernel can be called; compiles it, or waits for it, if this thread may.

    `name`: "train", "beams" or "boxes"; `dtype`: float type of the trace. Raises
    `workbench.progress.Interrupted` if the work of this thread is given up while it waits.
    """
    use, kernel = _use.get(), (name, dtype)
    if use is _Use.NONE:
        return False
    if use is _Use.ALL:
        _wait_for(kernel)
    return _is_done(kernel) and failure(name, dtype) is None


def failure(name: str, dtype: torch.dtype) -> BaseException | None:
    """Why a kernel could not be compiled, if that was tried."""
    kernel = name, dtype
    return _compilations[kernel].exception() if _is_done(kernel) else None


def is_compiled(dtype: torch.dtype = torch.float32) -> bool:
    """Whether no trace has to wait for a kernel of this float type any more."""
    return all(map(_is_done, _kernels(dtype)))


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
        _wait_for(kernel)
    for name, _ in _kernels(dtype):
        error = failure(name, dtype)
        if error is not None:
            raise error


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


def _kernels(dtype: torch.dtype) -> list[_Kernel]:
    return [(name, dtype) for name in _COMPILERS]


def _is_done(kernel: _Kernel) -> bool:
    return kernel in _compilations and _compilations[kernel].done()


def _wait_for(kernel: _Kernel) -> None:
    with _asking:
        if kernel not in _compilations:
            done, earlier = Future[None](), [*_compilations.values()]
            _compilations[kernel] = done
            threading.Thread(target=_compile, args=(kernel, done, earlier), name="compiler").start()
    while not _compilations[kernel].done():
        wait([_compilations[kernel]], _LOOK)
        check_given_up()


def _compile(kernel: _Kernel, done: Future[None], earlier: list[Future[None]]) -> None:
    name, dtype = kernel
    wait(earlier)
    try:
        _COMPILERS[name](dtype)
    except Exception as error:  # of any kind: compilers have many; `failure` keeps it
        done.set_exception(error)
    else:
        done.set_result(None)


@contextmanager
def _using(use: _Use) -> Iterator[None]:
    before = _use.set(use)
    try:
        yield
    finally:
        _use.reset(before)
