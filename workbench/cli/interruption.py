"""Signals that end a command: Ctrl-C, SIGTERM, and SIGHUP when the terminal closes.

Signals that the parent process ignores, such as those of background jobs of a shell or of nohup,
stay ignored.
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
_REPEAT_SECONDS = 0.05  # after which a signal that interrupted an import is repeated
_LOADER = "<frozen importlib._bootstrap>"


class EndedBySignal(KeyboardInterrupt):
    """A signal has ended a command; the reason is one sentence."""

    def __init__(self, number: int, reason: str = "interrupted") -> None:
        super().__init__(reason)
        self.number = number


def number_of(stop: KeyboardInterrupt) -> int:
    """Return the signal of an interruption."""
    return stop.number if isinstance(stop, EndedBySignal) else signal.SIGINT


class _Handling(ABC):
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
    def _handle(self, number: int, frame: FrameType | None) -> None: ...


class Interruptible(_Handling):
    """Context in which signals raise `EndedBySignal`, but not while a module is being loaded.

    Libraries take an exception during an import for a missing module; the signal is then repeated
    after a moment. A second Ctrl-C raises at once.
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
        self._later = threading.Timer(
            _REPEAT_SECONDS, self._repeat, [threading.get_ident(), number]
        )
        self._later.daemon = True
        self._later.start()

    def _repeat(self, thread: int, number: int) -> None:
        self._is_repeated = True
        if sys.platform == "win32":
            _thread.interrupt_main(number)
        else:
            signal.pthread_kill(thread, number)  # also interrupts a blocking call


def _is_loading(frame: FrameType | None) -> bool:
    while frame is not None and frame.f_code.co_filename != _LOADER:
        frame = frame.f_back
    return frame is not None


class Interruption(_Handling):
    """Context in which a signal is stored in ``asked`` instead of raised.

    A second Ctrl-C raises, for users who do not wait for the iteration. Other signals do not, as
    they come twice when a terminal closes, and nothing raises after `settle`.
    """

    def __init__(self) -> None:
        self.asked = 0
        self._settled = False

    def settle(self) -> None:
        """Raise nothing from now on: the remaining work is short and must complete."""
        self._settled = True

    def _handle(self, number: int, frame: FrameType | None) -> None:
        if self.asked and number == signal.SIGINT and not self._settled:
            self._settled = True
            raise EndedBySignal(number)
        self.asked = self.asked or number
