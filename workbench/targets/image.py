"""Image files of all formats."""

import math
import warnings
import zlib
from io import SEEK_END, BytesIO
from pathlib import Path
from typing import BinaryIO

import numpy as np

from workbench.errors import Refused
from workbench.messages import Message
from workbench.targets.colour import LINEAR, NUMBERS, Tone
from workbench.targets.exr_image import is_exr, read_exr
from workbench.targets.picture import Picture, UnusablePicture, check_size, gathered
from workbench.targets.radiance_image import is_radiance, read_radiance
from workbench.targets.raster_image import FORMATS, read_raster
from workbench.targets.svg import draw_svg, is_svg

KNOWN = (*FORMATS, "EXR", "HDR", "SVG", "SVGZ", "NPY")
"""Names of the formats for messages."""
_BEGINNING = 1024  # bytes that identify the format
_LARGEST_DRAWING = 16 << 20  # bytes of SVG
_GZIP, _GZIP_WINDOW = b"\x1f\x8b", 31
_LONGEST_HEADER = 1 << 14  # bytes; a forged header may claim four billion
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def read_picture(path: Path, side: int = 1024, tone: Tone = LINEAR) -> Picture:
    """Read an image file as light.

    Colour becomes grey by the luminance of each channel. A colour profile in the file, or a gAMA
    or sRGB chunk of a PNG, defines stored values; without it the tone of the scene does, with the
    weights of Rec. 709. Transparent areas are black; if everything drawn on a transparent ground
    is black, as in many logos, the opacity is the light. 16-bit grey keeps its precision (16-bit
    colour is read with 8 bits). Of several frames or pages the first is read. An orientation in
    the file is applied. EXR, Radiance HDR and ``.npy`` hold light.

    `path`: image file in one of `KNOWN`; a .npy holds a 2-D array of numbers; `side`: pixels of the
    longer side of an SVG, which has no pixels; `tone`: conversion of stored values if the file
    defines none. 8-bit and 16-bit images span [0, 1]. Raises `Refused` if the file is missing, no
    such image, damaged or empty, has more than `MOST_PIXELS`, holds a negative or non-finite value,
    links to another picture, has letters that no font has, or holds unbounded numbers while the
    tone is that of a monitor.
    """
    try:
        if path.is_dir():
            raise _refused(path, Message("is a folder; an image file is needed"))
        if not path.is_file():
            raise _refused(path, Message("is not an existing file; an image file is needed"))
        with path.open("rb") as file:
            return decode_picture(path, file, side, tone)
    except OSError as error:
        raise _refused(
            path, Message("cannot be read: {why}", why=error.strerror or error)
        ) from error


def decode_picture(path: Path, file: BinaryIO, side: int = 1024, tone: Tone = LINEAR) -> Picture:
    """Read the content of an image file as `read_picture` does.

    The ending of ``path`` identifies a .npy; messages name it.
    """
    try:
        found = _decoded(path, file, side, tone)
    except UnusablePicture as unusable:
        raise _refused(path, unusable.reason) from unusable
    if found.tone is NUMBERS and tone is not LINEAR:
        raise Refused(
            "target.tone",
            Message(
                "'{tone}' is for shades, and '{path}' holds numbers; 'linear'",
                tone=tone.name,
                path=path,
            ),
        )
    remarks = tuple(Message("'{path}' {remark}", path=path, remark=each) for each in found.remarks)
    return found._replace(remarks=remarks)


def _decoded(path: Path, file: BinaryIO, side: int, tone: Tone) -> Picture:
    if path.suffix.lower() == ".npy":
        return read_npy(file)
    beginning = file.read(_BEGINNING)
    file.seek(0)
    if is_exr(beginning):
        return _as_light(read_exr(file.read()), tone)
    if is_radiance(beginning):
        return _as_light(read_radiance(file.read()), tone)
    if beginning.startswith(_GZIP):
        file = BytesIO(_unpacked(file.read()))
        beginning = file.read(_BEGINNING)
        file.seek(0)
    if is_svg(beginning):
        content = file.read(_LARGEST_DRAWING + 1)
        if len(content) > _LARGEST_DRAWING:
            raise UnusablePicture(
                Message("is an SVG of more than {most} MB", most=_LARGEST_DRAWING >> 20)
            )
        file = BytesIO(draw_svg(content, side))
    # An open file, not its path: pillow maps an uncompressed TIFF into memory and then garbles one
    # with a rotated orientation.
    return read_raster(file, tone, KNOWN)


def _as_light(found: Picture, tone: Tone) -> Picture:
    if tone is LINEAR:
        return found
    light = Message("holds light itself; “Brightness” (target.tone) does not count")
    return found._replace(remarks=(*found.remarks, light))


def _unpacked(content: bytes) -> bytes:
    try:
        return zlib.decompressobj(_GZIP_WINDOW).decompress(content, _LARGEST_DRAWING + 1)
    except zlib.error as error:
        raise UnusablePicture(Message("is damaged or incomplete: {why}", why=error)) from error


def _refused(path: Path, reason: Message) -> Refused:
    return Refused("target.image", Message("'{path}' {reason}", path=path, reason=reason))


def read_npy(file: BinaryIO) -> Picture:
    """Read a 2-D array of real numbers, never unpickling; raise UnusablePicture otherwise."""
    header = BytesIO(file.read(_LONGEST_HEADER))
    try:
        # Check the shape before allocating memory.
        with warnings.catch_warnings(action="ignore"):
            version = np.lib.format.read_magic(header)
            shape, fortran, dtype = _HEADER_READERS[version](header)
            shape = tuple(map(int, shape))  # numpy lets True be a length
    except Exception as error:  # the header is a Python literal: whatever parsing one raises
        raise UnusablePicture(
            Message("is not a whole .npy array of numbers: {why}", why=error)
        ) from error
    if len(shape) != 2:
        raise UnusablePicture(
            Message("has {count} dimensions; 2 (rows, columns) are needed", count=len(shape))
        )
    if dtype.kind not in "buif":
        raise UnusablePicture(
            Message("holds values of type {kind}; real numbers are needed", kind=dtype)
        )
    check_size(*shape)
    begin, size = header.tell(), dtype.itemsize * math.prod(shape)
    if file.seek(0, SEEK_END) - begin < size:
        raise UnusablePicture(
            Message(
                "is not a whole .npy array of numbers: it lacks some of {size} bytes", size=size
            )
        )
    file.seek(begin)
    stored = np.frombuffer(file.read(size), dtype).reshape(shape, order="F" if fortran else "C")
    with np.errstate(over="ignore"):  # too large for float64 becomes infinite, refused as such
        found = gathered(*shape, lambda top, end: stored[top:end].astype(np.float64))
    return found._replace(tone=NUMBERS)
