"""What numba compiles: the one decorator of all kernels, and the folder that keeps their code.

1. A kernel contains what it calls from other files. The folder is therefore named after the text of
   all files that use `jit` and after the versions of numba and llvmlite: code of another version of
   this program is never loaded. numba itself tells processors and signatures apart.
2. One process at a time compiles, and the next one loads the result. numba's index of a kernel
   would otherwise name the wrong code where two processes add signatures to it at once.
3. Compiling takes seconds to a minute, once after installing; a process that begins to logs it.
4. Where no folder can be written to, kernels are compiled at each start, and `unkept` says why.
"""

import copyreg
import hashlib
import logging
import os
import shutil
import stat
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import filelock
import llvmlite  # type: ignore[import-untyped]
import numba
import platformdirs
from numba.core.event import Event, Listener, register

_HERE = Path(__file__).parent
_SETTINGS: Any = numba.config  # whose names mypy does not see
_MARK = b"from workbench.compiled import jit"
_LEAST_SPACE = 100 << 20  # bytes; all kernels take half of that

_LOG = logging.getLogger(__name__)
_failures: list[str] = []


def jit(
    *, allocates: bool = True, name: str = "", **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """Compile a function at its first call with each signature, or load its code from disk.

    Functions with ``fastmath`` that create no arrays become part of what calls them. As a function
    of its own, each caller would have a copy, optimised in its own way, and the first copy that a
    process compiles or loads would stand for all: results would depend on it by rounding.

    Parameters
    ----------
    allocates : bool
        Whether the function, or what it calls, creates arrays. One that only takes arrays of its
        caller, or slices of them, needs no count of who holds them; otherwise numba may count at
        each call of a function that is inlined, and all threads wait for the same counters.
    name : str
        Tells functions apart that another function creates from the same lines.
    **options
        Those of `numba.njit`; compiled code never holds Python's lock.
    """
    folder = _folder()
    settings: dict[str, Any] = {"nogil": True, "cache": folder is not None, "_nrt": allocates}

    if options.get("fastmath") and not allocates:
        options.setdefault("forceinline", True)

    def decorate(function: Callable[..., Any]) -> Any:
        function.__qualname__ = name or function.__qualname__
        others = _SETTINGS.CACHE_DIR
        _SETTINGS.CACHE_DIR = str(folder or "")
        try:
            kernel = numba.njit(**settings, **options)(function)
        finally:
            _SETTINGS.CACHE_DIR = others
        copyreg.pickle(type(kernel), _by_name)
        return kernel

    return decorate


def compiled_files() -> list[Path]:
    """Return the files of this program whose functions are compiled."""
    return [file for file in sorted(_HERE.rglob("*.py")) if _MARK in file.read_bytes()]


def unkept() -> str:
    """Return why compiled code cannot be kept; nothing if it can."""
    return "" if _folder() else "; ".join(_failures) or "no folder can be written to"


def collect(cache: Path) -> None:
    """Copy the code that another process kept with ``NUMBA_CACHE_DIR=cache``.

    Of a function that has code in both folders, the one here stays: only functions that no other
    compiled function contains are loaded, so each of these is to be compiled by one process.
    """
    folder = _folder()
    if folder is None:
        return
    for file in sorted((cache / folder.name).glob("*/*.nb[ic]")):
        there = folder / file.relative_to(cache / folder.name)
        if not there.exists():
            there.parent.mkdir(exist_ok=True)
            shutil.copy(file, there)


def folders() -> Iterator[Path]:
    """Yield the folders where code may be kept, the best one first."""
    named = f"kernels-{_fingerprint()}"
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    if chosen:
        yield Path(chosen) / named
    else:
        yield _HERE / "__pycache__" / named
        yield Path(platformdirs.user_cache_dir("freeform-workbench", appauthor=False)) / named
    private = _private_folder()
    if private is not None:
        yield private / named


@cache
def _folder() -> Path | None:
    """Return the first folder that this process can write to.

    Code in a folder that it can only read, of an installation for all users, is copied once.
    """
    filled = None
    for folder in folders():
        try:
            if filled and not folder.exists():
                _copy(filled, folder)
            folder.mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=folder).close()
        except OSError as error:
            filled = filled or (folder if folder.is_dir() else None)
            _failures.append(f"{folder.parent}: {error.strerror or error}")
            continue
        if shutil.disk_usage(folder).free < _LEAST_SPACE:
            _failures.append(f"{folder.parent}: less than {_LEAST_SPACE >> 20} MB free")
            continue
        for file in folder.glob("*/*.nb[ic]"):
            if not file.stat().st_size:  # after a power failure; numba would raise EOFError
                file.unlink(missing_ok=True)
        return folder
    return None


def _copy(filled: Path, folder: Path) -> None:
    """Copy a folder, unless the disk is full or another process does it at the same time."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as beside, suppress(OSError):
        shutil.copytree(filled, Path(beside) / folder.name).rename(folder)


class _OneProcess(Listener):
    """Lets one process at a time look for code, compile and keep it."""

    def __init__(self, folder: Path) -> None:
        self._lock = filelock.FileLock(folder / "lock")

    def on_start(self, event: Event) -> None:
        with suppress(OSError, NotImplementedError):  # of a file system without locks
            self._lock.acquire()

    def on_end(self, event: Event) -> None:
        self._lock.release()


class _Announcement(Listener):
    """Logs the first time that a kernel of this program is compiled."""

    made = False

    def on_start(self, event: Event) -> None:
        if not self.made and event.data["dispatcher"].__module__.startswith("workbench."):
            self.made = True
            _LOG.info("compiling, once after installing; this takes up to a minute")

    def on_end(self, event: Event) -> None:
        pass


def _by_name(kernel: Any) -> Any:
    """Pickle a kernel of a module by its name.

    numba finds the code of a function that another one creates by the pickled values of its
    closure. A kernel among them would otherwise be pickled with a number that each process draws.
    """
    name = kernel.py_func.__qualname__
    if getattr(sys.modules.get(kernel.__module__), name, None) is kernel:
        return name
    return kernel.__reduce__()


@cache
def _fingerprint() -> str:
    texts = [hashlib.sha256(file.read_bytes()).hexdigest() for file in compiled_files()]
    versions = [numba.__version__, llvmlite.__version__]
    return hashlib.sha256(" ".join(versions + texts).encode()).hexdigest()[:16]


def _private_folder() -> Path | None:
    """A temporary folder, unless another user could have put something into it."""
    user = os.getuid() if hasattr(os, "getuid") else 0  # Windows has one for each user anyway
    try:
        folder = Path(tempfile.gettempdir()) / f"freeform-workbench-{user}"
    except OSError:  # there is none
        return None
    if not os.path.lexists(folder):
        return folder
    found = folder.lstat()
    safe = stat.S_ISDIR(found.st_mode) and found.st_uid == user and not found.st_mode & stat.S_IWOTH
    return folder if safe else None


if (_kept := _folder()) is not None:
    register("numba:compiler_lock", _OneProcess(_kept))  # type: ignore[no-untyped-call]
register("numba:compile", _Announcement())  # type: ignore[no-untyped-call]
