"""Set-up of threads: cores for torch, and garbage collection in the window's thread."""

import os

from PySide6.QtCore import QThread


def leave_core_for_window() -> None:
    """Let torch and kernels use all cores but one; call before they are loaded.

    Threads that synchronise at every step become slower if one of them competes with drawing.
    """
    os.environ.setdefault("OMP_NUM_THREADS", str(other_cores()))


def other_cores() -> int:
    """Cores beside that of the window; at least 1."""
    return max(1, QThread.idealThreadCount() - 1)
