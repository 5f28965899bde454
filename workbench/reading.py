"""Open files for reading, and find whether they changed."""

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import blake2b
from pathlib import Path
from typing import BinaryIO

from workbench.errors import Refused
from workbench.messages import Message


@contextmanager
def opened(path: Path) -> Iterator[BinaryIO]:
    """Open an ordinary file for reading; raise Refused if that fails, here or in the block."""
    if "\0" in str(path):  # for which Python raises ValueError
        raise Refused(str(path), Message("does not exist; no file can have such a name"))
    try:
        # Checked first: opening a pipe would wait for a writer.
        kind = os.stat(path).st_mode
        if stat.S_ISDIR(kind):
            raise Refused(str(path), Message("is a folder; a file is needed"))
        if not stat.S_ISREG(kind):
            raise Refused(str(path), Message("is a device or pipe; an ordinary file is needed"))
        with path.open("rb") as file:
            yield file
    except FileNotFoundError as error:
        raise Refused(str(path), Message("does not exist; the name of a file is needed")) from error
    except OSError as error:
        raise Refused(
            str(path), Message("cannot be read: {problem}", problem=error.strerror or error)
        ) from error


def fingerprint(path: Path) -> str | None:
    """Return a digest of a file's content; None without a file; raise Refused if unreadable."""
    if not path.exists():
        return None
    with opened(path) as file:
        return digest(file)


def digest(file: BinaryIO) -> str:
    """Return the digest of all that follows in an open file, as `fingerprint` does."""
    found = blake2b(digest_size=16)
    while block := file.read(1 << 20):
        found.update(block)
    return found.hexdigest()
