"""How much memory the system has, and giving back what is no longer needed."""

import ctypes
import os
import sys
from pathlib import Path

# glibc's numbers of what can be set: how many large arrays may be mapped by themselves, which are
# given back when they are freed, and how much of all else that is freed it keeps.
_M_MMAP_MAX, _M_TRIM_THRESHOLD = -4, -1
_ALL = (1 << 31) - 1
# Where the system does not say how much memory is there: what any desktop has.
_USUAL_MEMORY = 4 << 30


def available_memory(device: str = "cpu") -> int:
    """Bytes that a device could still give; a guess where its system does not say."""
    if device == "cuda":
        import torch

        return torch.cuda.mem_get_info()[0]
    # The pages that sysconf calls free leave out the file cache, which gives way when asked.
    account = Path("/proc/meminfo")
    if account.exists():
        sizes = dict(line.split(":", 1) for line in account.read_text("ascii").splitlines())
        return int(sizes["MemAvailable"].split()[0]) * 1024
    if hasattr(os, "sysconf"):
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return _USUAL_MEMORY


def as_bytes(count: float) -> str:
    """A number of bytes for people: three digits and a decimal prefix."""
    for unit in ("B", "kB", "MB", "GB"):
        if count < 999.5:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"


def keep_freed_memory() -> None:
    """Have the process keep memory that it frees, and use it again, where the system allows that.

    The arrays of an evaluation of light are made anew each time, and for each the system would have
    to find pages and clear them. `release_freed_memory` gives back what is kept.
    """
    if sys.platform == "linux" and hasattr(libc := ctypes.CDLL(None), "mallopt"):
        libc.mallopt(_M_MMAP_MAX, 0)
        libc.mallopt(_M_TRIM_THRESHOLD, _ALL)


def release_freed_memory() -> None:
    """Give memory that the process has freed back to the system, where that is known to be kept.

    glibc cuts arrays of up to 32 MB out of one heap, and torch asks for aligned ones. Pieces that
    are freed between others are seldom used again: the first lens of two faces of 416 x 416 control
    points left 610 MB, of which 110 MB were in use; of 832 x 832, 2.4 GB. To give them back takes
    some milliseconds.
    """
    if sys.platform == "linux" and hasattr(libc := ctypes.CDLL(None), "malloc_trim"):
        libc.malloc_trim(0)
