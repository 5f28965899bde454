"""Signals that ask a command to end: Ctrl-C, SIGTERM, and SIGHUP when its terminal goes away.

What the surroundings ignore, as a shell asks of its background jobs and nohup of a hangup, is
ignored here too.
"""

import _thread
import signal
import sys
import threading
from abc import ABC, abstractmethod
from types import FrameType, TracebackType
from typing import Self

_ENDING = tuple(
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
)
_AGAIN = 0.05  # seconds after which a signal comes again that found a module being loaded
_LOADER = "<frozen importlib._bootstrap>"


class EndedBySignal(KeyboardInterrupt):
    """A signal has ended a command.

    Parameters
    ----------
    number : int
        Which.
    reason : str
        What it has left, in one sentence.
    """

    def __init__(self, number: int, reason: str = "interrupted") -> None:
        super().__init__(reason)
        self.number = number


def number_of(stop: KeyboardInterrupt) -> int:
    """The signal that an interruption is about."""
    return stop.number if isinstance(stop, EndedBySignal) else signal.SIGINT


class _Handling(ABC):
    """While entered, ``_handle`` is called for signals that ask to end."""

    def __enter__(self) -> Self:
        self._before = {number: signal.getsignal(number) for number in _ENDING}
        for number, handler in self._before.items():
            if handler is not signal.SIG_IGN:
                signal.signal(number, self._handle)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    @abstractmethod
    def _handle(self, number: int, frame: FrameType | None) -> None:
        """Take a signal in the main thread."""


class Interruptible(_Handling):
    """While entered, signals raise `EndedBySignal`, but not while a module is being loaded.

    Libraries take an exception in their midst for a part that is missing, and say so or go on
    without it; the signal then comes again after a moment. A second Ctrl-C does not wait.
    """

    def __init__(self) -> None:
        self._later: threading.Timer | None = None
        self._is_repeated = False

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._later is not None:
            self._later.cancel()
        super().__exit__(kind, error, traceback)

    def _handle(self, number: int, frame: FrameType | None) -> None:
        is_repeated, self._is_repeated = self._is_repeated, False
        is_second = self._later is not None and not is_repeated and number == signal.SIGINT
        if is_second or not _is_loading(frame):
            raise EndedBySignal(number)
        self._later = threading.Timer(_AGAIN, self._repeat, [threading.get_ident(), number])
        self._later.daemon = True
        self._later.start()

    def _repeat(self, thread: int, number: int) -> None:
        self._is_repeated = True
        if sys.platform == "win32":
            _thread.interrupt_main(number)
        else:
            signal.pthread_kill(thread, number)  # which also ends what it waits for


def _is_loading(frame: FrameType | None) -> bool:
    """Whether a module is being loaded somewhere below a frame."""
    while frame is not None and frame.f_code.co_filename != _LOADER:
        frame = frame.f_back
    return frame is not None


class Interruption(_Handling):
    """While entered, a signal is noted in ``asked`` instead of raised.

    A second Ctrl-C raises, for those who do not wait for the iteration; not so other signals,
    which come twice when a terminal closes, and nothing after `settle`.
    """

    def __init__(self) -> None:
        self.asked = 0
        self._settled = False

    def settle(self) -> None:
        """From here on nothing is raised: what is left to do is short and must not be lost."""
        self._settled = True

    def _handle(self, number: int, frame: FrameType | None) -> None:
        if self.asked and number == signal.SIGINT and not self._settled:
            self._settled = True
            raise EndedBySignal(number)
        self.asked = self.asked or number
