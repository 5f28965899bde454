"""Work in threads whose outcomes are handed out in order, and which can be left at any time."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from threading import Event
from typing import TypeVar

from workbench.process import usable_threads

T = TypeVar("T")

_OFTEN = 0.1  # seconds after which whoever waits for an outcome gets control back
_MOST_THREADS = 8
# Each has an outcome at hand, which may be large: bytes for all of them together.
_LARGEST = 1 << 28


def in_order(
    works: Sequence[Callable[[Event], T]], size: int, threads: int | None = None
) -> Iterator[T | None]:
    """Do all of some works; yields each outcome, and None now and then before one is there.

    `works`: called with an event that is set once nobody waits for the outcome; `size`: bytes of an
    outcome: fewer threads work where that is much; `threads`: how many work; as many as may be by
    default; see `usable_threads`.
    """
    threads = min(threads or usable_threads(), _MOST_THREADS, max(_LARGEST // size, 1))
    left = Event()
    with ThreadPoolExecutor(threads) as pool:
        try:
            # Not all at once: outcomes that wait take memory.
            for first in range(0, len(works), threads):
                some = [pool.submit(work, left) for work in works[first : first + threads]]
                while some:
                    if wait(some[:1], _OFTEN).done:
                        yield some.pop(0).result()
                    else:
                        yield None
        finally:
            left.set()
