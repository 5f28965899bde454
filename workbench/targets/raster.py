"""A picture, a raster of light, put onto the pixels of the receiver."""

from typing import Literal

import numpy as np
from scipy.sparse import csr_array

from workbench.arrays import Array
from workbench.scene import AnyReceiver


def put(
    picture: Array,
    receiver: AnyReceiver,
    half_extent: tuple[float, float],
    fit: Literal["whole", "fill"] = "whole",
) -> Array:
    """Average a picture over pixels of a receiver, with its aspect kept.

    Parameters
    ----------
    picture : ndarray, shape (rows, columns)
        Light, row 0 at +y.
    receiver : AnyReceiver
        Pixel raster.
    half_extent : tuple of two float
        The part of the receiver that the picture is for, about its middle, in its coordinates.
    fit : {"whole", "fill"}
        Whether all of the picture is seen there, or all of that part is filled by the picture.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Black outside that part.
    """
    rows, columns = picture.shape
    sizes = [half / count for half, count in zip(half_extent, (columns, rows), strict=True)]
    half_size = max(sizes) if fit == "fill" else min(sizes)  # of a pixel of the picture
    half_u, half_v = half_size * columns, half_size * rows
    (left, right), (top, bottom) = _edges(receiver, half_u, half_v)
    frame = _edges(receiver, *half_extent)
    down = _overlap(np.linspace(top, bottom, rows + 1), receiver.pixels[1], frame[1])
    across = _overlap(np.linspace(left, right, columns + 1), receiver.pixels[0], frame[0])
    light: Array = down @ picture @ across.T  # [n_y, rows] @ [rows, columns] @ [columns, n_x]
    return light


def averaged(image: Array, shape: tuple[int, ...]) -> Array:
    """An image averaged over the pixels of another raster that covers the same.

    Examples
    --------
    >>> import numpy as np
    >>> averaged(np.array([[1.0, 3.0], [5.0, 7.0]]), (1, 4))
    array([[3., 3., 5., 5.]])
    """
    if image.shape == shape:
        return image
    down, across = (
        _overlap(np.linspace(0, new, old + 1), new, (0, new))
        for old, new in zip(image.shape, shape, strict=True)
    )
    light: Array = down @ image @ across.T
    return light


def _edges(receiver: AnyReceiver, half_u: float, half_v: float) -> list[tuple[float, float]]:
    """Columns of left and right, rows of top and bottom of a rectangle about the middle."""
    u, v = receiver.middle
    left, top = receiver.to_pixels(u - half_u, v + half_v)
    right, bottom = receiver.to_pixels(u + half_u, v - half_v)
    return [(left, right), (top, bottom)]


def _overlap(edges: Array, count: int, frame: tuple[float, float]) -> csr_array:
    """Which fraction of the unit cells 0..count-1 each of the cells between ``edges`` covers.

    Only what lies within the frame counts.
    """
    low, high = max(edges[0], frame[0], 0), min(edges[-1], frame[1], count)
    cuts = np.union1d(np.union1d(edges, np.arange(count + 1)), (low, high))
    cuts = cuts[(cuts >= low) & (cuts <= high)]
    start = cuts[:-1]
    pixels = np.minimum(start.astype(int), count - 1)
    cells = np.minimum(np.searchsorted(edges, start, side="right"), len(edges) - 1) - 1
    return csr_array((np.diff(cuts), (pixels, cells)), shape=(count, len(edges) - 1))
