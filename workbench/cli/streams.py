"""Standard output and error, whatever stands at their other end.

1. What is closed becomes the null device, before a file that is opened gets its number, into which
   a library could then print.
2. What an old terminal's encoding lacks is written in plain characters; see `plain_text`.
3. What breaks, or fills its disk, does not end the work: the first error is kept for the exit
   status, and the rest goes to the null device, also what Python still flushes when it ends. A
   reader that leaves, as ``head`` does, is no error.
"""

import io
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import Self, TextIO, cast

from workbench.cli.plain_text import in_encoding


class Streams:
    """While entered, printing to standard output and error does not fail."""

    def __enter__(self) -> Self:
        self._before = sys.stdout, sys.stderr
        for number, stream in enumerate((sys.stdin, sys.stdout, sys.stderr)):
            if stream is None:
                _occupy(number)
        self._output, self._error = _Outlet(sys.stdout, 1), _Outlet(sys.stderr, 2)
        sys.stdout, sys.stderr = cast(TextIO, self._output), cast(TextIO, self._error)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        sys.stdout, sys.stderr = self._before

    @property
    def failure(self) -> OSError | None:
        """What has kept standard output from being written, once it is flushed."""
        self._output.flush()
        failure = self._output.failure
        return None if isinstance(failure, BrokenPipeError) else failure


class _Outlet(io.TextIOBase):
    """A stream that keeps its first error instead of raising it."""

    def __init__(self, stream: TextIO | None, number: int) -> None:
        self._stream = os.fdopen(number, "w", closefd=False) if stream is None else stream
        self.failure: OSError | None = None

    @contextmanager
    def _keeping(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            self.failure = self.failure or error
            with suppress(io.UnsupportedOperation):  # a stream in memory
                _to_nowhere(self._stream.fileno())

    def write(self, text: str) -> int:
        with self._keeping():
            # A stream in memory has no encoding.
            encoding = getattr(self._stream, "encoding", None)
            self._stream.write(in_encoding(text, encoding) if encoding else text)
        return len(text)

    def flush(self) -> None:
        with self._keeping():
            self._stream.flush()

    def isatty(self) -> bool:
        return self._stream.isatty()

    def fileno(self) -> int:
        return self._stream.fileno()

    @property
    def encoding(self) -> str:  # type: ignore[override]  # tqdm asks what it may draw
        return self._stream.encoding


def _occupy(number: int) -> None:
    """Open the null device under a number, if nothing is open there."""
    try:
        os.fstat(number)
    except OSError:
        _to_nowhere(number)


def _to_nowhere(number: int) -> None:
    nowhere = os.open(os.devnull, os.O_RDWR)
    if nowhere != number:
        os.dup2(nowhere, number)
        os.close(nowhere)
