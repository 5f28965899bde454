"""Threads for kernels that do not hold Python's lock.

Kernels are plain loops over a part of the rays, each part with an accumulator of its own. The
number of parts depends on the work alone and the accumulators are added in order: any number of
threads gives the same result, bit by bit.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache

import torch

from workbench.progress import check_given_up

# Handing a part to another thread takes some 50 µs: fewer rays than this are not worth it.
_WORTH_A_THREAD = 8192

# Parts at most. Each may have an accumulator of its own, which takes time to be added up.
_PARTS = 8
# Pixels of the images of all parts together, of which there are two in any case: memory.
_PIXELS = 1 << 24


def parts(rays: int) -> int:
    """How many parts to make of so many rays, as far as a part is worth a thread."""
    return max(1, min(_PARTS, rays // _WORTH_A_THREAD))


def workers(rays: int) -> int:
    """How many threads to have for so many rays, where results do not depend on them."""
    return min(parts(rays), torch.get_num_threads())


def images(pixels: int) -> int:
    """How many parts to make at most if each has an image of so many pixels."""
    return min(_PARTS, max(2, _PIXELS // pixels))


def bounds(items: int, parts: int) -> list[int]:
    """Where the parts of ``items`` things begin, and where the last one ends; parts + 1 numbers."""
    return [items * part // parts for part in range(parts + 1)]


def split(lines: int, rays: int, shares: int = 1) -> list[int]:
    """Where the parts of so many lines, with so many rays in all, begin; and where the last ends.

    As many as `parts`, or ``shares`` times as many, but none without a line.
    """
    return bounds(lines, min(parts(rays) * shares, max(1, lines)))


def run(work: Callable[[int], None], parts: int) -> None:
    """Call ``work(part)`` for each part, several at the same time, and wait for all.

    There are no more threads at work than torch has, and each takes the next part:
    with more parts than threads, none waits long for another. The caller's thread is one of them.
    ``work`` should spend its time in a kernel compiled with ``nogil=True`` and may not call `run`
    again.

    Raises `Interrupted` if the work of the caller's thread is given up, between two parts.
    """
    left = iter(range(parts))  # its next number is taken by one thread alone: Python's lock is held

    def take(check: Callable[[], None] = lambda: None) -> None:
        for part in left:
            check()
            work(part)

    count = min(parts, torch.get_num_threads()) - 1
    others = [_pool(count).submit(take) for _ in range(count)]
    try:
        take(check_given_up)
    finally:
        for _ in left:  # none after a failure
            pass
        # Even after a failure here: the others still write to arrays of the caller.
        for other in others:
            if not other.cancel():  # it has begun
                other.result()


def run_lines(work: Callable[[int, int], None], lines: int, rays: int) -> None:
    """Call ``work(begin, end)`` for the parts of so many lines, with so many rays in all.

    As `run`, with the parts of `split`.
    """
    ends = split(lines, rays)
    run(lambda part: work(ends[part], ends[part + 1]), len(ends) - 1)


@cache
def _pool(threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads, thread_name_prefix="trace")
