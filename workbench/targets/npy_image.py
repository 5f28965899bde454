"""Reads light from a .npy file."""

import math
import warnings
from io import SEEK_END, BytesIO
from typing import BinaryIO

import numpy as np

from workbench.said import Said
from workbench.targets.picture import Picture, UnusablePicture, check_size, gathered
from workbench.targets.tone import NUMBERS

_LONGEST_HEADER = 1 << 14  # bytes; a header may say that it has four billion
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def read_npy(file: BinaryIO) -> Picture:
    """Read a 2-D array of real numbers; never unpickles.

    Raises
    ------
    UnusablePicture
        If the file holds anything else.
    """
    header = BytesIO(file.read(_LONGEST_HEADER))
    try:
        # The shape is known before any memory is taken.
        with warnings.catch_warnings(action="ignore"):
            version = np.lib.format.read_magic(header)
            shape, fortran, dtype = _HEADER_READERS[version](header)
            shape = tuple(map(int, shape))  # numpy lets True be a length
    except Exception as error:  # the header is a Python literal: whatever parsing one raises
        raise UnusablePicture(
            Said("is not a whole .npy array of numbers: {why}", why=error)
        ) from error
    if len(shape) != 2:
        raise UnusablePicture(
            Said("has {count} dimensions; 2 (rows, columns) are needed", count=len(shape))
        )
    if dtype.kind not in "buif":
        raise UnusablePicture(
            Said("holds values of type {kind}; real numbers are needed", kind=dtype)
        )
    check_size(*shape)
    begin, size = header.tell(), dtype.itemsize * math.prod(shape)
    if file.seek(0, SEEK_END) - begin < size:
        raise UnusablePicture(
            Said("is not a whole .npy array of numbers: it lacks some of {size} bytes", size=size)
        )
    file.seek(begin)
    stored = np.frombuffer(file.read(size), dtype).reshape(shape, order="F" if fortran else "C")
    with np.errstate(over="ignore"):  # too large for float64 becomes infinite, refused as such
        found = gathered(*shape, lambda top, end: stored[top:end].astype(np.float64))
    return found._replace(tone=NUMBERS)
