"""Irradiance as OpenEXR: one channel, luminance, in uncompressed lines.

The layout is that of the "OpenEXR File Layout" document, for files of a single part.
"""

import struct
from typing import BinaryIO

import numpy as np

from workbench.files.export.design import Design, Deviation
from workbench.files.export.maps import Map, described, irradiance, rounding_of

_MAGIC, _VERSION = 20000630, 2
_FLOAT = 2  # type of a channel


def write_exr(design: Design, file: BinaryIO) -> Deviation:
    """Write the irradiance in single precision; the comments tell unit and extent."""
    shown = irradiance(design)
    values = shown.values.astype("<f4")
    rows, columns = values.shape
    window = struct.pack("<4i", 0, 0, columns - 1, rows - 1)
    # Name, type, then: is it perceptual, three bytes of nothing, sampling along x and y.
    channels = b"Y\0" + struct.pack("<iB3x2i", _FLOAT, 0, 1, 1) + b"\0"
    header = struct.pack("<2i", _MAGIC, _VERSION) + b"".join(
        _attribute(name, kind, content)
        for name, kind, content in (
            ("channels", "chlist", channels),
            ("comments", "string", described(shown).encode()),
            ("compression", "compression", b"\0"),
            ("dataWindow", "box2i", window),
            ("displayWindow", "box2i", window),
            ("lineOrder", "lineOrder", b"\0"),  # from the top
            ("pixelAspectRatio", "float", struct.pack("<f", _aspect(shown))),
            ("screenWindowCenter", "v2f", struct.pack("<2f", 0.0, 0.0)),
            ("screenWindowWidth", "float", struct.pack("<f", 1.0)),
        )
    )
    line = np.dtype([("y", "<i4"), ("size", "<i4"), ("values", "<f4", columns)])
    lines = np.empty(rows, dtype=line)
    lines["y"], lines["size"], lines["values"] = np.arange(rows), 4 * columns, values
    first = len(header) + 1 + 8 * rows
    file.write(header + b"\0")
    file.write((first + line.itemsize * np.arange(rows)).astype("<u8").tobytes())
    file.write(lines.tobytes())
    return rounding_of(shown, values)


def _attribute(name: str, kind: str, content: bytes) -> bytes:
    return f"{name}\0{kind}\0".encode() + struct.pack("<i", len(content)) + content


def _aspect(shown: Map) -> float:
    """Width over height of a pixel."""
    steps = [abs(float(c[-1] - c[0])) / max(len(c) - 1, 1) for c in (shown.x, shown.y)]
    return steps[0] / steps[1] if min(steps) > 0 else 1.0
