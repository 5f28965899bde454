"""Image files in formats of pillow."""

import struct
import warnings
from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any, BinaryIO

import numpy as np
from PIL import Image, UnidentifiedImageError

from workbench.arrays import Array
from workbench.messages import Message
from workbench.targets.colour import LINEAR, NUMBERS, Colour, Tone, grey_of_lab
from workbench.targets.picture import MOST_PIXELS, Picture, UnusablePicture, check_size, gathered

# Named one by one because pillow knows formats that start other programs (EPS: Ghostscript).
_OF_PILLOW = ("PNG", "JPEG", "TIFF", "BMP", "GIF", "WEBP", "PPM", "JPEG2000", "TGA", "AVIF")
FORMATS = (*_OF_PILLOW, "HEIF")
"""Image formats by pillow's names."""

# Largest value of black: rounding of transparent edges reaches it.
_BLACK = 2 / 255
_ORIENTATION = 0x0112  # of EXIF and TIFF
_PHOTOMETRIC, _WHITE_IS_ZERO, _BLACK_IS_ZERO = 262, 0, 1

# Pillow refuses a file with twice as many pixels; the size is checked here as well.
Image.MAX_IMAGE_PIXELS = MOST_PIXELS // 2


def read_raster(file: BinaryIO, tone: Tone, known: Sequence[str]) -> Picture:
    """Read a picture; ``known`` lists the formats for messages.

    ``tone`` converts stored values if the file does not define it. Raise UnusablePicture if the
    file is no picture, damaged or too large.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # damaged metadata do no harm
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            return _read(file, tone)
    except UnusablePicture:
        raise
    except UnidentifiedImageError as error:
        raise UnusablePicture(
            Message("is not an image that can be read; known: {known}", known=", ".join(known))
        ) from error
    except Image.DecompressionBombError as error:
        raise UnusablePicture(
            Message("has too many pixels; at most {most} million", most=MOST_PIXELS // 10**6)
        ) from error
    except Exception as error:  # damaged files raise any exception in decoders
        raise UnusablePicture(Message("is damaged or incomplete: {why}", why=error)) from error


def _read(file: BinaryIO, tone: Tone) -> Picture:
    beginning = file.read(12)
    formats: tuple[str, ...] = _OF_PILLOW
    file.seek(0)
    if beginning[4:8] == b"ftyp":
        from pillow_heif import register_heif_opener  # few pictures need it

        register_heif_opener()
        formats = FORMATS
    try:
        image = Image.open(file, formats=formats)
    except UnidentifiedImageError:
        # Pillow knows 16 bits a pixel only where black is zero.
        turned = _with_black_as_zero(beginning, file)
        if turned is None:
            raise
        with Image.open(turned, formats=formats) as image:
            return _light(image, tone, is_negative=True)
    with image:
        # Pillow turns 8 bits a pixel round, but not more.
        tags = getattr(image, "tag_v2", {})
        is_deep = image.mode.startswith(("I", "F"))
        return _light(image, tone, is_deep and tags.get(_PHOTOMETRIC) == _WHITE_IS_ZERO)


def _light(image: Image.Image, tone: Tone, is_negative: bool) -> Picture:
    check_size(image.height, image.width)
    image.load()  # applies the orientation of a TIFF and may change its size
    light_of, meant, remarks = _reader(image, tone, is_negative)
    found = gathered(
        image.height, image.width, lambda top, end: light_of(image.crop((0, top, image.width, end)))
    )
    if image.format != "MPO" and (frames := getattr(image, "n_frames", 1)) > 1:
        remarks.append(Message("has {frames} frames or pages; the first one counts", frames=frames))
    return Picture(
        _upright(found.light, image.getexif().get(_ORIENTATION, 1)),
        meant,
        (*remarks, *found.remarks),
    )


def _reader(image: Image.Image, tone: Tone, is_negative: bool) -> tuple[Any, Tone, list[Message]]:
    # Pillow reads 16 bits of a PGM as 32, from 0 to 65535.
    is_deep = image.mode.startswith("I;16") or (image.mode == "I" and image.format == "PPM")
    if image.mode in ("I", "F") and not is_deep:  # 32 bits a pixel
        if is_negative:
            raise UnusablePicture(
                Message("has 32 bits a pixel with zero as white; save it with zero as black")
            )
        return lambda strip: np.asarray(strip, dtype=np.float64), NUMBERS, []
    if image.mode == "LAB":
        return lambda strip: grey_of_lab(np.asarray(strip.getchannel("L"))), tone, []
    colour = Colour.of(image, tone)
    remarks = [*colour.remarks]
    if is_deep:

        def deep(strip: Image.Image) -> Array:
            stored = np.asarray(strip) / 65535.0
            return colour.tone.light(1.0 - stored if is_negative else stored)

        return deep, colour.tone, remarks
    if is_negative:
        raise UnusablePicture(Message("has zero as white; save it with zero as black"))
    if image.has_transparency_data:
        return _over_black(image, colour), colour.tone, remarks
    return colour.light, colour.tone, remarks


def _over_black(image: Image.Image, colour: Colour) -> Any:
    plain = Colour.plain(LINEAR)
    brightest, least, most = 0.0, 1.0, 0.0
    # In strips: a large picture as floats fills the memory.
    step = max(1, (1 << 22) // image.width)
    for top in range(0, image.height, step):
        strip = image.crop((0, top, image.width, min(top + step, image.height))).convert("RGBA")
        opacity = np.asarray(strip.getchannel("A")) / 255.0
        brightest = max(brightest, float((plain.light(strip.convert("RGB")) * opacity).max()))
        least, most = min(least, float(opacity.min())), max(most, float(opacity.max()))
    is_shape = brightest <= _BLACK and least < most

    def light_of(strip: Image.Image) -> Array:
        strip = strip.convert("RGBA")
        opacity: Array = np.asarray(strip.getchannel("A")) / 255.0
        return opacity if is_shape else colour.light(strip.convert("RGB")) * opacity

    return light_of


def _upright(light: Array, orientation: int) -> Array:
    turns = {3: 2, 6: -1, 8: 1}
    if orientation in turns:
        return np.rot90(light, turns[orientation])
    mirrored: dict[int, Callable[[Array], Array]] = {
        2: np.fliplr,
        4: np.flipud,
        5: np.transpose,
        7: lambda stored: np.rot90(stored, 2).T,
    }
    return mirrored[orientation](light) if orientation in mirrored else light


def _with_black_as_zero(beginning: bytes, file: BinaryIO) -> BytesIO | None:
    order = {b"II*\0": "<", b"MM\0*": ">"}.get(beginning[:4])
    if order is None:
        return None
    file.seek(0)
    content = bytearray(file.read())
    try:
        (place,) = struct.unpack_from(f"{order}I", content, 4)
        (count,) = struct.unpack_from(f"{order}H", content, place)
        for entry in range(place + 2, place + 2 + 12 * count, 12):
            tag, _, _, value = struct.unpack_from(f"{order}HHIH", content, entry)
            if (tag, value) == (_PHOTOMETRIC, _WHITE_IS_ZERO):
                struct.pack_into(f"{order}H", content, entry + 8, _BLACK_IS_ZERO)
                return BytesIO(content)
    except struct.error:  # it is cut off
        pass
    return None
