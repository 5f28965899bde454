"""Reads an image file as brightness."""

import math
import warnings
from io import SEEK_END, BytesIO
from pathlib import Path
from typing import BinaryIO

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageOps, UnidentifiedImageError

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.said import Said
from workbench.targets.svg import draw_svg, is_svg
from workbench.targets.tone import LINEAR, Tone

LARGEST_SIDE = 8192
"""Most rows or columns that are read; keeps a forged header from filling the memory."""

# Named one by one because pillow knows formats that start other programs (EPS: Ghostscript).
FORMATS = ("PNG", "JPEG", "TIFF", "BMP", "GIF", "WEBP", "PPM", "JPEG2000", "TGA")
"""Image formats that are read, by pillow's names, besides SVG and .npy."""

_LARGEST_DRAWING = 16 << 20  # bytes of SVG

_LONGEST_HEADER = 1 << 14  # bytes of .npy; a header may say that it has four billion
_HEADER_READERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}

# Rec. 709 luminance weights.
_RED_GREEN_BLUE = np.array([0.2126, 0.7152, 0.0722])

# What is no brighter counts as black: rounding of transparent edges makes as much of black.
_BLACK = 2 / 255


def read_image(path: Path, side: int = 1024, tone: Tone = LINEAR) -> Array:
    """Read an image file as light.

    Colour becomes grey by the Rec. 709 weights of the light in each channel: of the stored values
    themselves, or of what a monitor makes of these. What is transparent gives no light. Where all
    that is drawn on a transparent ground is black, as in many a logo, the drawing itself is the
    light: its opacity counts. A 16-bit grey image keeps its precision (16-bit colour is read with
    8 bits); of several frames or pages the first counts; an orientation noted in the file is
    honoured. An SVG is drawn on a transparent ground. A file that ends in ``.npy`` holds light.

    Parameters
    ----------
    path : Path
        Image file in one of `FORMATS`, SVG, or .npy with a 2-D array of numbers.
    side : int
        Pixels of the longer side of an SVG, which has none of its own.
    tone : Tone
        What a stored value means.

    Returns
    -------
    ndarray, shape (rows, columns)
        Finite values >= 0, row 0 at the top. 8-bit and 16-bit images span [0, 1].

    Raises
    ------
    Refused
        If the file is missing, not such an image, damaged, empty, larger than `LARGEST_SIDE`
        on a side, holds a negative or non-finite value, or holds numbers without a largest one
        while the tone is that of a monitor.
    """
    try:
        if path.is_dir():
            raise _refused(path, Said("is a folder; an image file is needed"))
        if not path.is_file():
            raise _refused(path, Said("is not an existing file; an image file is needed"))
        with path.open("rb") as file:
            return decode_image(path, file, side, tone)
    except OSError as error:
        raise _refused(path, Said("cannot be read: {why}", why=error.strerror or error)) from error


def decode_image(path: Path, file: BinaryIO, side: int = 1024, tone: Tone = LINEAR) -> Array:
    """Read the content of an image file, as `read_image` does.

    Parameters
    ----------
    path : Path
        What refusals call it; its ending tells a .npy.
    file : BinaryIO
        The content, which can be sought.
    side, tone
        As for `read_image`.
    """
    if path.suffix.lower() == ".npy":
        pixels = _read_npy(path, file)
        _check_known(path, tone)
    else:
        pixels = _read_picture(path, file, side, tone)
    if not np.isfinite(pixels).all():
        raise _refused(
            path, Said("holds a value that is NaN or infinite; finite values are needed")
        )
    if pixels.min() < 0:
        raise _refused(
            path, Said("holds {least:g}; values of at least 0 are needed", least=pixels.min())
        )
    return pixels


def _check_known(path: Path, tone: Tone) -> None:
    """Refuse to take numbers for shades of a monitor, whose brightest one is not known."""
    if tone is not LINEAR:
        raise Refused(
            "target.tone",
            Said(
                "'{tone}' is for shades, and '{path}' holds numbers; 'linear'",
                tone=tone.name,
                path=path,
            ),
        )


def _refused(path: Path, reason: Said) -> Refused:
    return Refused("target.image", Said("'{path}' {reason}", path=path, reason=reason))


def _check_size(path: Path, rows: int, columns: int) -> None:
    if min(rows, columns) < 1:
        raise _refused(
            path,
            Said(
                "has {columns} × {rows} pixels; at least one is needed",
                columns=columns,
                rows=rows,
            ),
        )
    if max(rows, columns) > LARGEST_SIDE:
        raise _refused(
            path,
            Said(
                "has {columns} × {rows} pixels; at most {most} on a side are allowed",
                columns=columns,
                rows=rows,
                most=LARGEST_SIDE,
            ),
        )


