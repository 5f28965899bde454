"""Light of an image file, size limits, and reading in strips."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.messages import Message
from workbench.targets.colour import LINEAR, Tone

LARGEST_SIDE = 8192
"""Most rows or columns; a larger picture is reduced."""
MOST_PIXELS = 2**28
"""Most pixels that are decoded; a forged header must not fill the memory."""

# Pixels of a strip of rows: its light in float64 takes 32 MB for each channel.
_STRIP = 1 << 22


class Picture(NamedTuple):
    """Light (rows, columns) of an image file, finite and >= 0, row 0 at the top.

    ``tone`` is that of the scene, or of the file if it defines one. Each remark continues a
    sentence that begins with the name of the file.
    """

    light: Array
    tone: Tone = LINEAR
    remarks: tuple[Message, ...] = ()


class UnusablePicture(Exception):
    """Content that is no usable picture; the reason continues a sentence after the file name."""

    def __init__(self, reason: Message) -> None:
        super().__init__(reason)
        self.reason = reason


def check_size(rows: int, columns: int) -> None:
    """Raise UnusablePicture for a picture without pixels or with more than `MOST_PIXELS`."""
    size = {"columns": columns, "rows": rows}
    if min(rows, columns) < 1:
        raise UnusablePicture(
            Message("has {columns} × {rows} pixels; at least one is needed", **size)
        )
    if rows * columns > MOST_PIXELS:
        raise UnusablePicture(
            Message(
                "has {columns} × {rows} pixels; at most {most} million are allowed",
                most=MOST_PIXELS // 10**6,
                **size,
            )
        )


def gathered(rows: int, columns: int, light_of: Callable[[int, int], Array]) -> Picture:
    """Read light in strips; reduce the picture if a side is larger than `LARGEST_SIDE`.

    ``light_of`` returns the light of the rows from one up to another. Raise UnusablePicture for
    values that are negative, NaN or infinite.
    """
    factor = -(-max(rows, columns) // LARGEST_SIDE)
    step = factor * max(1, _STRIP // (factor * columns))
    light = np.empty((-(-rows // factor), -(-columns // factor)))
    for top in range(0, rows, step):
        strip = light_of(top, min(top + step, rows))
        _check_values(strip)
        light[top // factor : (top + step) // factor] = _block_means(strip, factor)
    if factor == 1:
        return Picture(light)
    reduced = Message(
        "has {columns} × {rows} pixels and is reduced to {less_columns} × {less_rows}",
        columns=columns,
        rows=rows,
        less_columns=light.shape[1],
        less_rows=light.shape[0],
    )
    return Picture(light, remarks=(reduced,))


def _check_values(light: Array) -> None:
    if not np.isfinite(light).all():
        raise UnusablePicture(
            Message("holds a value that is NaN or infinite; finite values are needed")
        )
    if light.min() < 0:
        raise UnusablePicture(
            Message("holds {least:g}; values of at least 0 are needed", least=light.min())
        )


def _block_means(light: Array, factor: int) -> Array:
    if factor == 1:
        return light
    starts = [np.arange(0, size, factor) for size in light.shape]
    sums = np.add.reduceat(np.add.reduceat(light, starts[0], axis=0), starts[1], axis=1)
    down, across = (
        np.diff(start, append=size) for start, size in zip(starts, light.shape, strict=True)
    )
    means: Array = sums / np.outer(down, across)
    return means
