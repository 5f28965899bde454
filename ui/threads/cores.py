"""How much of the machine threads beside the window take."""

import os

from PySide6.QtCore import QThread


def leave_core_for_window() -> None:
    """Let torch, and kernels with it, use all cores but one; to be called before it is loaded.

    Threads that wait for each other at every step are slower, not faster, when one of them has to
    give way to drawing.
    """
    os.environ.setdefault("OMP_NUM_THREADS", str(other_cores()))


def other_cores() -> int:
    """Cores beside the one that stays the window's; at least 1."""
    return max(1, QThread.idealThreadCount() - 1)
