"""What must not happen while a monkey plays: errors, warnings of Qt, a window that hangs."""

import faulthandler
import logging
import os
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QMessageLogContext, QObject, QTimer, QtMsgType, qInstallMessageHandler

from ui.background import LOG

HANG = 10.0  # seconds without an answer of the event loop
_SLOW = 1.0  # worth a line
_MOST_MB = 8000.0  # what no task that is typed in here needs; the program ends before the machine
_BEAT_MS = 50

# Printed without a window manager, of the format that VTK's widget asks for each time, and of the
# 3D view, whose own window outlasts that of a dock that is put back.
# The last one: without a program that opens folders.
_HARMLESS = (
    "This plugin does not support",
    "Setting a new default format",
    "Reparenting",
    "Unable to detect a launcher",
)


class _Reporting(logging.Handler):
    """Reports what the log gets: errors of work in the background that nobody expected."""

    def __init__(self, report: Callable[[str], None]) -> None:
        super().__init__()
        self._report = report

    def emit(self, record: logging.LogRecord) -> None:
        self._report(record.getMessage())


class Monitor(QObject):
    """Takes note of every problem, with the step in which it came.

    Parameters
    ----------
    log : callable
        Takes a line.
    stacks : Path
        Where all stacks are written when the event loop hangs, or memory runs out.
    state : callable
        What to write beside them of the program's state.
    """

    def __init__(self, log: Callable[[str], None], stacks: Path, state: Callable[[], str]) -> None:
        super().__init__()
        self.problems: list[str] = []
        self.longest = 0.0  # seconds that the event loop took for one thing
        self._log, self._state = log, state
        self._stacks = stacks.open("w")
        self._beat = time.monotonic()
        self._hangs = self._ending = False
        self._hooks = sys.excepthook, threading.excepthook
        sys.excepthook = self._except
        threading.excepthook = self._except_in_thread
        self._qt_handler = qInstallMessageHandler(self._hear)
        self._of_work = _Reporting(self.report)
        LOG.addHandler(self._of_work)
        self._timer = QTimer(self, interval=_BEAT_MS)
        self._timer.timeout.connect(self._answer)
        self._timer.start()
        self._dog = threading.Thread(target=self._guard, name="watchdog", daemon=True)
        self._dog.start()

    def report(self, problem: str) -> None:
        """Take note of a problem."""
        self.problems.append(problem)
        self._log(f"PROBLEM {problem}")

    def close(self) -> None:
        """Stop monitoring."""
        self._ending = True
        self._timer.stop()
        self._dog.join()
        sys.excepthook, threading.excepthook = self._hooks
        qInstallMessageHandler(self._qt_handler)
        LOG.removeHandler(self._of_work)
        self._stacks.close()

    def _except(self, kind, error, trace) -> None:
        self.report(f"{kind.__name__}: {error}")
        self._hooks[0](kind, error, trace)

    def _except_in_thread(self, arguments) -> None:
        self.report(f"in thread: {arguments.exc_type.__name__}: {arguments.exc_value}")
        self._hooks[1](arguments)

    def _hear(self, kind: QtMsgType, context: QMessageLogContext, text: str) -> None:
        serious = kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg)
        if serious and not any(part in text for part in _HARMLESS):
            self.report(f"Qt: {text}")

    def _answer(self) -> None:
        now = time.monotonic()
        gap, self._beat = now - self._beat, now
        self.longest = max(self.longest, gap)
        if gap > _SLOW:
            self._log(f"slow: the event loop took {gap:.1f} s")
        self._hangs = False

    def _guard(self) -> None:
        while not self._ending:
            time.sleep(0.2)
            if not self._hangs and time.monotonic() - self._beat > HANG:
                self._hangs = True
                self.dump(f"the event loop has not answered for {HANG:.0f} s")
            if (memory := resident_mb()) > _MOST_MB:
                self.dump(f"{memory:.0f} MB of memory")
                os._exit(1)

    def dump(self, problem: str) -> None:
        """Take note of a problem, and of what all threads do."""
        self.report(problem)
        faulthandler.dump_traceback(self._stacks, all_threads=True)
        self._log(self._state())


def resident_mb() -> float:
    """Memory of this process that lies in RAM, in MB."""
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
