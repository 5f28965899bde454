"""A small pool of threads for kernels that hold no lock of Python's.

Kernels are plain loops over a part of the rays; each part has an accumulator of its own. Compared
with numba's parallel loops this needs no threading layer, compiles sooner, and lets two threads of
Python trace at once. Parts are fixed by their number alone, so the same number of threads gives
the same result, bit by bit.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache

import torch

# Handing a part to another thread takes some 50 µs: fewer rays than this are not worth it.
_WORTH_A_THREAD = 8192


def parts(rays: int) -> int:
    """How many parts to make of so many rays: one for each of torch's threads, if it pays."""
    return max(1, min(torch.get_num_threads(), rays // _WORTH_A_THREAD))


def bounds(items: int, parts: int) -> list[int]:
    """Where the parts of ``items`` things begin, and where the last one ends; parts + 1 numbers."""
    return [items * part // parts for part in range(parts + 1)]


def run(work: Callable[[int], None], parts: int) -> None:
    """Call ``work(part)`` for each part at the same time, and wait for all.

    The caller's thread does the last part itself. ``work`` should spend its time in a kernel
    compiled with ``nogil=True`` and may not call `run` again.
    """
    others = [_pool(parts - 1).submit(work, part) for part in range(parts - 1)]
    try:
        work(parts - 1)
    finally:
        # Even after a failure here: the others still write to arrays of the caller.
        for other in others:
            other.result()


@cache
def _pool(threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads, thread_name_prefix="trace")
