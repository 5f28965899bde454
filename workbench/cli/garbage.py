"""Cyclic garbage of a command: searched for seldom, and no more once the process ends.

Imports make 300,000 objects that live as long as the process. At its usual thresholds Python
searches through them again and again while they come, and twice more at its end: together a third
of the time of a short command.
"""

import atexit
import gc
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

# New objects, searches of these, and of those again, before the next wider search.
_THRESHOLDS = 100_000, 50, 1000


@contextmanager
def seldom_collected() -> Iterator[None]:
    """Search for cyclic garbage seldom while entered, and not at the end of the process."""
    before = gc.get_threshold()
    gc.set_threshold(*_THRESHOLDS)
    _freeze_at_exit()
    try:
        yield
    finally:
        gc.set_threshold(*before)


@cache
def _freeze_at_exit() -> None:
    atexit.register(gc.freeze)
