"""Checkpoints of a long run, and its final session.

1. During the run the best lens so far lies beside the output, in case the process is killed. It is
   removed after the output is written.
2. Checkpoints of earlier runs are neither replaced nor removed.
3. If the output cannot be written, the lens goes to a folder for temporary files, or to the user's
   folder.
"""

import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from hashlib import blake2b
from itertools import count
from pathlib import Path

from tqdm import tqdm

from workbench.design.snapshot import History, Result
from workbench.errors import Refused
from workbench.files.session import Session, write_session

_SECONDS = 10.0  # between checkpoints
_PART = 0.02  # most part of the time for writing checkpoints
_LONGEST_STEM = 220  # bytes of a name; file systems allow 255, ending included
_SHORT_STEM = 40  # characters, of at most 4 bytes each


class CheckpointWriter:
    """Writes the session of a run; ``session`` makes it from a result."""

    def __init__(self, output: Path, session: Callable[[Result], Session]) -> None:
        self._output, self._session = output, session
        self._checkpoint: Path | None = None
        self._kept: Result | None = None
        self._failed = False
        self._due = time.monotonic() + _SECONDS

    def find_abandoned(self) -> Path | None:
        """Return the last checkpoint of an earlier killed run, if there is one."""
        found = None
        for path in _checkpoints(self._output):
            if not path.exists():
                break
            found = path
        return found

    def write_if_due(self, history: History) -> None:
        """Write a checkpoint if it is due and there is a better lens."""
        start = time.monotonic()
        if start < self._due:
            return
        result = history.result()
        if result is not None and not self._has(result):
            self._write_checkpoint(result)
        took = time.monotonic() - start
        self._due = start + took + max(_SECONDS, took / _PART)

    def finish(self, result: Result) -> None:
        """Write the session and remove the checkpoint.

        Raise Refused if it cannot be written; the message says where the lens is instead.
        """
        try:
            write_session(self._session(result), self._output)
        except Refused as refused:
            raise Refused(refused.path, f"{refused.reason}; {self._rescue(result)}") from refused
        if self._checkpoint is not None:
            with suppress(OSError):  # a superfluous file is harmless
                self._checkpoint.unlink()

    def _has(self, result: Result) -> bool:
        return self._kept is not None and self._kept.state is result.state

    def _write_checkpoint(self, result: Result) -> None:
        path = self._checkpoint or next(p for p in _checkpoints(self._output) if not p.exists())
        try:
            write_session(self._session(result), path)
        except Refused as refused:
            if not self._failed:
                tqdm.write(f"no checkpoint is kept: {refused}", file=sys.stderr)
            self._failed = True
        else:
            self._checkpoint, self._kept = path, result

    def _rescue(self, result: Result) -> str:
        for place in (tempfile.gettempdir, Path.home):
            with suppress(OSError, RuntimeError, Refused):  # try the next folder
                folder = Path(tempfile.mkdtemp(prefix="freeform-", dir=place()))
                write_session(self._session(result), folder / self._output.name)
                return f"the lens is in {folder / self._output.name}"
        if self._checkpoint is not None:
            return f"an earlier lens of this run is in {self._checkpoint}"
        return "nor could the lens be kept elsewhere"


def _checkpoints(output: Path) -> Iterator[Path]:
    name = os.fsencode(output.stem)
    stem = output.stem
    if (
        len(name) > _LONGEST_STEM
    ):  # with its ending, the name would exceed the limit of file systems
        stem = f"{stem[:_SHORT_STEM]}-{blake2b(name, digest_size=8).hexdigest()}"
    yield output.with_name(f"{stem}.checkpoint.freeform")
    for number in count(2):
        yield output.with_name(f"{stem}.checkpoint-{number}.freeform")
