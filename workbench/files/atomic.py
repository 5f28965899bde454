"""Atomic writing of files, and locks between processes."""

import errno
import os
import secrets
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import blake2b
from pathlib import Path
from typing import BinaryIO

from workbench.errors import Refused
from workbench.said import Said

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextmanager
def replacing(path: Path) -> Iterator[BinaryIO]:
    """Open a file for writing that takes the place of ``path`` once it is safe on the disk.

    Until the block has ended well, whatever is at ``path`` stays as it is; if the block raises,
    it stays for good. A replaced file hands on its permissions; a symbolic link is followed.

    Yields a temporary file in the same folder, open for writing and reading. Raises `Refused` if
    writing fails, here or in the block: missing or read-only folder, full disk, a folder or a
    write-protected file at ``path``.
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
            if os.name == "nt":  # renames no open file; elsewhere it stays locked until then
                file.close()
            os.replace(file.name, target)
        _sync(target.parent)


def check_writable(path: Path) -> None:
    """Find out beforehand whether `replacing` can write a file.

    Raises `Refused` if it cannot.
    """
    with _refusing(path):
        target = Path(os.path.realpath(path))
        _mode(target)
        with _temporary(target):
            pass


def remove_left_behind(path: Path) -> None:
    """Remove what processes left that were killed while they wrote a file; `replacing` does too."""
    for left in path.parent.glob(f".{_mark(path)}.*.tmp"):
        _remove_if_left(left)


@contextmanager
def _refusing(path: Path) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError as error:
        raise Refused(str(path), Said("cannot be written: its folder does not exist")) from error
    except OSError as error:
        raise Refused(
            str(path), Said("cannot be written: {problem}", problem=error.strerror or error)
        ) from error


def _mode(target: Path) -> int | None:
    """Permissions of the file that is there; None where there is none."""
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
    """A file beside ``target`` for as long as the block lasts, or until it is renamed.

    A process that is killed leaves its file behind. The next that writes the same target, which
    the name tells, takes it away, since nobody has it locked.
    """
    remove_left_behind(target)
    while True:
        path = target.with_name(f".{_mark(target)}.{secrets.token_hex(8)}.tmp")
        try:
            # Not from tempfile, whose files only their owner may read, whatever the umask says.
            with path.open("x+b") as file:
                if _locked(file, path):
                    yield file
                    return
        finally:
            path.unlink(missing_ok=True)


def _locked(file: BinaryIO, path: Path) -> bool:
    """Lock a new file; False if another process was faster and takes it away."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks, where nobody takes anything away
        return True
    return path.exists()


def _mark(target: Path) -> str:
    return blake2b(os.fsencode(target.name), digest_size=8).hexdigest()


def _remove_if_left(path: Path) -> None:
    with suppress(OSError):
        if fcntl is None:
            path.unlink()  # Windows does not remove what is open
        else:
            with path.open("rb") as file:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                path.unlink()


def _sync(folder: Path) -> None:
    """Make a new name in a folder outlive a power cut."""
    if os.name == "nt":  # opens no folder
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


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
