"""Maps as numbers: height of a face, irradiance of the receiver.

Rows run from +y down and columns from −x on, as in image files.
"""

import io
import struct
from typing import Any, BinaryIO, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from workbench.arrays import Array
from workbench.files.entries import write_array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import rounding, write_table
from workbench.scene.fields import ANGLE

_DEEPEST = 65535
_DESCRIPTION = 270  # TIFF tag
_MAGIC, _VERSION = 20000630, 2
_FLOAT = 2  # type of a channel


class Map(NamedTuple):
    """Values (n_y, n_x) on a grid, NaN where there are none.

    ``x`` (n_x,) ascends, ``y`` (n_y,) descends; ``length`` is their unit, ``axes`` their names.
    """

    name: str
    unit: str
    x: Array
    y: Array
    length: str
    values: Array
    axes: tuple[str, str] = ("x", "y")


def height(design: Design) -> Map:
    """Height z of a face, rim included; NaN outside the outline."""
    x, y = design.lattice()
    z = design.surface(x, y)[0]
    z[~design.outline.contains(x[:, None], y)] = np.nan
    return Map("height", design.unit, x, y[::-1], design.unit, z[:, ::-1].T)


def irradiance(design: Design) -> Map:
    """Irradiance or intensity at the middle of each pixel, from the end of the design run."""
    design.scene.check_one_image("exports of light")
    receiver = design.scene.receiver
    places = zip(receiver.pixels, receiver.half_extent, receiver.middle, strict=True)
    u, v = (middle + ((np.arange(n) + 0.5) / n * 2 - 1) * r for n, r, middle in places)
    values, unit = design.result.state.irradiance, receiver.measure.words_in(design.unit)
    density = receiver.density_unit(design.unit)
    return Map(receiver.density, density, u, v[::-1], unit, values, receiver.axes)


def write_png(shown: Map, file: BinaryIO) -> Deviation:
    """Write 16-bit grey values; text in the file gives the values of black and white.

    Missing values are black, as the text says.
    """
    low, high = float(np.nanmin(shown.values)), float(np.nanmax(shown.values))
    step = (high - low) / _DEEPEST
    grey = np.zeros(shown.values.shape, dtype=np.uint16)
    if step > 0:
        grey[:] = np.rint((np.nan_to_num(shown.values, nan=low) - low) / step)
    text = PngInfo()
    notes = {"Black": low, "White": high, **_extent(shown)}
    if np.isnan(shown.values).any():
        notes["Beside the lens"] = "black"
    for key, value in notes.items():
        text.add_text(key, str(value))
    with io.BytesIO() as png:
        Image.fromarray(grey).save(png, "PNG", pnginfo=text)
        file.write(png.getbuffer())
        with Image.open(png) as again:
            found = low + np.asarray(again, dtype=np.float64) * step
    return rounding_of(shown, found)


def write_tiff(shown: Map, file: BinaryIO) -> Deviation:
    """Write single-precision values; the description gives unit and extent."""
    with io.BytesIO() as tiff:
        image = Image.fromarray(shown.values.astype(np.float32))
        image.save(tiff, "TIFF", tiffinfo={_DESCRIPTION: described(shown)})
        file.write(tiff.getbuffer())
        with Image.open(tiff) as again:
            found = np.asarray(again, dtype=np.float64)
    return rounding_of(shown, found)


def write_npy(shown: Map, file: BinaryIO) -> Deviation:
    """Write a numpy array of float64."""
    with io.BytesIO() as npy:
        write_array(npy, shown.values)
        file.write(npy.getbuffer())
        npy.seek(0)
        found = np.load(npy)
    return rounding_of(shown, found)


def write_csv(shown: Map, file: BinaryIO) -> Deviation:
    """Write a line x, y, value per point, along the rows; missing values have no line."""
    there = np.isfinite(shown.values)
    columns = [c[there] for c in np.broadcast_arrays(shown.x, shown.y[:, None], shown.values)]
    length, (x, y) = shown.length, shown.axes
    header = f"{x} [{length}],{y} [{length}],{shown.name} [{shown.unit}]"
    written = write_table(file, columns, header, delimiter=",")
    return Deviation("rounding", rounding(written, 2, columns[2]), shown.unit)


def _extent(shown: Map) -> dict[str, str | float]:
    x, y = shown.axes
    angle = shown.length == ANGLE.words
    return {
        "Quantity": shown.name,
        "Unit": shown.unit,
        "Angle unit" if angle else "Length unit": shown.length,
        f"{x} of first column": float(shown.x[0]),
        f"{x} of last column": float(shown.x[-1]),
        f"{y} of first row": float(shown.y[0]),
        f"{y} of last row": float(shown.y[-1]),
    }


def described(shown: Map) -> str:
    """Unit and extent in a line of text."""
    return ", ".join(f"{key} {value}" for key, value in _extent(shown).items())


def rounding_of(shown: Map, found: npt.NDArray[Any]) -> Deviation:
    """Deviation of values of a file from a map."""
    return Deviation("rounding", float(np.nanmax(np.abs(found - shown.values))), shown.unit)


def write_exr(design: Design, file: BinaryIO) -> Deviation:
    """Write the irradiance as OpenEXR in single precision; comments give unit and extent.

    One channel, luminance, in uncompressed lines, by the "OpenEXR File Layout" document for files
    of a single part.
    """
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
    steps = [abs(float(c[-1] - c[0])) / max(len(c) - 1, 1) for c in (shown.x, shown.y)]
    return steps[0] / steps[1] if min(steps) > 0 else 1.0
