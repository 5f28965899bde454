"""Arrays of float64 in numpy's .npy format, read without trust."""

import io
import math
import warnings
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from workbench.errors import Refused

Array = npt.NDArray[np.float64]

_LONGEST_HEADER = 1024
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def largest_size(shape: tuple[int, ...]) -> int:
    """Most bytes that an array of a shape may take in a file."""
    return _LONGEST_HEADER + 8 * math.prod(shape)


def write_array(file: IO[bytes], array: Array) -> None:
    """Write an array in C order."""
    np.lib.format.write_array(file, np.ascontiguousarray(array, dtype="<f8"), allow_pickle=False)


def read_array(content: bytes, shape: tuple[int, ...], where: str) -> Array:
    """Read an array whose shape is known beforehand.

    Parameters
    ----------
    content : bytes
        The whole file.
    shape : tuple of int
        The shape that it must have.
    where : str
        What a refusal calls it.

    Returns
    -------
    ndarray of float64
        Finite; read-only.

    Raises
    ------
    Refused
        If it is anything but such an array.
    """
    file = io.BytesIO(content)
    found, fortran, dtype = _read_header(file, where)
    if dtype != np.dtype("<f8"):
        raise Refused(where, f"holds {dtype}; float64 is needed")
    if found != shape:
        raise Refused(where, f"has shape {found}; the scene needs {shape}")
    if fortran:
        raise Refused(where, "is in Fortran order; C order is needed")
    values = file.read()
    size = 8 * math.prod(shape)
    if len(values) != size:
        raise Refused(where, f"has {len(values)} bytes of values; shape {shape} needs {size}")
    array = np.frombuffer(values, dtype=np.float64).reshape(shape)
    if not np.isfinite(array).all():
        raise Refused(where, "holds a value that is NaN or infinite; finite values are needed")
    return array


def _read_header(file: IO[bytes], where: str) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    try:
        with warnings.catch_warnings(action="error"):
            version = np.lib.format.read_magic(file)
            read = _HEADER_READERS[version]
            return read(file, max_header_size=_LONGEST_HEADER)
    except Exception as error:  # the header is a Python literal: whatever parsing one raises
        raise Refused(where, "is no .npy array: its header cannot be read") from error
