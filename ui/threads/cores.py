"""How much of the machine threads beside the window take."""

from PySide6.QtCore import QThread


def leave_core_for_window() -> None:
    """Let torch use all cores but one in the thread that calls.

    Threads that wait for each other at every step are slower, not faster, when one of them has to
    give way to drawing.
    """
    import torch  # late: it takes seconds, and the window shows before that

    torch.set_num_threads(other_cores())


def other_cores() -> int:
    """Cores beside the one that stays the window's; at least 1."""
    return max(1, QThread.idealThreadCount() - 1)
