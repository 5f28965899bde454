"""Settings of this process: threads, memory, encoding."""

import ctypes
import os
import sys
from pathlib import Path


def usable_threads() -> int:
    """Return the most threads to use: ``OMP_NUM_THREADS``, or the cores of this process."""
    given = os.environ.get("OMP_NUM_THREADS", "").partition(",")[0].strip()
    return int(given) if given.isdecimal() and int(given) else cores()


def cores() -> int:
    """Return the number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):  # on Linux only
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def calm_library_threads() -> None:
    """Make waiting threads of numerical libraries sleep, and OpenBLAS use one thread.

    Spinning threads take cores from the tracer: 1.3 of 9.3 s of CPU time for a top hat of 256².
    """
    if threads := os.environ.get("NUMBA_NUM_THREADS"):  # a limit for the whole program
        os.environ.setdefault("OMP_NUM_THREADS", threads)
    os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


_UTF_8 = "utf-8"


def restart_in_utf8_mode() -> None:
    """Restart this program in Python's UTF-8 mode if the locale's file names are not UTF-8.

    The encoding of the terminal is kept.
    """
    if os.name != "posix" or sys.getfilesystemencoding() == _UTF_8:
        return
    terminal = getattr(sys.stdout or sys.stderr, "encoding", None) or "ascii"
    environment = {
        "PYTHONIOENCODING": f"{terminal}:backslashreplace",
        **os.environ,
        "PYTHONUTF8": "1",
    }
    os.execve(sys.executable, [sys.executable, *sys.orig_argv[1:]], environment)


_M_MMAP_MAX, _M_TRIM_THRESHOLD = -4, -1  # of glibc's malloc.h
_ALL = (1 << 31) - 1
_USUAL_MEMORY = 4 << 30  # where the system does not report its memory


def available_memory(device: str = "cpu") -> int:
    """Return the free memory of a device in bytes; 4 GiB where the system does not report it."""
    if device == "cuda":
        import torch

        return torch.cuda.mem_get_info()[0]
    # The free pages of sysconf do not include the file cache, which the system frees on demand.
    account = Path("/proc/meminfo")
    if account.exists():
        sizes = dict(line.split(":", 1) for line in account.read_text("ascii").splitlines())
        return int(sizes["MemAvailable"].split()[0]) * 1024
    if hasattr(os, "sysconf"):
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return _USUAL_MEMORY


def as_bytes(count: float) -> str:
    """Return a number of bytes as text: three digits and a decimal prefix."""
    for unit in ("B", "kB", "MB", "GB"):
        if count < 999.5:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"


def keep_freed_memory() -> None:
    """Make glibc keep freed memory for the next arrays, until `release_freed_memory`."""
    if sys.platform == "linux" and hasattr(libc := ctypes.CDLL(None), "mallopt"):
        libc.mallopt(_M_MMAP_MAX, 0)
        libc.mallopt(_M_TRIM_THRESHOLD, _ALL)


def release_freed_memory() -> None:
    """Return memory that glibc keeps to the system; this takes milliseconds.

    The first design of two faces with 416² control points left 500 MB unused.
    """
    if sys.platform == "linux" and hasattr(libc := ctypes.CDLL(None), "malloc_trim"):
        libc.malloc_trim(0)
