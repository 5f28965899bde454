"""Light of an image file, and what every reader of a format shares: limits and strips."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.said import Said
from workbench.targets.tone import LINEAR, Tone

LARGEST_SIDE = 8192
"""Most rows or columns that are kept; a larger picture is reduced."""
MOST_PIXELS = 2**28
"""Most pixels that are decoded; keeps a forged header from filling the memory."""

# Pixels of a strip of rows: its light in float64 takes 32 MB for each channel.
_STRIP = 1 << 22


class Picture(NamedTuple):
    """Light of an image file.

    Attributes
    ----------
    light : ndarray, shape (rows, columns)
        Finite values >= 0, row 0 at the top.
    tone : Tone
        What the stored values mean: that of the scene, or of the file where it says so.
    remarks : tuple of Said
        What a person should know; each continues a sentence that begins with the name of the file.
    """

    light: Array
    tone: Tone = LINEAR
    remarks: tuple[Said, ...] = ()


class UnusablePicture(Exception):
    """Content that is no usable picture.

    Parameters
    ----------
    reason : Said
        Continues a sentence that begins with the name of the file.
    """

    def __init__(self, reason: Said) -> None:
        super().__init__(reason)
        self.reason = reason


def check_size(rows: int, columns: int) -> None:
    """Refuse a picture without pixels, or with more than may be decoded.

    Raises
    ------
    UnusablePicture
        If it has none or more than `MOST_PIXELS`.
    """
    size = {"columns": columns, "rows": rows}
    if min(rows, columns) < 1:
        raise UnusablePicture(Said("has {columns} × {rows} pixels; at least one is needed", **size))
    if rows * columns > MOST_PIXELS:
        raise UnusablePicture(
            Said(
                "has {columns} × {rows} pixels; at most {most} million are allowed",
                most=MOST_PIXELS // 10**6,
                **size,
            )
        )


def gathered(rows: int, columns: int, light_of: Callable[[int, int], Array]) -> Picture:
    """Light of a picture, strip by strip; reduced where a side is larger than `LARGEST_SIDE`.

    Parameters
    ----------
    rows, columns : int
        Pixels of the file, as `check_size` allows them.
    light_of : callable
        Return the light from one row up to another one, shape (those rows, columns).

    Raises
    ------
    UnusablePicture
        If a value is negative, NaN or infinite.
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
    reduced = Said(
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
            Said("holds a value that is NaN or infinite; finite values are needed")
        )
    if light.min() < 0:
        raise UnusablePicture(
            Said("holds {least:g}; values of at least 0 are needed", least=light.min())
        )


def _block_means(light: Array, factor: int) -> Array:
    """Means of blocks of ``factor`` × ``factor`` pixels; the last ones may be smaller."""
    if factor == 1:
        return light
    starts = [np.arange(0, size, factor) for size in light.shape]
    sums = np.add.reduceat(np.add.reduceat(light, starts[0], axis=0), starts[1], axis=1)
    down, across = (
        np.diff(start, append=size) for start, size in zip(starts, light.shape, strict=True)
    )
    means: Array = sums / np.outer(down, across)
    return means
