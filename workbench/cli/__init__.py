"""The same verbs without a window: ``freeform``, the same as ``python -m workbench``.

Exit status 0 done, 1 failed, 2 wrong use or refused input, 128 and the signal's number where one
ended it (130 after Ctrl-C, 143 after SIGTERM, 129 after a hangup); the reason is one line on
standard error.
"""

import gc
import logging
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import NoReturn

from workbench.cli.garbage import collect_seldom
from workbench.cli.interruption import Interruptible, number_of
from workbench.cli.streams import Streams
from workbench.defects import unexpected
from workbench.errors import Refused, RunFailed, visible
from workbench.library_threads import calm_library_threads
from workbench.utf8_mode import restart_in_utf8_mode


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
    calm_library_threads()
    with Streams() as streams, _logging():
        try:
            with Interruptible():
                _run(arguments)
        except Refused as refused:
            return _fail(2, str(refused))
        except RunFailed as failure:
            return _fail(1, str(failure))
        except KeyboardInterrupt as stop:
            return _fail(128 + number_of(stop), str(stop) or "interrupted")
        except SystemExit:  # help and version, which are done
            if streams.failure is None:
                raise
        except Exception as error:  # a defect: its traceback goes to a file
            return _fail(1, unexpected(error))
        broken = streams.failure
        if broken is not None:
            return _fail(1, f"standard output cannot be written: {broken.strerror or broken}")
    return 0


def command() -> NoReturn:
    """Run the command of this process, and end the process with its exit status."""
    restart_in_utf8_mode()
    collect_seldom()
    status = main()
    gc.freeze()  # else Python searches 300,000 objects for garbage at its end: a second
    sys.exit(status)


class _Printer(logging.Handler):
    """Prints on standard error."""

    def emit(self, record: logging.LogRecord) -> None:
        print(f"freeform: {self.format(record)}", file=sys.stderr, flush=True)


@contextmanager
def _logging() -> Iterator[None]:
    """Print what the engine logs."""
    logger, printer = logging.getLogger("workbench"), _Printer()
    level = logger.level
    logger.addHandler(printer)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.removeHandler(printer)
        logger.setLevel(level)


def _run(arguments: Sequence[str] | None) -> None:
    from workbench.cli.arguments import parse  # here, where Ctrl-C is reported already

    options = parse(arguments)
    options.command(options)


def _fail(status: int, reason: str) -> int:
    print(f"freeform: {visible(' '.join(reason.split()))}", file=sys.stderr, flush=True)
    return status
