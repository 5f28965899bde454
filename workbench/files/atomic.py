"""Atomic writing of files, and locks between processes."""

import errno
import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import blake2b
from pathlib import Path
from typing import BinaryIO

from filelock import FileLock, Timeout

from workbench.errors import Refused
from workbench.messages import Message

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextmanager
def replacing(path: Path) -> Iterator[BinaryIO]:
    """Open a temporary file that replaces ``path`` at the end of the block, once it is on the disk.

    If the block raises, ``path`` stays as it is. A replaced file keeps its permissions; a symbolic
    link is followed. Raises `Refused` if writing fails, here or in the block.
    """
    with _refusing(path):
        target = Path(os.path.realpath(path))
        mode = _mode(target)
        with _temporary(target) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
            if mode is not None:
                os.chmod(file.name, mode)
            if os.name == "nt":  # where an open file cannot be renamed
                file.close()
            os.replace(file.name, target)
        _sync(target.parent)


def check_writable(path: Path) -> None:
    """Raise Refused if `replacing` cannot write a file."""
    with _refusing(path):
        target = Path(os.path.realpath(path))
        _mode(target)
        with _temporary(target):
            pass


def make_folder(folder: Path) -> None:
    """Make a folder if it is missing; raise Refused if that fails."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Refused(str(folder), f"cannot be made: {error.strerror or error}") from error


def remove_left_behind(path: Path) -> None:
    """Remove temporary files of killed processes for a path; `replacing` does so too."""
    for left in path.parent.glob(f".{_mark(path)}.*.tmp"):
        _remove_if_left(left)


@contextmanager
def _refusing(path: Path) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError as error:
        raise Refused(str(path), Message("cannot be written: its folder does not exist")) from error
    except OSError as error:
        raise Refused(
            str(path), Message("cannot be written: {problem}", problem=error.strerror or error)
        ) from error


def _mode(target: Path) -> int | None:
    """Permissions of an existing file; None without one."""
    try:
        found = target.stat().st_mode
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(found):
        raise IsADirectoryError(errno.EISDIR, "a folder of that name is there")
    if not stat.S_ISREG(found):
        raise OSError(errno.EINVAL, "a device or pipe is there; an ordinary file is needed")
    if not os.access(target, os.W_OK, effective_ids=os.access in os.supports_effective_ids):
        raise PermissionError(errno.EACCES, "the file is write-protected")
    return stat.S_IMODE(found)


@contextmanager
def _temporary(target: Path) -> Iterator[BinaryIO]:
    """Open a locked temporary file in the folder of ``target``.

    The file of a killed process is not locked: the next process with the same target removes it.
    """
    remove_left_behind(target)
    while True:
        path = target.with_name(f".{_mark(target)}.{secrets.token_hex(8)}.tmp")
        try:
            # Not by tempfile: only the owner may read its files, whatever the umask.
            with path.open("x+b") as file:
                if _locked(file, path):
                    yield file
                    return
        finally:
            path.unlink(missing_ok=True)


def _locked(file: BinaryIO, path: Path) -> bool:
    """Lock a new file; return False if another process has locked it to remove it."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks, where no process removes files
        return True
    return path.exists()


def _mark(target: Path) -> str:
    return blake2b(os.fsencode(target.name), digest_size=8).hexdigest()


def _remove_if_left(path: Path) -> None:
    with suppress(OSError):
        if fcntl is None:
            path.unlink()  # Windows does not remove open files
        else:
            with path.open("rb") as file:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                path.unlink()


def _sync(folder: Path) -> None:
    """Make a new name in a folder survive a power failure."""
    if os.name == "nt":  # folders cannot be opened
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


@contextmanager
def locked(path: Path, busy: str) -> Iterator[None]:
    """Hold a lock file during the block; it ends with the process.

    Raises `Refused` with the reason ``busy`` if another process holds it, or if it cannot be made.
    """
    lock = FileLock(path, timeout=0)
    with _refusing(path):
        try:
            lock.acquire()
        except Timeout as error:
            raise Refused(str(path.parent), busy) from error
    try:
        yield
    finally:
        with suppress(OSError):  # then an empty file is left
            path.unlink()
        lock.release()
