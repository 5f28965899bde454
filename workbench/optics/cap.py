"""The smallest cones of directions, as seen from points, that cover a rectangle."""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array


class Caps(NamedTuple):
    """Spherical caps of directions, one for each of k points."""

    axis: Array  # (k, 3), unit vectors through their middles
    # (k,), 1 − cos of the angle between the axis and its rim; of a far point the cosine itself has
    # no digits left.
    versine: Array
    centre: Array  # (k, 2), where the axes cross the plane of the rectangle

    @property
    def cos_max(self) -> Array:
        """Cosines of the angles between axes and rims, shape (k,)."""
        return 1 - self.versine

    @property
    def solid_angle(self) -> Array:
        """Solid angles in steradians, shape (k,)."""
        return 2 * np.pi * self.versine


def covering_caps(points: Array, half_width: tuple[float, float], z: float) -> Caps:
    """The smallest cap around each point that covers a centred rectangle in the plane z.

    `points` (k, 3): the points, before the plane; `half_width`: half-widths of the rectangle; `z`:
    where the rectangle is.

    Notes
    -----
    A cap of less than a half-sphere is convex, so one that holds the four corners holds the
    rectangle. The smallest is held by two or three of the corners; on the axis it is that of de
    Koning et al. (2023), section 2.2.

    Unit vectors to the corners are counted from the one to the middle of the rectangle, without a
    difference of long ways: so a far point loses no digits.
    """
    r_x, r_y = half_width
    corners = np.array([[i * r_x, j * r_y, 0.0] for i in (-1, 1) for j in (-1, 1)])
    middle = [0.0, 0.0, z] - points  # [points, 3]
    far = np.linalg.norm(middle, axis=1)[:, None]
    ways = corners + middle[:, None]  # [points, corners, 3]
    length = np.linalg.norm(ways, axis=2)
    shorter = (corners * (ways + middle[:, None])).sum(axis=2) / (length + far)
    ahead = middle / far
    unit = (corners - ahead[:, None] * shorter[..., None]) / length[..., None]

    # Of the smallest ball that holds the unit vectors the middle is on the axis.
    balls = _middles(unit)
    radius2 = np.stack([np.square(unit - b[:, None]).sum(axis=2).max(axis=1) for b in balls])
    radius2[np.isnan(radius2)] = np.inf  # three corners on a line have no circle
    best = radius2.argmin(axis=0), np.arange(len(points))
    aside, sine2 = np.stack(balls)[best], radius2[best]
    axis = ahead + aside
    rise = middle[:, 2:] / axis[:, 2:]
    centre = rise * (aside[:, :2] - ahead[:, :2] * (aside[:, 2:] / ahead[:, 2:]))
    versine = sine2 / (1 + np.sqrt((1 - sine2).clip(min=0)))
    # Rounding must not leave a corner dark.
    versine *= 1 + 1e-12
    return Caps(axis / np.linalg.norm(axis, axis=1, keepdims=True), versine, centre)


def _middles(unit: Array) -> list[Array]:
    """Middles of the balls, shape (k, 3) each, that may be the smallest around four points."""
    found = [(unit[:, i] + unit[:, j]) / 2 for i, j in combinations(range(4), 2)]
    for i, j, k in combinations(range(4), 3):
        b, c = unit[:, j] - unit[:, i], unit[:, k] - unit[:, i]
        across = np.cross(b, c)
        b2, c2, across2 = (np.square(v).sum(axis=1, keepdims=True) for v in (b, c, across))
        with np.errstate(invalid="ignore", divide="ignore"):
            centre = (c2 * np.cross(across, b) + b2 * np.cross(c, across)) / (2 * across2)
        found.append(unit[:, i] + centre)
    return found