def _read_npy(path: Path, file: BinaryIO) -> Array:
    header = BytesIO(file.read(_LONGEST_HEADER))
    try:
        # The shape is known before any memory is taken. Never unpickles.
        with warnings.catch_warnings(action="ignore"):
            version = np.lib.format.read_magic(header)
            shape, fortran, dtype = _HEADER_READERS[version](header)
            shape = tuple(map(int, shape))  # numpy lets True be a length
    except Exception as error:  # the header is a Python literal: whatever parsing one raises
        raise _refused(
            path, Said("is not a whole .npy array of numbers: {why}", why=error)
        ) from error
    if len(shape) != 2:
        raise _refused(
            path,
            Said("has {count} dimensions; 2 (rows, columns) are needed", count=len(shape)),
        )
    if dtype.kind not in "buif":
        raise _refused(
            path, Said("holds values of type {kind}; real numbers are needed", kind=dtype)
        )
    _check_size(path, *shape)
    begin, size = header.tell(), dtype.itemsize * math.prod(shape)
    if file.seek(0, SEEK_END) - begin < size:
        raise _refused(
            path,
            Said("is not a whole .npy array of numbers: it lacks some of {size} bytes", size=size),
        )
    file.seek(begin)
    stored = np.frombuffer(file.read(size), dtype).reshape(shape, order="F" if fortran else "C")
    with np.errstate(over="ignore"):  # too large for float64 becomes infinite, refused above
        return np.array(stored, dtype=np.float64)


def _read_picture(path: Path, file: BinaryIO, side: int, tone: Tone) -> Array:
    beginning = file.read(1024)
    file.seek(0)
    if not is_svg(beginning):
        # Given an open file, not its path: pillow would map an uncompressed TIFF and then garble
        # one that is stored lying on its side.
        return _decode(path, file, tone)
    content = file.read(_LARGEST_DRAWING + 1)
    if len(content) > _LARGEST_DRAWING:
        raise _refused(path, Said("is an SVG of more than {most} MB", most=_LARGEST_DRAWING >> 20))
    try:
        drawn = draw_svg(content, side)
    except ValueError as error:
        raise _refused(path, Said("is an SVG that cannot be drawn: {why}", why=error)) from error
    return _decode(path, BytesIO(drawn), tone)


def _decode(path: Path, file: BinaryIO, tone: Tone) -> Array:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # damaged metadata do no harm
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(file, formats=FORMATS) as image:
                _check_size(path, image.height, image.width)
                return _grey(path, ImageOps.exif_transpose(image), tone)
    except Refused:
        raise
    except UnidentifiedImageError as error:
        known = ", ".join((*FORMATS, "SVG", "NPY"))
        raise _refused(
            path, Said("is not an image that can be read; known: {known}", known=known)
        ) from error
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise _refused(
            path,
            Said("has too many pixels; at most {most} on a side are allowed", most=LARGEST_SIDE),
        ) from error
    except Exception as error:  # decoders raise whatever a damaged file makes them stumble over
        raise _refused(path, Said("is damaged or incomplete: {why}", why=error)) from error


def _grey(path: Path, image: Image.Image, tone: Tone) -> Array:
    if image.mode.startswith("I;16"):
        return tone.light(np.asarray(image) / 65535.0)
    if image.mode in ("I", "F"):  # 32 bits a pixel
        _check_known(path, tone)
        return np.asarray(image, dtype=np.float64)
    if image.has_transparency_data:
        image = image.convert("RGBA")
        opacity = np.asarray(image.getchannel("A")) / 255.0
        drawn = image.convert("RGB")
        is_black = (_weighted(drawn, LINEAR) * opacity).max() <= _BLACK
        is_shape = is_black and opacity.min() < opacity.max()
        return opacity if is_shape else _weighted(drawn, tone) * opacity
    if image.mode in ("1", "L"):
        return _light_of(np.asarray(image.convert("L")), tone)
    return _weighted(image.convert("RGB"), tone)


def _weighted(image: Image.Image, tone: Tone) -> Array:
    # Channel by channel: three of them as floats take eight times the memory of the picture.
    grey = np.zeros((image.height, image.width))
    for channel, weight in zip(image.split(), _RED_GREEN_BLUE, strict=True):
        grey += weight * _light_of(np.asarray(channel), tone)
    return grey


def _light_of(stored: npt.NDArray[np.uint8], tone: Tone) -> Array:
    return tone.light(np.arange(256) / 255.0)[stored]
