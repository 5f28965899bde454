"""Pictures in numbers: the height of the exit face, the light on the receiver.

Rows run from +y down and columns from −x on, as in image files.
"""

import io
from typing import Any, BinaryIO, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.tables import rounding, write_table
from workbench.files.npy import write_array
from workbench.scene.fields import ANGLE

_DEEPEST = 65535
_DESCRIPTION = 270  # TIFF tag


class Map(NamedTuple):
    """Values on a grid.

    Attributes
    ----------
    name, unit : str
        What they are.
    x : ndarray, shape (n_x,)
        Of the columns, ascending; in ``length``.
    y : ndarray, shape (n_y,)
        Of the rows, descending.
    length : str
        Unit of x and y.
    values : ndarray, shape (n_y, n_x)
        NaN where there is nothing.
    axes : tuple[str, str]
        Names of x and y.
    """

    name: str
    unit: str
    x: Array
    y: Array
    length: str
    values: Array
    axes: tuple[str, str] = ("x", "y")


def height(design: Design) -> Map:
    """Height z of the exit face, rim included; beside an elliptic lens there is no number."""
    x, y = design.lattice()
    z = design.surface(x, y)[0]
    z[~design.outline.contains(x[:, None], y)] = np.nan
    return Map("height", design.unit, x, y[::-1], design.unit, z[:, ::-1].T)


def irradiance(design: Design) -> Map:
    """Density of light at the middle of each pixel, as the design run saw it at its end."""
    design.scene.check_one_image("exports of light")
    receiver = design.scene.receiver
    places = zip(receiver.pixels, receiver.half_extent, receiver.middle, strict=True)
    u, v = (middle + ((np.arange(n) + 0.5) / n * 2 - 1) * r for n, r, middle in places)
    values, unit = design.result.state.irradiance, receiver.measure.words_in(design.unit)
    density = receiver.density_unit(design.unit)
    return Map(receiver.density, density, u, v[::-1], unit, values, receiver.axes)


def write_png(shown: Map, file: BinaryIO) -> Deviation:
    """Write 16-bit grey values; the text in the file tells what black and white stand for.

    Where there is nothing, values are black, too, which the text says.
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
    """Write single-precision values; the description tells unit and extent."""
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
    """Write a line x, y, value per point, along the rows; none where there is nothing."""
    there = np.isfinite(shown.values)
    columns = [c[there] for c in np.broadcast_arrays(shown.x, shown.y[:, None], shown.values)]
    length, (x, y) = shown.length, shown.axes
    header = f"{x} [{length}],{y} [{length}],{shown.name} [{shown.unit}]"
    written = write_table(file, columns, header, delimiter=",")
    return Deviation("rounding", rounding(written, 2, columns[2]), shown.unit)


def _extent(shown: Map) -> dict[str, str | float]:
    """Unit of the values, and where the middle of the first and last columns and rows are."""
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
    """How far values of a file are from those shown."""
    return Deviation("rounding", float(np.nanmax(np.abs(found - shown.values))), shown.unit)
