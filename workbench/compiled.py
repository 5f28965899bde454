"""What numba compiles: the one decorator of all kernels, and the folders that keep their code.

1. A kernel contains what it calls from other files. So code is kept in a folder that is named after
   the text of all files that use `jit`: no other program's code, not even that of another version
   of this one, is ever taken from it.
2. One file for each kernel and signature, sealed by a checksum and put in place in one step. What
   is damaged is compiled again and replaced; two processes cannot mix their files up.
3. Compiling takes seconds to a minute, once after installing: a process that begins to logs it.
4. Where the first folder cannot be written to, the next one is taken. Where none can, or the disk
   is full, kernels are compiled at each start: no call fails because of that, and `unkept` says it.
"""

import hashlib
import io
import logging
import os
import pickle
import stat
import sys
import tempfile
import uuid
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite  # type: ignore[import-untyped]
import numba
import platformdirs
from llvmlite.binding import Linkage  # type: ignore[import-untyped]
from numba.core.caching import _Cache
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult
from numba.core.environment import Environment, lookup_environment
from numba.core.runtime.nrt import rtsys
from numba.core.serialize import dumps

_HERE = Path(__file__).parent
_MARK = b"from workbench.compiled import jit"
_SEAL = hashlib.sha256().digest_size

_LOG = logging.getLogger(__name__)
_failures: list[str] = []


def jit(
    *, allocates: bool = True, name: str = "", **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """Compile a function at its first call with each signature, or take its code from disk.

    Parameters
    ----------
    allocates : bool
        Whether it, or what it calls, makes arrays. One that only takes arrays of its caller, or
        slices of them, needs no count of who holds them; otherwise numba may count at each call of
        a function that is inlined, and all threads wait for the same counters.
    name : str
        By which code is kept, for functions that are made by another one and so share theirs.
    **options
        Those of `numba.njit`; compiled code never holds Python's lock.
    """
    made: dict[str, Any] = {"nogil": True, "pipeline_class": _Compiler, "_nrt": allocates}

    def decorate(function: Callable[..., Any]) -> Any:
        function.__qualname__ = name or function.__qualname__
        kernel = numba.njit(**made, **options)(function)
        kernel._cache = _Kept(function)
        return kernel

    return decorate


def rooms() -> list[Path]:
    """The files of this program whose functions are compiled."""
    return [file for file in sorted(_HERE.rglob("*.py")) if _MARK in file.read_bytes()]


def unkept() -> str:
    """Why code that this process has compiled could not be kept; nothing if it was."""
    return _failures[-1] if _failures else ""


def folders() -> Iterator[Path]:
    """Where code may be kept, the best place first."""
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


class _Compiler(Compiler):
    """Compiles a function together with all that it calls."""

    def define_pipelines(self) -> Any:
        codegen = self.state.targetctx.codegen()
        library: Any = _Library(codegen, self.state.func_id.func_qualname)  # type: ignore[no-untyped-call]
        library.enable_object_caching()  # so that it can be kept
        self.state.library = library
        return super().define_pipelines()  # type: ignore[no-untyped-call]


class _Library(JITCodeLibrary):
    """The code of a function, with copies of its own of all functions that it calls.

    Otherwise copies with the same name, which the compiler has made faster in different ways, would
    stand for each other: whichever was loaded first. Results would then depend, by rounding, on
    what was compiled or loaded before.
    """

    def _optimize_final_module(self) -> None:
        for function in self._final_module.functions:
            called = function.linkage == Linkage.linkonce_odr
            if called and not function.name.startswith("NRT_"):  # which a later pass looks for
                function.linkage = Linkage.internal
        super()._optimize_final_module()  # type: ignore[no-untyped-call]


class _Kept(_Cache):
    """The compiled code of one function: what numba asks before it compiles, and tells after."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._name = f"{function.__module__}.{function.__qualname__}"

    @property
    def cache_path(self) -> str:
        return str(next(folders()))

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        # What code needs to run. A compiler's tables, which numba's own cache fills here too, are
        # filled when something is compiled: with `_Parts` a quarter of a second of each start.
        rtsys.initialize(target_context)
        name = self._file(sig, target_context.codegen())
        for folder in folders():
            data = _unsealed(folder / name)
            if data is not None:
                parts = _Parts(io.BytesIO(data)).load()
                return CompileResult._rebuild(target_context, *parts)  # type: ignore[no-untyped-call]
        _tell()
        return None

    def save_overload(self, sig: Any, data: Any) -> None:
        name = self._file(sig, data.codegen)
        code = dumps(data._reduce())  # type: ignore[no-untyped-call]
        failures = []
        for folder in folders():
            try:
                _put(folder / name, hashlib.sha256(code).digest() + code)
            except OSError as error:
                failures.append(f"{folder.parent}: {error.strerror or error}")
            else:
                return
        _failures.append("; ".join(failures) or "no folder can be written to")

    def _file(self, sig: Any, codegen: Any) -> str:
        """A name that tells signature, processor and versions apart."""
        made_by = sys.implementation.cache_tag, numba.__version__, llvmlite.__version__
        key = repr((str(sig), codegen.magic_tuple(), made_by))
        return f"{self._name}-{hashlib.sha256(key.encode()).hexdigest()[:24]}"

    def enable(self) -> None:
        """Nothing to do: it always is."""

    def disable(self) -> None:
        """Nothing to do: nobody asks for it."""

    def flush(self) -> None:
        """Nothing to do: what is compiled again replaces what was kept."""


class _Parts(pickle.Unpickler):
    """Loads the parts of compiled code without the modules of numba from which some were made."""

    def find_class(self, module: str, name: str) -> Any:
        return _environment if name == "_rebuild_env" else super().find_class(module, name)


def _environment(module: str, constants: list[Any], name: str) -> Environment:
    """What code shares with Python; only code that works on Python's objects asks for a module."""
    known: Environment | None = lookup_environment(name)  # type: ignore[no-untyped-call]
    if known is not None:
        return known
    made = Environment({"__name__": module})
    made.consts[:] = constants
    made.env_name = name
    Environment._memo[name] = made
    return made


@cache
def _tell() -> None:
    """Log that something is compiled, the first time."""
    _LOG.info("compiling, once after installing; this takes up to a minute")


@cache
def _fingerprint() -> str:
    texts = b"".join(hashlib.sha256(file.read_bytes()).digest() for file in rooms())
    return hashlib.sha256(texts).hexdigest()[:16]


def _unsealed(file: Path) -> bytes | None:
    """What `_put` wrote; nothing if it is not there or not whole."""
    try:
        sealed = file.read_bytes()
    except OSError:
        return None
    seal, data = sealed[:_SEAL], sealed[_SEAL:]
    return data if hashlib.sha256(data).digest() == seal else None


def _put(file: Path, data: bytes) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    written = file.with_name(f"{file.name}.{uuid.uuid4().hex}")
    try:
        with open(written, "xb") as stream:  # for all who may read files of this user
            stream.write(data)
        os.replace(written, file)
    except BaseException:
        written.unlink(missing_ok=True)
        raise


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
