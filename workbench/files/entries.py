"""Zip entries, read without trust."""

import struct
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from textwrap import shorten
from typing import BinaryIO

from workbench.arrays import Array, Mask
from workbench.errors import Refused, shown
from workbench.files.npy import largest_size, read_array, read_mask
from workbench.said import Said

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
    """The stored entries of a zip, each checked before any of it is read.

    `path`: what refusals call the zip; `file`: the zip, open for reading as long as this is used.
    Raises `Refused` if it is no zip; later, if an entry is not as it must be.
    """

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self._path = path
        with self._whole():
            self._archive = zipfile.ZipFile(file)
        self._names = frozenset(self._archive.namelist())
        self._size = file.seek(0, 2)

    def where(self, name: str) -> str:
        """What refusals call an entry."""
        return f"{self._path}: {name}"

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def check_names(self, needed: set[str]) -> None:
        """Refuse a zip that holds anything else, anything twice, or more than its size."""
        for name in self._archive.namelist():
            if name not in needed:
                raise Refused(self.where(shown(name)), Said("does not belong into this session"))
        if len(self._archive.namelist()) > len(self._names):
            raise Refused(str(self._path), Said("holds an entry twice; each must be there once"))
        entries = self._archive.infolist()
        for info in entries:
            if info.header_offset + info.compress_size > self._size:
                raise Refused(self.where(info.filename), Said("is cut off"))
        if sum(info.compress_size for info in entries) > self._size:
            raise Refused(
                str(self._path), Said("holds entries that overlap; each has bytes of its own")
            )

    def content(self, name: str, largest: int) -> bytes:
        """The bytes of an entry, at most so many."""
        where = self.where(name)
        if name not in self:
            raise Refused(where, Said("is missing; a session holds it"))
        info = self._archive.getinfo(name)
        if info.compress_type != zipfile.ZIP_STORED or info.compress_size != info.file_size:
            raise Refused(
                where, Said("is compressed or encrypted; sessions store entries as they are")
            )
        if info.file_size > largest:
            raise Refused(
                where,
                Said(
                    "has {size} bytes; at most {largest} are possible",
                    size=info.file_size,
                    largest=largest,
                ),
            )
        with self._whole():
            return self._archive.read(info)

    def array(self, name: str, shape: tuple[int, ...]) -> Array:
        """The array of an entry, of a shape known beforehand."""
        return read_array(self.content(name, largest_size(shape)), shape, self.where(name))

    def mask(self, name: str, shape: tuple[int, ...]) -> Mask:
        """The array of bool of an entry, of a shape known beforehand."""
        return read_mask(self.content(name, largest_size(shape)), shape, self.where(name))

    @contextmanager
    def _whole(self) -> Iterator[None]:
        try:
            yield
        except _DAMAGE as error:
            # Some quote what they found, be it as long as the file.
            detail = shorten(str(error) or "it ends too soon", 100, placeholder=" ...")
            raise Refused(
                str(self._path), Said("is a damaged or incomplete zip: {detail}", detail=detail)
            ) from error
