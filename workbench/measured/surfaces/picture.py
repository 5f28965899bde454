"""Heights as 16-bit PNG or TIFF, or as TIFF of floating-point values; row 0 at +y.

The scale is in the text of a PNG, as `freeform export` writes it for .height.png, or it is given
with the file.
"""

import io
from typing import NamedTuple

import numpy as np

from workbench.arrays import AnyArray
from workbench.measured.surfaces.points import MeasuredSurface, checked_size, surface_of_grid
from workbench.messages import Message
from workbench.units import WRITTEN

_DEEPEST = 65535


class PictureScale(NamedTuple):
    """Scale of a picture without one of its own, in the unit of the file."""

    pixel: float  # side of a pixel
    low: float = 0.0  # height of black
    high: float = 1.0  # height of white; without meaning for floating-point values


def read_picture(content: bytes, scale: PictureScale | None) -> MeasuredSurface:
    """Read a picture of heights; raise ValueError if it is invalid or has no scale."""
    from PIL import Image  # slow import

    try:
        with Image.open(io.BytesIO(content), formats=("PNG", "TIFF")) as image:
            columns, rows = checked_size(*image.size)
            mode = image.mode
            text = {name: str(value) for name, value in image.info.items()}
            heights = np.asarray(image, dtype=np.float64)
    except ValueError:
        raise
    except Exception as error:  # damaged files raise any exception in decoders
        raise ValueError(Message("it is damaged or incomplete: {why}", why=error)) from error
    if not mode.startswith(("I;16", "I", "F")):
        raise ValueError(
            Message("it has {mode} pixels; grey of 16 bits or floats are needed", mode=mode)
        )
    if "Beside the lens" in text:
        heights[heights == 0] = np.nan
    x: AnyArray
    y: AnyArray
    if scale is not None:
        low, high = scale.low, scale.high
        x, y = scale.pixel * np.arange(columns), scale.pixel * np.arange(rows)[::-1]
    else:
        try:
            low, high = float(text.get("Black", 0)), float(text.get("White", 1))
            left, right = (float(text[f"x of {end} column"]) for end in ("first", "last"))
            top, bottom = (float(text[f"y of {end} row"]) for end in ("first", "last"))
            x, y = np.linspace(left, right, columns), np.linspace(top, bottom, rows)
        except (KeyError, ValueError):
            raise ValueError(
                Message("it has no scale; give the size of a pixel and the heights")
            ) from None
    if mode != "F":
        heights = low + heights * ((high - low) / _DEEPEST)
    unit = text.get("Length unit")
    return surface_of_grid(x, y, heights, unit if unit in WRITTEN and scale is None else None)
