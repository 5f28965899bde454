"""Files that are written whole or not at all."""

import errno
import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from workbench.errors import Refused


@contextmanager
def replacing(path: Path) -> Iterator[BinaryIO]:
    """Open a file for writing that takes the place of ``path`` once it is safe on the disk.

    Until the block has ended well, whatever is at ``path`` stays as it is; if the block raises,
    it stays for good. A replaced file hands on its permissions; a symbolic link is followed.

    Parameters
    ----------
    path : Path
        File to write.

    Yields
    ------
    BinaryIO
        A temporary file in the same folder, open for writing.

    Raises
    ------
    Refused
        If writing fails, here or in the block: missing or read-only folder, full disk, a folder
        or a write-protected file at ``path``, ...
    """
    with _refusing(path):
        target = Path(os.path.realpath(path))
        mode = _mode(target)
        with _temporary(target.parent) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
            file.close()
            if mode is not None:
                os.chmod(file.name, mode)
            os.replace(file.name, target)
        _sync(target.parent)


def check_writable(path: Path) -> None:
    """Find out beforehand whether `replacing` can write a file.

    Raises
    ------
    Refused
        If it cannot.
    """
    with _refusing(path):
        target = Path(os.path.realpath(path))
        _mode(target)
        with _temporary(target.parent):
            pass


@contextmanager
def _refusing(path: Path) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError as error:
        raise Refused(str(path), "cannot be written: its folder does not exist") from error
    except OSError as error:
        raise Refused(str(path), f"cannot be written: {error.strerror or error}") from error


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
def _temporary(folder: Path) -> Iterator[BinaryIO]:
    # Not from tempfile, whose files only their owner may read, whatever the umask says.
    path = folder / f".{secrets.token_hex(8)}.tmp"
    try:
        with path.open("xb") as file:
            yield file
    finally:
        path.unlink(missing_ok=True)


def _sync(folder: Path) -> None:
    """Make a new name in a folder outlive a power cut."""
    if os.name == "nt":  # opens no folder
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
