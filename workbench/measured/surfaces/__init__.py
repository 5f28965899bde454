"""Measured surfaces: points, grids of heights, meshes and pictures of heights."""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import PurePath
from typing import BinaryIO

from workbench.errors import Refused
from workbench.measured.surfaces.esri import is_esri, read_esri
from workbench.measured.surfaces.picture import PictureScale, read_picture
from workbench.measured.surfaces.points import MeasuredSurface
from workbench.measured.surfaces.sdf import read_sdf
from workbench.measured.surfaces.stl import read_stl
from workbench.measured.surfaces.table import read_table
from workbench.measured.surfaces.x3p import read_x3p
from workbench.measured.text import read_whole
from workbench.messages import Message

__all__ = ["ENDINGS", "UNITS", "MeasuredSurface", "PictureScale", "read_surface"]


def _read_asc(content: bytes) -> MeasuredSurface:
    return (read_esri if is_esri(content) else read_table)(content)


_PICTURES = (".png", ".tif", ".tiff")
_READERS: Mapping[str, Callable[[bytes], MeasuredSurface]] = {
    **dict.fromkeys((".xyz", ".txt", ".csv", ".pts"), read_table),
    ".asc": _read_asc,
    ".sdf": read_sdf,
    ".x3p": read_x3p,
    ".stl": read_stl,
}
ENDINGS = (*_READERS, *_PICTURES)
UNITS = ("mm", "cm", "m", "inch", "um", "nm")
"""Units that a measurement may have."""
_LARGEST = 1 << 30  # bytes


def read_surface(
    name: PurePath, file: BinaryIO, scale: PictureScale | None = None
) -> MeasuredSurface:
    """Read a measured surface; the ending of ``name`` selects the format.

    ``scale`` is that of pictures. Raise Refused, with ``name``, if the format is unknown or the
    content unusable.
    """
    ending = name.suffix.lower()
    reader = partial(read_picture, scale=scale) if ending in _PICTURES else _READERS.get(ending)
    if reader is None:
        raise Refused(
            str(name),
            Message("is no measured surface; {endings} are known", endings=", ".join(ENDINGS)),
        )
    return read_whole(name, file, reader, _LARGEST)
