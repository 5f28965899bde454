"""Rays of OpticStudio (.dat): binary, or as text.

Binary: a header of 208 bytes and 7 numbers a ray, 8 with wavelengths in µm, as float32 in little
endian. Text: a line with the number of rays and that of the unit, which some programs fill up with
zeros to the number of columns, and then a line with 7 numbers for each ray.
"""

import codecs
import re
from typing import BinaryIO

import numpy as np

from workbench.measured.rays.rayset import Columns, RaySet, gathered, records, size_of
from workbench.measured.rays.table import in_utf8, read_below, read_csv
from workbench.measured.text import count
from workbench.messages import Message

HEADER = np.dtype(
    [
        ("identifier", "<i4"),
        ("rays", "<u4"),
        ("description", "S100"),
        ("source_flux", "<f4"),
        ("flux", "<f4"),
        ("wavelength_um", "<f4"),
        ("angles", "<f4", 4),
        ("unit", "<u4"),
        ("placement", "<f4", 9),
        ("unused", "<f4", 4),
        ("format", "<i4"),
        ("flux_type", "<i4"),
        ("reserved", "<i4", 2),
    ]
)
"""Header of a binary file."""
IDENTIFIER = 1010
UNITS = ("m", "inch", "cm", "feet", "mm")
_WIDTHS = {0: 7, 2: 8}


def read_dat(file: BinaryIO) -> RaySet:
    """Read rays of an open .dat file; raise ValueError if it is invalid."""
    size = size_of(file)
    content = file.read(HEADER.itemsize)
    if len(content) >= 4 and np.frombuffer(content[:4], "<i4")[0] == IDENTIFIER:
        return _binary(file, content, size)
    with in_utf8(file) as text:
        start, counted = _beginning(text)
        if counted is None:
            raise ValueError(
                Message("it begins neither like a binary source file nor like one of text")
            )
        return _below(text, start, *counted)


def read_text(file: BinaryIO) -> RaySet:
    """Read rays of an open text that may have an OpticStudio header; raise as `read_dat`."""
    with in_utf8(file) as text:
        start, counted = _beginning(text)
        return read_csv(text) if counted is None else _below(text, start, *counted)


def _beginning(file: BinaryIO) -> tuple[int, tuple[int, str] | None]:
    file.seek(0)
    beginning = file.read(HEADER.itemsize)
    text = beginning.removeprefix(codecs.BOM_UTF8).lstrip()
    head = text.split(b"\n")[0].split(b"\r")[0]
    return len(beginning) - len(text) + len(head), _counted(head)


def _counted(head: bytes) -> tuple[int, str] | None:
    try:
        rays, unit, *zeros = (float(word) for word in re.split(rb"[\s,;]+", head.strip(b" \t,;")))
    except ValueError:
        return None
    if any(zeros) or not (rays.is_integer() and unit.is_integer() and rays >= 0 and unit >= 0):
        return None
    return int(rays), UNITS[count(f"{unit:g}", 0, len(UNITS) - 1)]


def _below(file: BinaryIO, start: int, rays: int, unit: str) -> RaySet:
    file.seek(start)
    found = read_below(file, unit)
    if found.in_file != rays:
        raise ValueError(
            Message(
                "its first line says {rays} rays, and there are {found}",
                rays=rays,
                found=found.in_file,
            )
        )
    return found


def _binary(file: BinaryIO, content: bytes, size: int) -> RaySet:
    if len(content) < HEADER.itemsize:
        raise ValueError(Message("it is cut off within {part}", part=Message("its header")))
    header = np.frombuffer(content, HEADER)[0]
    width = _WIDTHS.get(int(header["format"]))
    if width is None:
        raise ValueError(
            Message("its rays are of format {found}; 0 or 2 is known", found=header["format"])
        )
    if header["unit"] >= len(UNITS):
        most = len(UNITS) - 1
        raise ValueError(
            Message("its unit is {found}; 0 to {most} are known", found=header["unit"], most=most)
        )
    rays, left = int(header["rays"]), size - HEADER.itemsize
    if rays * width * 4 != left:
        raise ValueError(
            Message(
                "its header says {rays} rays, and the {left} bytes behind it are {found:.10g} of "
                "them",
                rays=rays,
                left=left,
                found=left / (4 * width),
            )
        )
    columns = Columns(wavelength=7 if width == 8 else None)
    unit = UNITS[int(header["unit"])]
    return gathered(records(file, rays, width), columns, rays, unit, to_nm=1000)
