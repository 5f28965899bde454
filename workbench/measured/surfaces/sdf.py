"""Surface data files (.sdf) by ISO 25178-71: aISO-1.0 as text, bISO-1.0 in binary.

Profiles follow each other in the direction of +y, and points in that of +x. All lengths are in
metres. The older names aBCR-1.0 and bBCR-1.0 have the same content.
"""

import numpy as np

from workbench.measured.surfaces.points import MeasuredSurface, checked_size, surface_of_grid
from workbench.measured.text import count, lines_of, number
from workbench.messages import Message

_HEADER = np.dtype(
    [
        ("version", "S8"),
        ("manufacturer", "S10"),
        ("created", "S12"),
        ("modified", "S12"),
        ("numpoints", "<u2"),
        ("numprofiles", "<u2"),
        ("xscale", "<f8"),
        ("yscale", "<f8"),
        ("zscale", "<f8"),
        ("zresolution", "<f8"),
        ("compression", "u1"),
        ("datatype", "u1"),
        ("checktype", "u1"),
    ]
)
_TYPES = ("u1", "<u2", "<u4", "<f4", "i1", "<i2", "<i4", "<f8")
_MOST = (1 << 16) - 1


def read_sdf(content: bytes) -> MeasuredSurface:
    """Read a surface data file; raise ValueError if it is invalid."""
    match content[:8]:
        case b"aISO-1.0" | b"aBCR-1.0":
            return _text(content)
        case b"bISO-1.0" | b"bBCR-1.0":
            return _binary(content)
    raise ValueError(Message("it begins neither with aISO-1.0 nor with bISO-1.0"))


def _binary(content: bytes) -> MeasuredSurface:
    if len(content) < _HEADER.itemsize:
        raise ValueError(Message("it is cut off within {part}", part=Message("its header")))
    header = np.frombuffer(content, _HEADER, 1)[0]
    columns, rows = checked_size(int(header["numpoints"]), int(header["numprofiles"]))
    if header["compression"]:
        raise ValueError(Message("it is compressed; save it without compression"))
    if header["datatype"] >= len(_TYPES):
        raise ValueError(
            Message("its DataType is {found}; 0 to 7 are known", found=int(header["datatype"]))
        )
    kind = np.dtype(_TYPES[header["datatype"]])
    size = columns * rows * kind.itemsize
    begin = _HEADER.itemsize
    if len(content) == begin + 8 + size:  # 8 bytes more in the header, as Olympus writes it
        begin += 8
    if len(content) < begin + size:
        raise ValueError(Message("it is cut off"))
    stored = np.frombuffer(content, kind, columns * rows, begin)
    heights = stored.astype(np.float64)
    # Points without a height have the least or the largest number of their type.
    if kind.kind == "f":
        heights[np.abs(stored) >= np.finfo(kind).max] = np.nan
    elif kind.itemsize > 1:
        limits = np.iinfo(kind)
        heights[stored == (limits.min if kind.kind == "i" else limits.max)] = np.nan
    scales = [float(header[name]) for name in ("xscale", "yscale", "zscale")]
    return _surface(heights, columns, rows, scales)


def _text(content: bytes) -> MeasuredSurface:
    lines = lines_of(content)
    ends = [k for k, line in enumerate(lines) if line == "*"]
    if not ends:
        raise ValueError(Message("it has no line * behind its header"))
    header = {
        name.strip().lower(): value.strip()
        for name, _, value in (line.partition("=") for line in lines[1 : ends[0]])
    }
    names = ("numpoints", "numprofiles", "xscale", "yscale", "zscale")
    if missing := [name for name in names if name not in header]:
        raise ValueError(Message("its header has no {name}", name=missing[0]))
    columns, rows = checked_size(*(count(header[name], 1, _MOST) for name in names[:2]))
    last = ends[1] if len(ends) > 1 else len(lines)
    words = " ".join(lines[ends[0] + 1 : last]).split()
    if len(words) != columns * rows:
        raise ValueError(
            Message(
                "it has {found} heights; {columns} × {rows} are needed",
                found=len(words),
                columns=columns,
                rows=rows,
            )
        )
    heights = np.array(
        [np.nan if word.upper() in ("BAD", "NAN") else number(word) for word in words]
    )
    markers = {"5": -(2.0**15), "6": -(2.0**31)}
    heights[heights == markers.get(header.get("datatype", ""), np.nan)] = np.nan
    return _surface(heights, columns, rows, [number(header[name]) for name in names[2:]])


def _surface(
    heights: np.typing.NDArray[np.float64], columns: int, rows: int, scales: list[float]
) -> MeasuredSurface:
    if not all(np.isfinite(scale) and scale > 0 for scale in scales):
        raise ValueError(Message("its Xscale, Yscale and Zscale are not all greater than 0"))
    along, up, high = scales
    grid = heights.reshape(rows, columns) * high
    return surface_of_grid(along * np.arange(columns), up * np.arange(rows), grid, "m")
