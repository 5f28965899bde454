"""How much of every screen pixel a polygon covers, exactly."""

import numpy as np
import numpy.typing as npt

from workbench.scene import Screen

Array = npt.NDArray[np.float64]


def coverage(outline: npt.ArrayLike, screen: Screen) -> Array:
    """Fraction of each pixel's area inside a polygon.

    Parameters
    ----------
    outline : array_like, shape (n, 2)
        Corners (x, y) of a simple polygon within the screen, scene units; either sense of
        rotation.
    screen : Screen
        Pixel raster.

    Returns
    -------
    ndarray, shape (n_y, n_x)
        Values in [0, 1]; their sum times the pixel area is the polygon's area.
    """
    n_x, n_y = screen.pixels
    x, y = np.asarray(outline, dtype=np.float64).T
    corners = np.stack(screen.to_pixels(x, y), axis=1)  # [n, (column, row)]
    pieces = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    start, end = np.concatenate([_cut_at_pixel_edges(*edge) for edge in pieces]).swapaxes(0, 1)

    # Green's theorem, row by row: a piece of the outline that descends by `drop` in one pixel
    # adds `drop` to every pixel to its right, and to its own the part that lies right of it.
    middle = (start + end) / 2
    column = np.clip(np.floor(middle[:, 0]).astype(int), 0, n_x - 1)
    row = np.clip(np.floor(middle[:, 1]).astype(int), 0, n_y - 1)
    drop = end[:, 1] - start[:, 1]
    left_part = middle[:, 0] - column
    change = np.zeros((n_y, n_x + 1))
    np.add.at(change, (row, column), drop * (1 - left_part))
    np.add.at(change, (row, column + 1), drop * left_part)
    # Rounded, so that what is wholly inside or outside is exactly 1 or 0.
    covered: Array = np.abs(np.cumsum(change, axis=1)[:, :n_x]).round(12)
    return covered


def _cut_at_pixel_edges(start: Array, end: Array) -> Array:
    """Pieces of a straight line, each within one pixel; shape (pieces, 2 ends, 2)."""
    cuts = [np.array([0.0, 1.0])]
    for a, b in zip(start, end, strict=True):
        lines = np.arange(np.ceil(min(a, b)), max(a, b))
        if a != b:
            cuts.append((lines - a) / (b - a))
    along = np.unique(np.clip(np.concatenate(cuts), 0.0, 1.0))[:, None]
    points = start + along * (end - start)
    return np.stack([points[:-1], points[1:]], axis=1)
