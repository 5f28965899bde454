"""Points beside a straight line, such as the line of sight under a mouse pointer."""

import numpy as np

from workbench.arrays import Array


def nearest_to_line(points: Array, start: Array, end: Array) -> tuple[tuple[int, ...], float]:
    """The point that lies nearest to a line.

    Parameters
    ----------
    points : ndarray, shape (..., 3)
        At least one point.
    start, end : ndarray, shape (3,)
        Two different points of the line, which goes on beyond them.

    Returns
    -------
    tuple of int
        Index of the point in the leading axes.
    float
        Its distance from the line.
    """
    direction = (end - start) / np.linalg.norm(end - start)
    away = points - start
    away = away - (away @ direction)[..., None] * direction
    distances = np.linalg.norm(away, axis=-1)
    index = np.unravel_index(int(distances.argmin()), distances.shape)
    return tuple(int(i) for i in index), float(distances[index])
