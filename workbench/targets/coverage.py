"""How much of every pixel of a receiver a polygon covers, exactly."""

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.scene import AnyReceiver


def coverage(outline: npt.ArrayLike, receiver: AnyReceiver) -> Array:
    """Fraction of each pixel's area inside a polygon.

    Parameters
    ----------
    outline : array_like, shape (n, 2)
        Corners (x, y) of a simple polygon within the receiver, from its middle, in its coordinates;
        either sense of rotation.
    receiver : AnyReceiver
        Pixel raster.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Values in [0, 1]; their sum times the pixel area is the polygon's area.
    """
    return paint([(outline, 1.0)], receiver)


def paint(polygons: Iterable[tuple[npt.ArrayLike, float]], receiver: AnyReceiver) -> Array:
    """Sum of polygons, each of one grey, averaged over the area of every pixel.

    Parameters
    ----------
    polygons : iterable of (outline, grey)
        Outlines as `coverage` takes them.
    receiver : AnyReceiver
        Pixel raster.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Sum of grey × coverage.
    """
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
    # Rounded, so that what is wholly inside or outside is exactly its grey or 0.
    painted: Array = np.cumsum(change, axis=1)[:, :n_x].round(12)
    return painted


def _cut_at_pixel_edges(start: Array, end: Array) -> tuple[Array, Array]:
    """Starts and ends of pieces of straight lines, each piece within one pixel; shape (n, 2)."""
    lines = np.stack([start, end], axis=1)
    # Most lines of a fine outline lie within a pixel as they are.
    whole = (np.ceil(lines.max(axis=1)) - np.floor(lines.min(axis=1)) <= 1).all(axis=1)
    cut = [_pieces(*line) for line in lines[~whole]]
    pieces = np.concatenate([lines[whole], *cut])
    return pieces[:, 0], pieces[:, 1]


def _pieces(start: Array, end: Array) -> Array:
    """Pieces of a straight line, each within one pixel; shape (pieces, 2 ends, 2)."""
    cuts = [np.array([0.0, 1.0])]
    for a, b in zip(start, end, strict=True):
        lines = np.arange(np.ceil(min(a, b)), max(a, b))
        if a != b:
            cuts.append((lines - a) / (b - a))
    along = np.unique(np.clip(np.concatenate(cuts), 0.0, 1.0))[:, None]
    points = start + along * (end - start)
    return np.stack([points[:-1], points[1:]], axis=1)
