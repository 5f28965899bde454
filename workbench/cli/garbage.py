"""Cyclic garbage of a command: searched for seldom.

Imports make 300,000 objects that live as long as the process. At its usual thresholds Python
searches through them again and again while they come: a quarter of the time of a short command.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

# New objects, searches of these, and of those again, before the next wider search.
_THRESHOLDS = 400_000, 50, 1000


@contextmanager
def seldom_collected() -> Iterator[None]:
    """Search for cyclic garbage seldom while entered."""
    before = gc.get_threshold()
    gc.set_threshold(*_THRESHOLDS)
    try:
        yield
    finally:
        gc.set_threshold(*before)
