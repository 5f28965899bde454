"""Folders that one process at a time works in."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from workbench.errors import Refused
from workbench.said import Said

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl


@contextmanager
def locked(path: Path, busy: str) -> Iterator[None]:
    """Hold a lock for as long as the block lasts.

    However a process ends, its locks end with it.

    `path`: file that stands for the lock. It is there while somebody holds it, or was killed;
    `busy`: what a refusal says of its folder while another process holds the lock. Raises `Refused`
    if it does, or the file cannot be made.
    """
    try:
        handle = _taken(path)
    except BlockingIOError as error:
        raise Refused(str(path.parent), busy) from error
    except OSError as error:
        raise Refused(
            str(path), Said("cannot be written: {problem}", problem=error.strerror or error)
        ) from error
    try:
        yield
    finally:
        with suppress(OSError):  # then an empty file is left
            path.unlink()
        os.close(handle)


def _taken(path: Path) -> int:
    """The locked file, open."""
    while True:
        handle = os.open(path, os.O_CREAT | os.O_RDWR, 0o666)
        try:
            _lock(handle)
            # Else its last holder has removed it before it was locked here.
            if path.exists() and os.path.samestat(os.fstat(handle), path.stat()):
                return handle
        except BaseException:
            os.close(handle)
            raise
        os.close(handle)


if sys.platform == "win32":

    def _lock(handle: int) -> None:
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        except OSError as error:
            raise BlockingIOError from error

else:

    def _lock(handle: int) -> None:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise
        except OSError:  # a file system without locks, where nobody can know of another
            return
