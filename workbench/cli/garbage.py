"""Cyclic garbage of a command: searched for seldom.

Imports make 300,000 objects that live as long as the process. At its usual thresholds Python
searches through them again and again while they come: a quarter of the time of a short command.
"""

import gc

# New objects, searches of these, and of those again, before the next wider search.
_THRESHOLDS = 400_000, 50, 1000


def collect_seldom() -> None:
    """Search for cyclic garbage seldom from now on, until the process ends."""
    gc.set_threshold(*_THRESHOLDS)
