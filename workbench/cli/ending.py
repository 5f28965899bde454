"""The end of a process whose command is done."""

import atexit
import os
import sys
import threading
from contextlib import suppress
from typing import NoReturn


def end(status: int) -> NoReturn:
    """End the process: all that is asked to be done at its end, but no taking apart.

    Python otherwise takes 2,000 modules apart, and libraries their threads and tables: half a
    second for which a shell waits after a design. Threads at work are waited for, as by Python.

    Parameters
    ----------
    status : int
        Exit status.
    """
    threading._shutdown()  # type: ignore[attr-defined]  # threads of pools, which rest, end too
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError, OSError, ValueError):  # none, broken or closed
            stream.flush()
    os._exit(status)
