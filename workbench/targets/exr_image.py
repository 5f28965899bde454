"""OpenEXR files."""

import json
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.messages import Message
from workbench.targets import exr_reader
from workbench.targets.colour import REC_709, luminance_weights
from workbench.targets.picture import MOST_PIXELS, Picture, UnusablePicture, check_size, gathered

_MAGIC = b"\x76\x2f\x31\x01"
_SQUARE = 1e-3  # tolerance of the aspect of square pixels
_TIME_LIMIT_S = 120.0


def is_exr(beginning: bytes) -> bool:
    """Whether a file with this beginning is OpenEXR."""
    return beginning.startswith(_MAGIC)


def read_exr(content: bytes) -> Picture:
    """Read the luminance of the first part: of R, G and B, of Y, or of the only channel.

    Raise UnusablePicture if it is damaged, too large, or has other channels.
    """
    with tempfile.TemporaryDirectory(prefix="freeform-") as name:
        folder = Path(name)
        (folder / "picture.exr").write_bytes(content)
        header = _unpacked(folder)
        names = exr_reader.chosen(header["names"])
        pixels = [np.load(folder / f"{number}.npy") for number in range(len(names))]
    (left, top), (right, bottom) = header["displayWindow"]
    (first_column, first_row), _ = header["dataWindow"]
    corner = first_row - top, first_column - left
    weights = np.ones(1) if len(pixels) == 1 else _weights(header["chromaticities"])
    found = _displayed(pixels, weights, corner, (bottom - top + 1, right - left + 1))
    if abs(header["aspect"] - 1) < _SQUARE:
        return found
    oblong = Message(
        "has pixels {aspect:.3g} times as wide as high; they count as squares",
        aspect=header["aspect"],
    )
    return found._replace(remarks=(*found.remarks, oblong))


def _unpacked(folder: Path) -> Mapping[str, Any]:
    command = [
        sys.executable,
        "-I",
        exr_reader.__file__,
        str(folder / "picture.exr"),
        str(MOST_PIXELS),
    ]
    try:
        done = subprocess.run(command, capture_output=True, timeout=_TIME_LIMIT_S, check=False)
        header: Mapping[str, Any] = json.loads((folder / exr_reader.HEADER).read_text("utf-8"))
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        raise UnusablePicture(Message("is damaged or incomplete")) from error
    for (left, top), (right, bottom) in (header["displayWindow"], header["dataWindow"]):
        check_size(bottom - top + 1, right - left + 1)
    if header["deep"]:
        raise UnusablePicture(Message("is a deep EXR; a flat one is needed"))
    if not exr_reader.chosen(header["names"]):
        names = ", ".join(header["names"])
        raise UnusablePicture(
            Message("has the channels {names}; R, G and B, or Y, are needed", names=names)
        )
    if done.returncode:
        raise UnusablePicture(Message("is damaged or incomplete"))
    return header


def _displayed(
    pixels: Sequence[Array], weights: Array, corner: tuple[int, int], size: tuple[int, int]
) -> Picture:
    (first_row, first_column), (rows, columns) = corner, size
    height, width = pixels[0].shape
    left, right = max(0, first_column), min(columns, first_column + width)

    def light_of(begin: int, end: int) -> Array:
        light = np.zeros((end - begin, columns))
        low, high = max(begin, first_row), min(end, first_row + height)
        if low < high and left < right:
            inside = light[low - begin : high - begin, left:right]
            down = slice(low - first_row, high - first_row)
            across = slice(left - first_column, right - first_column)
            for weight, channel in zip(weights, pixels, strict=True):
                inside += weight * channel[down, across]
        return light

    return gathered(rows, columns, light_of)


def _weights(stated: Sequence[float] | None) -> Array:
    if stated is None:
        return REC_709
    red, green, blue, white = np.reshape(stated, (4, 2)).tolist()
    try:
        return luminance_weights([red, green, blue], white)
    except (ValueError, np.linalg.LinAlgError) as error:
        raise UnusablePicture(Message("has chromaticities that are no colours")) from error
