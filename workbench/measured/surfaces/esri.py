"""Grids of heights by ESRI ASCII (.asc): a header of key words, then rows from +y down."""

import numpy as np

from workbench.measured.surfaces.points import MeasuredSurface, checked_size, surface_of_grid
from workbench.measured.text import count, lines_of, number
from workbench.messages import Message

_NEEDED = ("ncols", "nrows")


def is_esri(content: bytes) -> bool:
    """Whether a file begins like a grid by ESRI, not like a list of points."""
    return content[:64].lstrip(b"\xef\xbb\xbf \t\r\n").lower().startswith(b"ncols")


def read_esri(content: bytes) -> MeasuredSurface:
    """Read a grid; raise ValueError if it is invalid."""
    lines = lines_of(content)
    header: dict[str, str] = {}
    for line in lines:
        words = line.split()
        if len(words) != 2 or not words[0][0].isalpha():
            break
        header[words[0].lower()] = words[1]
    size = [header.get(name) for name in _NEEDED]
    steps = [header.get(name, header.get("cellsize")) for name in ("dx", "dy")]
    if None in size or None in steps:
        raise ValueError(Message("its header has no ncols, nrows and cellsize"))
    columns, rows = checked_size(*(count(word or "", 1, 1 << 24) for word in size))
    along, up = (number(word or "") for word in steps)
    words = " ".join(lines[len(header) :]).replace(",", ".").split()
    if len(words) != columns * rows:
        raise ValueError(
            Message(
                "it has {found} heights; {columns} × {rows} are needed",
                found=len(words),
                columns=columns,
                rows=rows,
            )
        )
    heights = np.array([number(word) for word in words]).reshape(rows, columns)
    heights[heights == number(header.get("nodata_value", "-9999"))] = np.nan
    left, low = (
        number(header[f"{axis}llcenter"])
        if f"{axis}llcenter" in header
        else number(header.get(f"{axis}llcorner", "0")) + step / 2
        for axis, step in (("x", along), ("y", up))
    )
    x, y = left + along * np.arange(columns), low + up * np.arange(rows)[::-1]
    return surface_of_grid(x, y, heights)
