"""The end of a process whose command is done."""

import atexit
import os
import sys
import threading
from contextlib import suppress


def end(status: int) -> None:
    """End the process at once: all that is asked to be done at its end, but no taking apart.

    Python otherwise takes 2,000 modules apart, and libraries their threads and tables: 0.1 s for
    which a shell waits. Returns, and leaves it to Python, where threads are still at work.

    Parameters
    ----------
    status : int
        Exit status.
    """
    me = threading.current_thread()
    if any(not each.daemon for each in threading.enumerate() if each is not me):
        return
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError, OSError, ValueError):  # none, broken or closed
            stream.flush()
    os._exit(status)
