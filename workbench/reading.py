"""Opens files for reading, or says in one sentence why not."""

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from workbench.errors import Refused
from workbench.said import Said


@contextmanager
def opened(path: Path) -> Iterator[BinaryIO]:
    """Open an ordinary file for reading.

    `path`: file to read. Yields the open file. Raises `Refused` if it is missing, no ordinary file,
    or cannot be read, here or in the block.
    """
    if "\0" in str(path):  # which Python would not look for
        raise Refused(str(path), Said("does not exist; no file can have such a name"))
    try:
        # Asked first: opening a pipe would wait for someone to write.
        kind = os.stat(path).st_mode
        if stat.S_ISDIR(kind):
            raise Refused(str(path), Said("is a folder; a file is needed"))
        if not stat.S_ISREG(kind):
            raise Refused(str(path), Said("is a device or pipe; an ordinary file is needed"))
        with path.open("rb") as file:
            yield file
    except FileNotFoundError as error:
        raise Refused(str(path), Said("does not exist; the name of a file is needed")) from error
    except OSError as error:
        raise Refused(
            str(path), Said("cannot be read: {problem}", problem=error.strerror or error)
        ) from error
