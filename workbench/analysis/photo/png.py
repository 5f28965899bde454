"""Predicted photos as PNG."""

from typing import BinaryIO

from PIL import Image

from workbench.analysis.photo.photo import Photo


def write_png(photo: Photo, stops: float, file: BinaryIO) -> None:
    """Write a photo in sRGB, one pixel for each of the receiver.

    Pixels of a file are square: where those of the receiver are not, the photo is made as wide or
    as high as it takes, with values between those of the pixels.

    `stops`: exposure; see `Photo.picture`.
    """
    image = Image.fromarray(photo.picture(stops))
    width, height = image.size
    wanted = round(width * max(photo.aspect, 1.0)), round(height * max(1 / photo.aspect, 1.0))
    if wanted != image.size:
        image = image.resize(wanted, Image.Resampling.BILINEAR)
    image.save(file, "PNG")
