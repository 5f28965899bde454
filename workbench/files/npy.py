"""Arrays of float64 in numpy's .npy format, read without trust."""

import math
import tokenize
from typing import IO

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


def read_array(file: IO[bytes], shape: tuple[int, ...], where: str) -> Array:
    """Read an array whose shape is known beforehand.

    Parameters
    ----------
    file : binary file
        Holds the array and nothing else.
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
    try:
        version = np.lib.format.read_magic(file)
        if version not in _HEADER_READERS:
            raise Refused(where, f"has .npy version {version}; (1, 0) or (2, 0) is needed")
        found, fortran, dtype = _HEADER_READERS[version](file, max_header_size=_LONGEST_HEADER)
    except (ValueError, tokenize.TokenError) as error:
        raise Refused(where, "is no .npy array: its header cannot be read") from error
    if dtype != np.dtype("<f8"):
        raise Refused(where, f"holds {dtype}; float64 is needed")
    if found != shape:
        raise Refused(where, f"has shape {found}; the scene needs {shape}")
    if fortran:
        raise Refused(where, "is in Fortran order; C order is needed")
    size = 8 * math.prod(shape)
    content = file.read(size + 1)
    if len(content) != size:
        raise Refused(where, f"does not hold the {size} bytes of an array of shape {shape}")
    array = np.frombuffer(content, dtype=np.float64).reshape(shape)
    if not np.isfinite(array).all():
        raise Refused(where, "holds a value that is NaN or infinite; finite values are needed")
    return array
