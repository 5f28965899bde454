"""The same verbs without a window: ``freeform``, the same as ``python -m workbench``.

Exit status 0 done, 1 failed, 2 wrong use or refused input, 130 interrupted; the reason is one line
on standard error.
"""

import os
import sys
from collections.abc import Sequence
from typing import TextIO

from workbench.cli.arguments import parse
from workbench.errors import Refused, RunFailed


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Parameters
    ----------
    arguments : sequence of str, optional
        Command line without the program's name; that of this process by default.

    Returns
    -------
    int
        Exit status.
    """
    try:
        try:
            options = parse(arguments)
            options.command(options)
        finally:
            sys.stdout.flush()  # here, where a broken pipe or a full disk can be told
    except Refused as refused:
        return _fail(2, str(refused))
    except RunFailed as failure:
        return _fail(1, str(failure))
    except KeyboardInterrupt as stop:
        return _fail(130, str(stop) or "interrupted")
    except OSError as error:  # of standard output or error; those of files are refusals by now
        _forget(sys.stdout)
        return _fail(1, f"cannot go on: {error.strerror or error}")
    except Exception as error:  # a defect of this program: no traceback for those who only use it
        return _fail(1, f"unexpected {type(error).__name__}: {error}")
    return 0


def _fail(status: int, reason: str) -> int:
    try:
        print(f"freeform: {' '.join(reason.split())}", file=sys.stderr, flush=True)
    except OSError:  # there is nobody to tell
        _forget(sys.stderr)
    return status


def _forget(stream: TextIO) -> None:
    """Keep Python from trying, and failing, to flush a broken stream once more when it ends."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, stream.fileno())
    os.close(nowhere)
