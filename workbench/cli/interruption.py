"""Ctrl-C as a request instead of a blow."""

import signal
from types import FrameType, TracebackType
from typing import Self


class Interruption:
    """While entered, the first Ctrl-C is noted in ``asked``; a second one interrupts as usual.

    Where the surroundings ignore Ctrl-C, as a shell asks of its background jobs, so does this.
    """

    def __init__(self) -> None:
        self.asked = False

    def __enter__(self) -> Self:
        self._before = signal.getsignal(signal.SIGINT)
        if self._before is not signal.SIG_IGN:
            signal.signal(signal.SIGINT, self._note)
        return self

    def _note(self, number: int, frame: FrameType | None) -> None:
        self.asked = True
        signal.signal(signal.SIGINT, signal.default_int_handler)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        signal.signal(signal.SIGINT, self._before)
