"""Arrays of float64 or bool in numpy's .npy format, read without trust."""

import io
import math
import warnings
from typing import IO, Any

import numpy as np

from workbench.arrays import Array, Mask
from workbench.errors import Refused
from workbench.said import Said

_LONGEST_HEADER = 1024
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def largest_size(shape: tuple[int, ...]) -> int:
    """Most bytes that an array of a shape may take in a file."""
    return _LONGEST_HEADER + 8 * math.prod(shape)


def write_array(file: IO[bytes], array: Array | Mask) -> None:
    """Write an array in C order, booleans as such and all else as float64."""
    kind = "?" if array.dtype == np.bool_ else "<f8"
    np.lib.format.write_array(file, np.ascontiguousarray(array, dtype=kind), allow_pickle=False)


def read_array(content: bytes, shape: tuple[int, ...], where: str) -> Array:
    """Read an array of float64 whose shape is known beforehand.

    `content`: the whole file; `shape`: the shape that it must have; `where`: what a refusal calls
    it. The array is finite and read-only. Raises `Refused` if it is anything but such an array.
    """
    values = _values(content, shape, np.dtype("<f8"), where)
    array = np.frombuffer(values, dtype=np.float64).reshape(shape)
    if not np.isfinite(array).all():
        raise Refused(
            where, Said("holds a value that is NaN or infinite; finite values are needed")
        )
    return array


def read_mask(content: bytes, shape: tuple[int, ...], where: str) -> Mask:
    """Read an array of bool; else as `read_array`."""
    values = np.frombuffer(_values(content, shape, np.dtype("?"), where), dtype=np.uint8)
    if (values > 1).any():
        raise Refused(where, Said("holds a value that is neither 0 nor 1; false or true is needed"))
    return values.view(np.bool_).reshape(shape)


def _values(content: bytes, shape: tuple[int, ...], kind: np.dtype[Any], where: str) -> bytes:
    file = io.BytesIO(content)
    found, fortran, dtype = _read_header(file, where)
    if dtype != kind:
        raise Refused(where, Said("holds {dtype}; {kind} is needed", dtype=dtype, kind=kind))
    if found != shape:
        raise Refused(
            where, Said("has shape {found}; the scene needs {shape}", found=found, shape=shape)
        )
    if fortran:
        raise Refused(where, Said("is in Fortran order; C order is needed"))
    values = file.read()
    size = kind.itemsize * math.prod(shape)
    if len(values) != size:
        raise Refused(
            where,
            Said(
                "has {given} bytes of values; shape {shape} needs {size}",
                given=len(values),
                shape=shape,
                size=size,
            ),
        )
    return values


def _read_header(file: IO[bytes], where: str) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    try:
        with warnings.catch_warnings(action="error"):
            version = np.lib.format.read_magic(file)
            read = _HEADER_READERS[version]
            return read(file, max_header_size=_LONGEST_HEADER)
    except Exception as error:  # the header is a Python literal: whatever parsing one raises
        raise Refused(where, Said("is no .npy array: its header cannot be read")) from error
