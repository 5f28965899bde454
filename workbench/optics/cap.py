"""The smallest cone of directions, as seen from a point, that covers a rectangle."""

from itertools import combinations
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class Cap(NamedTuple):
    """A spherical cap of directions.

    Attributes
    ----------
    axis : ndarray, shape (3,)
        Unit vector through its middle.
    versine : float
        1 − cos of the angle between the axis and its rim; of a far point the cosine itself has
        no digits left.
    """

    axis: Array
    versine: float

    @property
    def cos_max(self) -> float:
        """Cosine of the angle between the axis and its rim."""
        return 1 - self.versine

    @property
    def solid_angle(self) -> float:
        """Solid angle in steradians."""
        return 2 * np.pi * self.versine


def covering_cap(position: Array, half_width: tuple[float, float], z: float) -> Cap:
    """The smallest cap around a point that covers a centred rectangle in the plane z.

    Parameters
    ----------
    position : ndarray, shape (3,)
        The point, before the plane.
    half_width : tuple[float, float]
        Half-widths of the rectangle.
    z : float
        Where the rectangle is.

    Notes
    -----
    A cap of less than a half-sphere is convex, so one that holds the four corners holds the
    rectangle. The smallest is held by two or three of the corners; on the axis it is that of de
    Koning et al. (2023), section 2.2.
    """
    r_x, r_y = half_width
    corners = np.array([[i * r_x, j * r_y, z] for i in (-1, 1) for j in (-1, 1)]) - position
    corners /= np.linalg.norm(corners, axis=1, keepdims=True)
    axes = [corners[i] + corners[j] for i, j in combinations(range(4), 2)]
    for i, j, k in combinations(range(4), 3):
        across = np.cross(corners[j] - corners[i], corners[k] - corners[i])
        axes += [across, -across]
    caps = []
    for axis in axes:
        length = np.linalg.norm(axis)
        if length > 1e-12:
            axis /= length
            # Of unit vectors a · b = 1 − |a − b|² / 2.
            caps.append(Cap(axis, float(np.square(corners - axis).sum(axis=1).max() / 2)))
    axis, versine = min(caps, key=lambda cap: cap.versine)
    # Rounding must not leave a corner dark.
    return Cap(axis, versine * (1 + 1e-12) + 1e-15 * np.sqrt(versine))
