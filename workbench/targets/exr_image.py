"""Reads light from OpenEXR."""

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.said import Said
from workbench.targets.colour import REC_709, luminance_weights
from workbench.targets.picture import Picture, UnusablePicture, check_size, gathered

_MAGIC = b"\x76\x2f\x31\x01"
_SQUARE = 1e-3  # pixels are, if their aspect is 1 up to this


def is_exr(beginning: bytes) -> bool:
    """Whether a file that begins like this is OpenEXR."""
    return beginning.startswith(_MAGIC)


def read_exr(content: bytes) -> Picture:
    """Read the luminance of the first part: of R, G and B, of Y, or of its only channel.

    Parameters
    ----------
    content : bytes
        The file.

    Raises
    ------
    UnusablePicture
        If it is damaged, too large, or has other channels.
    """
    import OpenEXR  # late: few pictures need it

    # The library reads files alone.
    with tempfile.TemporaryDirectory(prefix="freeform-") as folder:
        path = Path(folder) / "picture.exr"
        path.write_bytes(content)
        try:
            with OpenEXR.File(str(path), separate_channels=True, header_only=True) as file:
                header = dict(file.header())
                names = [channel.name for channel in header["channels"]]
            if "deep" in str(header.get("type", "")):
                raise UnusablePicture(Said("is a deep EXR; a flat one is needed"))
            (left, top), (right, bottom) = np.asarray(header["displayWindow"], dtype=int)
            rows, columns = int(bottom - top + 1), int(right - left + 1)
            check_size(rows, columns)
            first, last = np.asarray(header["dataWindow"], dtype=int)
            check_size(int(last[1] - first[1] + 1), int(last[0] - first[0] + 1))
            chosen = _chosen(names)
            with OpenEXR.File(str(path), separate_channels=True) as file:
                channels = file.channels()
                pixels = [np.asarray(channels[name].pixels) for name in chosen]
        except UnusablePicture:
            raise
        except Exception as error:  # whatever a damaged file makes the library stumble over
            raise UnusablePicture(Said("is damaged or incomplete: {why}", why=error)) from error
    height, width = pixels[0].shape
    weights = np.ones(1) if len(pixels) == 1 else _weights(header)
    first_row, first_column = int(first[1] - top), int(first[0] - left)

    def light_of(begin: int, end: int) -> Array:
        """Rows of what is to be displayed; black where there are no data."""
        light = np.zeros((end - begin, columns))
        low, high = max(begin, first_row), min(end, first_row + height)
        left, right = max(0, first_column), min(columns, first_column + width)
        if low < high and left < right:
            part = np.s_[
                low - first_row : high - first_row, left - first_column : right - first_column
            ]
            light[low - begin : high - begin, left:right] = sum(
                weight * channel[part].astype(np.float64)
                for weight, channel in zip(weights, pixels, strict=True)
            )
        return light

    found = gathered(rows, columns, light_of)
    aspect = float(header.get("pixelAspectRatio", 1.0))
    if abs(aspect - 1) < _SQUARE:
        return found
    oblong = Said(
        "has pixels {aspect:.3g} times as wide as high; they count as squares", aspect=aspect
    )
    return found._replace(remarks=(*found.remarks, oblong))


def _chosen(names: list[str]) -> list[str]:
    """Channels that hold the picture."""
    layers = [name[:-1] for name in names if name.endswith("R")]
    colours = [[f"{layer}{colour}" for colour in "RGB"] for layer in sorted(layers, key=len)]
    for three in colours:
        if set(three) <= set(names):
            return three
    for only in (["Y"], names if len(names) == 1 else []):
        if only and set(only) <= set(names):
            return only
    raise UnusablePicture(
        Said("has the channels {names}; R, G and B, or Y, are needed", names=", ".join(names))
    )


def _weights(header: Mapping[str, Any]) -> Array:
    """Luminance of red, green and blue: those of Rec. 709 unless the file has others."""
    stated = header.get("chromaticities")
    if stated is None:
        return REC_709
    red, green, blue, white = np.asarray(stated, dtype=np.float64).reshape(4, 2).tolist()
    try:
        return luminance_weights([red, green, blue], white)
    except (ValueError, np.linalg.LinAlgError) as error:
        raise UnusablePicture(Said("has chromaticities that are no colours")) from error
