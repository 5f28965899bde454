"""Command line: ``freeform``, the same as ``python -m workbench``.

Exit status 0 done, 1 failed, 2 wrong use or refused input, 128 and the signal's number if a signal
ended it (130 after Ctrl-C, 143 after SIGTERM, 129 after a hangup); the reason is one line on
standard error.
"""

import gc
import logging
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import NoReturn

from workbench.cli.interruption import Interruptible, number_of
from workbench.cli.streams import Streams
from workbench.defects import unexpected
from workbench.errors import Refused, RunFailed, visible
from workbench.process import calm_library_threads, restart_in_utf8_mode

# Imports create 400,000 objects that live as long as the process. At the default thresholds Python
# searches them repeatedly during the imports: a quarter of the time of a short command.
_GARBAGE_THRESHOLDS = 1_000_000, 50, 1000


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command, by default that of this process, and return its exit status."""
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
        except SystemExit:  # help and version
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
    gc.set_threshold(*_GARBAGE_THRESHOLDS)
    status = main()
    gc.freeze()  # else Python searches 300,000 objects for garbage at exit: one second
    sys.exit(status)


class _Printer(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        print(f"freeform: {self.format(record)}", file=sys.stderr, flush=True)


@contextmanager
def _logging() -> Iterator[None]:
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
    from workbench.cli.arguments import parse  # late, so that Ctrl-C during the import is reported

    options = parse(arguments)
    options.command(options)


def _fail(status: int, reason: str) -> int:
    print(f"freeform: {visible(' '.join(reason.split()))}", file=sys.stderr, flush=True)
    return status
