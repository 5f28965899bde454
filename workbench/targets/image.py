"""Reads an image file as brightness."""

import zlib
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from workbench.errors import Refused
from workbench.said import Said
from workbench.targets.exr_image import is_exr, read_exr
from workbench.targets.npy_image import read_npy
from workbench.targets.picture import Picture, UnusablePicture
from workbench.targets.radiance_image import is_radiance, read_radiance
from workbench.targets.raster_image import FORMATS, read_raster
from workbench.targets.svg import draw_svg, is_svg
from workbench.targets.tone import LINEAR, NUMBERS, Tone

KNOWN = (*FORMATS, "EXR", "HDR", "SVG", "SVGZ", "NPY")
"""Formats that are read, as people name them."""

_BEGINNING = 1024  # bytes that tell the format
_LARGEST_DRAWING = 16 << 20  # bytes of SVG
_GZIP, _GZIP_WINDOW = b"\x1f\x8b", 31


def read_picture(path: Path, side: int = 1024, tone: Tone = LINEAR) -> Picture:
    """Read an image file as light.

    Colour becomes grey by the luminance of each channel. A colour profile in the file, or a gAMA
    or sRGB chunk of a PNG, says what stored values mean; else the tone of the scene does, with the
    weights of Rec. 709. What is transparent gives no light. Where all that is drawn on a
    transparent ground is black, as in many a logo, the drawing itself is the light: its opacity
    counts. A 16-bit grey image keeps its precision (16-bit colour is read with 8 bits); of several
    frames or pages the first counts; an orientation noted in the file is honoured. An SVG is drawn
    on a transparent ground. Files in EXR, Radiance HDR and ``.npy`` hold light.

    Parameters
    ----------
    path : Path
        Image file in one of `KNOWN`; a .npy holds a 2-D array of numbers.
    side : int
        Pixels of the longer side of an SVG, which has none of its own.
    tone : Tone
        What a stored value means where the file does not say it.

    Returns
    -------
    Picture
        8-bit and 16-bit images span [0, 1].

    Raises
    ------
    Refused
        If the file is missing, not such an image, damaged or empty, has more than `MOST_PIXELS`,
        holds a negative or non-finite value, links to another picture, has letters that no font
        has, or holds numbers without a largest one while the tone is that of a monitor.
    """
    try:
        if path.is_dir():
            raise _refused(path, Said("is a folder; an image file is needed"))
        if not path.is_file():
            raise _refused(path, Said("is not an existing file; an image file is needed"))
        with path.open("rb") as file:
            return decode_picture(path, file, side, tone)
    except OSError as error:
        raise _refused(path, Said("cannot be read: {why}", why=error.strerror or error)) from error


def decode_picture(path: Path, file: BinaryIO, side: int = 1024, tone: Tone = LINEAR) -> Picture:
    """Read the content of an image file, as `read_picture` does.

    Parameters
    ----------
    path : Path
        What refusals call it; its ending tells a .npy.
    file : BinaryIO
        The content, which can be sought.
    side, tone
        As for `read_picture`.
    """
    try:
        found = _decoded(path, file, side, tone)
    except UnusablePicture as unusable:
        raise _refused(path, unusable.reason) from unusable
    if found.tone is NUMBERS and tone is not LINEAR:
        raise Refused(
            "target.tone",
            Said(
                "'{tone}' is for shades, and '{path}' holds numbers; 'linear'",
                tone=tone.name,
                path=path,
            ),
        )
    remarks = tuple(Said("'{path}' {remark}", path=path, remark=each) for each in found.remarks)
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
                Said("is an SVG of more than {most} MB", most=_LARGEST_DRAWING >> 20)
            )
        file = BytesIO(draw_svg(content, side))
    # An open file, not its path: pillow would map an uncompressed TIFF and then garble one that is
    # stored lying on its side.
    return read_raster(file, tone, KNOWN)


def _as_light(found: Picture, tone: Tone) -> Picture:
    """A picture whose format says that it holds light."""
    if tone is LINEAR:
        return found
    light = Said("holds light itself; “Brightness” (target.tone) does not count")
    return found._replace(remarks=(*found.remarks, light))


def _unpacked(content: bytes) -> bytes:
    """Content of a gzip file, at most a little more than the largest drawing."""
    try:
        return zlib.decompressobj(_GZIP_WINDOW).decompress(content, _LARGEST_DRAWING + 1)
    except zlib.error as error:
        raise UnusablePicture(Said("is damaged or incomplete: {why}", why=error)) from error


def _refused(path: Path, reason: Said) -> Refused:
    return Refused("target.image", Said("'{path}' {reason}", path=path, reason=reason))
