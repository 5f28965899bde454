"""Binary rays, some at a time: a file may be larger than memory."""

from collections.abc import Iterator
from typing import BinaryIO

import numpy as np

from workbench.measured.rays.rayset import CHUNK, Floats
from workbench.said import Said


def size_of(file: BinaryIO) -> int:
    """Bytes of an open file, which is at its beginning then."""
    size = file.seek(0, 2)
    file.seek(0)
    return size


def records(file: BinaryIO, rays: int, width: int) -> Iterator[Floats]:
    """Rays of a file from where it is read, shape (m, width) at a time.

    Raises
    ------
    ValueError
        If the file ends before.
    """
    for first in range(0, rays, CHUNK):
        count = min(CHUNK, rays - first)
        content = file.read(4 * width * count)
        if len(content) < 4 * width * count:
            last = first + len(content) // (4 * width)
            raise ValueError(Said("it is cut off behind ray {ray}", ray=last))
        yield np.frombuffer(content, "<f4").reshape(count, width)
