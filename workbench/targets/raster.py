"""Polygons and pictures averaged over the pixels of a receiver."""

from collections.abc import Iterable
from functools import lru_cache
from typing import Literal

import numpy as np
import numpy.typing as npt
import scipy

from workbench.arrays import Array
from workbench.scene import AnyReceiver

# Pixels so near to each other's places are the same.
_SAME = 1e-9


def put(
    picture: Array,
    receiver: AnyReceiver,
    half_extent: tuple[float, float],
    fit: Literal["whole", "fill"] = "whole",
) -> Array:
    """Average a picture (rows, columns) over the pixels (n_y, n_x) of a receiver.

    `picture` (rows, columns): light, row 0 at +y; its aspect is kept; `receiver`: pixel raster;
    `half_extent`: half-sizes of the area for the picture, about the receiver's middle; `fit`:
    whether the picture fits into the area or fills it. Returns (n_y, n_x): black outside the area.
    """
    rows, columns = picture.shape
    sizes = [half / count for half, count in zip(half_extent, (columns, rows), strict=True)]
    half_size = max(sizes) if fit == "fill" else min(sizes)  # of a pixel of the picture
    half_u, half_v = half_size * columns, half_size * rows
    (left, right), (top, bottom) = _edges(receiver, half_u, half_v)
    frame = _edges(receiver, *half_extent)
    n_x, n_y = receiver.pixels
    ends = ((left, right), (top, bottom)), frame, [(0, n_x), (0, n_y)]
    if (rows, columns) == (n_y, n_x) and np.allclose(ends[:2], ends[2], rtol=0, atol=_SAME):
        return np.array(picture, dtype=np.float64)
    down = _overlap(np.linspace(top, bottom, rows + 1), n_y, frame[1])
    across = _overlap(np.linspace(left, right, columns + 1), n_x, frame[0])
    light: Array = down @ picture @ across.T  # [n_y, rows] @ [rows, columns] @ [columns, n_x]
    return light


def averaged(image: Array, shape: tuple[int, ...]) -> Array:
    """Average an image over another raster of the same rectangle.

    Examples
    --------
    >>> import numpy as np
    >>> averaged(np.array([[1.0, 3.0], [5.0, 7.0]]), (1, 4))
    array([[3., 3., 5., 5.]])
    """
    if image.shape == shape:
        return image
    down, across = map(_averaging, image.shape, shape)
    light: Array = down @ image @ across.T
    return light


@lru_cache(16)  # pictures of a run are averaged over the same raster again and again
def _averaging(old: int, new: int) -> "scipy.sparse.csr_array":
    return _overlap(np.linspace(0, new, old + 1), new, (0, new))


def _edges(receiver: AnyReceiver, half_u: float, half_v: float) -> list[tuple[float, float]]:
    u, v = receiver.middle
    left, top = receiver.to_pixels(u - half_u, v + half_v)
    right, bottom = receiver.to_pixels(u + half_u, v - half_v)
    return [(left, right), (top, bottom)]


def _overlap(edges: Array, count: int, frame: tuple[float, float]) -> "scipy.sparse.csr_array":
    low, high = max(edges[0], frame[0], 0), min(edges[-1], frame[1], count)
    cuts = np.union1d(np.union1d(edges, np.arange(count + 1)), (low, high))
    cuts = cuts[(cuts >= low) & (cuts <= high)]
    start = cuts[:-1]
    pixels = np.minimum(start.astype(int), count - 1)
    cells = np.minimum(np.searchsorted(edges, start, side="right"), len(edges) - 1) - 1
    return scipy.sparse.csr_array((np.diff(cuts), (pixels, cells)), shape=(count, len(edges) - 1))


def coverage(outline: npt.ArrayLike, receiver: AnyReceiver) -> Array:
    """Return the fraction (n_y, n_x) of each pixel's area inside a simple polygon.

    Corners (n, 2) are relative to the receiver's middle, in its coordinates, in either sense of
    rotation.
    """
    return paint([(outline, 1.0)], receiver)


def paint(polygons: Iterable[tuple[npt.ArrayLike, float]], receiver: AnyReceiver) -> Array:
    """Return the sum of polygons, each of one grey, averaged over each pixel (n_y, n_x)."""
    n_x, n_y = receiver.pixels
    change = np.zeros((n_y, n_x + 1))  # from pixel to pixel along a row
    for outline, grey in polygons:
        u, v = (np.asarray(outline, dtype=np.float64) + receiver.middle).T
        corners = np.stack(receiver.to_pixels(u, v), axis=1)  # [n, (column, row)]
        start, end = _cut_at_pixel_edges(corners, np.roll(corners, -1, axis=0))
        turning = np.sign((start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]).sum())

        # Green's theorem, row by row: a piece of the outline that crosses some part of a row's
        # height changes every pixel to its right by that part, and its own pixel by the share
        # of it that lies to the right of the piece.
        middle = (start + end) / 2
        column = np.clip(np.floor(middle[:, 0]).astype(int), 0, n_x - 1)
        row = np.clip(np.floor(middle[:, 1]).astype(int), 0, n_y - 1)
        light = -turning * grey * (end[:, 1] - start[:, 1])
        left_part = middle[:, 0] - column
        np.add.at(change, (row, column), light * (1 - left_part))
        np.add.at(change, (row, column + 1), light * left_part)
    # Rounded, so that pixels wholly inside or outside are exactly the grey or 0.
    painted: Array = np.cumsum(change, axis=1)[:, :n_x].round(12)
    return painted


def _cut_at_pixel_edges(start: Array, end: Array) -> tuple[Array, Array]:
    lines = np.stack([start, end], axis=1)
    # Most lines of a fine outline already lie within a pixel.
    whole = (np.ceil(lines.max(axis=1)) - np.floor(lines.min(axis=1)) <= 1).all(axis=1)
    cut = [_pieces(*line) for line in lines[~whole]]
    pieces = np.concatenate([lines[whole], *cut])
    return pieces[:, 0], pieces[:, 1]


def _pieces(start: Array, end: Array) -> Array:
    cuts = [np.array([0.0, 1.0])]
    for a, b in zip(start, end, strict=True):
        lines = np.arange(np.ceil(min(a, b)), max(a, b))
        if a != b:
            cuts.append((lines - a) / (b - a))
    along = np.unique(np.clip(np.concatenate(cuts), 0.0, 1.0))[:, None]
    points = start + along * (end - start)
    return np.stack([points[:-1], points[1:]], axis=1)
