"""Rays by IES TM-25-13 (.tm25ray).

A header of 36,288 bytes, spectra padded to a multiple of 32 bytes, 512 bytes for the name of each
additional column, a text, and then the rays as float32, all in little endian. Flags in the header
say which columns are present; their order is fixed.
"""

from collections.abc import Iterator
from typing import BinaryIO

import numpy as np

from workbench.measured.rays.rayset import Columns, Floats, RaySet, gathered, records, size_of
from workbench.messages import Message

HEADER = np.dtype(
    [
        ("magic", "S4"),
        ("version", "<i4"),
        ("method", "<i4"),
        ("luminous_flux", "<f4"),
        ("radiant_flux", "<f4"),
        ("rays", "<u8"),
        ("date", "S28"),
        ("start", "<i4"),
        ("spectral", "<i4"),
        ("wavelength", "<f4"),
        ("shortest", "<f4"),
        ("longest", "<f4"),
        ("spectra", "<i4"),
        ("more_columns", "<i4"),
        ("text", "<i4"),
        ("reserved", "V168"),
        ("flags", "<i4", 8),
        ("descriptions", "<U1000", 9),
    ]
)
"""The header; its flags are those of position, direction and the columns `FLAGGED`."""
VERSION = 2013
FLAGGED = ("radiant_flux", "wavelength", "luminous_flux", "stokes", "tristimulus", "spectrum")
"""Column of each flag after the first two."""
_WIDTH = {"stokes": 6, "tristimulus": 2}  # in columns; of the others 1
_NAME = 512  # bytes of the name of a column
_MOST_SPECTRA, _MOST_POINTS, _MOST_COLUMNS, _MOST_TEXT = 10_000, 100_000, 100, 1 << 26


def read_tm25(file: BinaryIO) -> RaySet:
    """Read rays of an open .tm25ray file; raise ValueError if it is invalid."""
    size = size_of(file)
    header = np.frombuffer(_bytes(file, HEADER.itemsize, Message("its header")), HEADER)[0]
    if header["magic"] != b"TM25":
        raise ValueError(Message("it does not begin with TM25"))
    if header["version"] != VERSION:
        raise ValueError(
            Message(
                "it is of version {found}; {known} is known", found=header["version"], known=VERSION
            )
        )
    columns, width = _columns(header)
    spectra = tuple(_spectra(file, int(header["spectra"])))
    _skip(file, _NAME * _count(header, "more_columns", _MOST_COLUMNS))
    _skip(file, _count(header, "text", _MOST_TEXT))
    rays, left = int(header["rays"]), size - file.tell()
    if rays * width * 4 != left:
        left = max(left, 0)
        raise ValueError(
            Message(
                "its header says {rays} rays of {width} numbers, and the {left} bytes behind it "
                "are {found:.10g} of them",
                rays=rays,
                width=width,
                left=left,
                found=left / (4 * width),
            )
        )
    return gathered(records(file, rays, width), columns, rays, "mm", spectra)


def _columns(header: np.void) -> tuple[Columns, int]:
    flags = header["flags"]
    if not np.isin(flags, (0, 1)).all() or not flags[:2].all():
        found = flags.tolist()
        raise ValueError(
            Message("the flags of its columns are {found}; 1, 1 and then 0 or 1", found=found)
        )
    at, width = {}, 6
    for name, flag in zip(FLAGGED, flags[2:], strict=True):
        if flag:
            at[name] = width
            width += _WIDTH.get(name, 1)
    width += _count(header, "more_columns", _MOST_COLUMNS)
    # Luminous flux if both are given; all rays have equal flux if neither is.
    flux = at.get("luminous_flux", at.get("radiant_flux"))
    return Columns(flux, at.get("wavelength"), at.get("spectrum")), width


def _spectra(file: BinaryIO, number: int) -> Iterator[Floats]:
    if not 0 <= number <= _MOST_SPECTRA:
        raise ValueError(
            Message("its header says {n} spectra; from 0 to {most}", n=number, most=_MOST_SPECTRA)
        )
    taken = 0
    for _ in range(number):
        points = int(np.frombuffer(_bytes(file, 4, Message("its spectra")), "<i4")[0])
        if not 0 < points <= _MOST_POINTS:
            raise ValueError(
                Message(
                    "one of its spectra has {n} points; from 1 to {most}",
                    n=points,
                    most=_MOST_POINTS,
                )
            )
        content = _bytes(file, 8 * points, Message("its spectra"))
        yield np.frombuffer(content, "<f4").reshape(points, 2).astype(np.float32)
        taken += 4 + 8 * points
    _skip(file, -taken % 32)


def _count(header: np.void, name: str, most: int) -> int:
    value = int(header[name])
    if not 0 <= value <= most:
        name = name.replace("_", " ")
        raise ValueError(
            Message(
                'its header says {value} for "{name}"; from 0 to {most}',
                value=value,
                name=name,
                most=most,
            )
        )
    return value


def _skip(file: BinaryIO, length: int) -> None:
    file.seek(length, 1)


def _bytes(file: BinaryIO, length: int, part: Message) -> bytes:
    content = file.read(length)
    if len(content) < length:
        raise ValueError(Message("it is cut off within {part}", part=part))
    return content
