"""Entries of a session's zip, and arrays in numpy's .npy format, read without trust."""

import io
import math
import struct
import warnings
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from textwrap import shorten
from typing import IO, Any, BinaryIO

import numpy as np

from workbench.arrays import Array, Mask
from workbench.errors import Refused, shown
from workbench.messages import Message

_LONGEST_HEADER = 1024
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def largest_size(shape: tuple[int, ...]) -> int:
    """Most bytes of a file of an array of this shape."""
    return _LONGEST_HEADER + 8 * math.prod(shape)


def write_array(file: IO[bytes], array: Array | Mask) -> None:
    """Write an array in C order, as bool or float64."""
    kind = "?" if array.dtype == np.bool_ else "<f8"
    np.lib.format.write_array(file, np.ascontiguousarray(array, dtype=kind), allow_pickle=False)


def read_array(content: bytes, shape: tuple[int, ...], where: str) -> Array:
    """Return a finite, read-only array of float64; raise Refused if the content is anything else.

    `content`: the whole file; `where`: its name in refusals.
    """
    values = _values(content, shape, np.dtype("<f8"), where)
    array = np.frombuffer(values, dtype=np.float64).reshape(shape)
    if not np.isfinite(array).all():
        raise Refused(
            where, Message("holds a value that is NaN or infinite; finite values are needed")
        )
    return array


def read_mask(content: bytes, shape: tuple[int, ...], where: str) -> Mask:
    """Return an array of bool, as `read_array`."""
    values = np.frombuffer(_values(content, shape, np.dtype("?"), where), dtype=np.uint8)
    if (values > 1).any():
        raise Refused(
            where, Message("holds a value that is neither 0 nor 1; false or true is needed")
        )
    return values.view(np.bool_).reshape(shape)


def _values(content: bytes, shape: tuple[int, ...], kind: np.dtype[Any], where: str) -> bytes:
    file = io.BytesIO(content)
    found, fortran, dtype = _read_header(file, where)
    if dtype != kind:
        raise Refused(where, Message("holds {dtype}; {kind} is needed", dtype=dtype, kind=kind))
    if found != shape:
        raise Refused(
            where, Message("has shape {found}; the scene needs {shape}", found=found, shape=shape)
        )
    if fortran:
        raise Refused(where, Message("is in Fortran order; C order is needed"))
    values = file.read()
    size = kind.itemsize * math.prod(shape)
    if len(values) != size:
        raise Refused(
            where,
            Message(
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
    except Exception as error:  # parsing a Python literal may raise anything
        raise Refused(where, Message("is no .npy array: its header cannot be read")) from error


# What zipfile raises on damaged archives, besides OSError.
_DAMAGE = (
    zipfile.BadZipFile,
    EOFError,
    NotImplementedError,
    OverflowError,
    RuntimeError,
    ValueError,
    struct.error,
)


class Entries:
    """Stored entries of an open zip, checked before they are read; raises Refused if damaged."""

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self._path = path
        with self._whole():
            self._archive = zipfile.ZipFile(file)
        self._names = frozenset(self._archive.namelist())
        self._size = file.seek(0, 2)

    def where(self, name: str) -> str:
        """Name of an entry in refusals."""
        return f"{self._path}: {name}"

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def check_names(self, needed: set[str]) -> None:
        """Refuse a zip with other entries, duplicates, or entries beyond its size."""
        for name in self._archive.namelist():
            if name not in needed:
                raise Refused(self.where(shown(name)), Message("does not belong into this session"))
        if len(self._archive.namelist()) > len(self._names):
            raise Refused(str(self._path), Message("holds an entry twice; each must be there once"))
        entries = self._archive.infolist()
        for info in entries:
            if info.header_offset + info.compress_size > self._size:
                raise Refused(self.where(info.filename), Message("is cut off"))
        if sum(info.compress_size for info in entries) > self._size:
            raise Refused(
                str(self._path), Message("holds entries that overlap; each has bytes of its own")
            )

    def content(self, name: str, largest: int) -> bytes:
        """Return the bytes of an entry, at most ``largest``."""
        where = self.where(name)
        if name not in self:
            raise Refused(where, Message("is missing; a session holds it"))
        info = self._archive.getinfo(name)
        if info.compress_type != zipfile.ZIP_STORED or info.compress_size != info.file_size:
            raise Refused(
                where, Message("is compressed or encrypted; sessions store entries as they are")
            )
        if info.file_size > largest:
            raise Refused(
                where,
                Message(
                    "has {size} bytes; at most {largest} are possible",
                    size=info.file_size,
                    largest=largest,
                ),
            )
        with self._whole():
            return self._archive.read(info)

    def array(self, name: str, shape: tuple[int, ...]) -> Array:
        """Return the array of an entry."""
        return read_array(self.content(name, largest_size(shape)), shape, self.where(name))

    def mask(self, name: str, shape: tuple[int, ...]) -> Mask:
        """Return the mask of an entry."""
        return read_mask(self.content(name, largest_size(shape)), shape, self.where(name))

    @contextmanager
    def _whole(self) -> Iterator[None]:
        try:
            yield
        except _DAMAGE as error:
            # Some messages quote the content of the file.
            detail = shorten(str(error) or "it ends too soon", 100, placeholder=" ...")
            raise Refused(
                str(self._path), Message("is a damaged or incomplete zip: {detail}", detail=detail)
            ) from error
