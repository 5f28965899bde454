"""The largest ball cutter that fits everywhere on a face without cutting into another part of it.

A ball of radius R that touches the face at P from outside, with the unit normal n, holds no other
point Q of it if R ≤ |Q − P|² / (2 n·(Q − P)) for each Q above the tangent plane (Federer, Curvature
Measures, 1959, theorem 4.18). Then the offset surface at R does not fold, either. With Q close to P
the right side becomes the radius of curvature of the hollow; other pairs are looked at one by one.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.interruption import check_given_up

# Pairs are looked at up to so many steps of the grid apart, then on one of twice the step, so that
# the places of a pair are known to a sixth of their distance, or better.
_WINDOW = 12


class GridFace(NamedTuple):
    """A face on a regular grid, seen from outside: hollows bend towards +z.

    Attributes
    ----------
    x, y : ndarray, shapes (m_x,) and (m_y,)
        In equal steps, scene units.
    height, slope_x, slope_y : ndarray, shape (m_x, m_y)
        Height and its derivatives; NaN beside the glass.
    """

    x: Array
    y: Array
    height: Array
    slope_x: Array
    slope_y: Array

    def coarser(self) -> "GridFace":
        """Every second place along both axes."""
        fields = (each[::2, ::2] for each in self[2:])
        return GridFace(self.x[::2], self.y[::2], *fields)


def blocked_radius(face: GridFace, radius: float) -> tuple[float, tuple[float, float]] | None:
    """The largest ball that no other place of a face is in the way of, and where it touches.

    Parameters
    ----------
    face : GridFace
        The face.
    radius : float
        What fits by curvature alone, scene units.

    Returns
    -------
    tuple or None
        Its radius and the x and y of the place; None if a ball of the given radius fits.
    """
    found = None
    steepest = math.atan(float(np.nanmax(np.hypot(face.slope_x, face.slope_y))))
    # By how much the line to another place can be steeper than the tangent plane.
    above = math.sin(min(2 * steepest, math.pi / 2))
    finest = True
    while min(face.height.shape) > 1:
        for i, j in _offsets(face.height.shape, finest):
            check_given_up()
            apart = math.hypot(i * (face.x[1] - face.x[0]), j * (face.y[1] - face.y[0]))
            if apart >= 2 * radius * above:
                continue  # nothing so far away is in the way of a ball of this size
            closest = _tightest(face, i, j)
            if closest is not None and closest[0] < radius:
                found = closest
                radius = found[0]
        if max(face.height.shape) <= _WINDOW:
            break
        face, finest = face.coarser(), False
    return found


def _offsets(shape: tuple[int, ...], finest: bool) -> Iterator[tuple[int, int]]:
    """Half of all steps between two places of a window; the other half are the same pairs."""
    across, up = (min(_WINDOW, n - 1) for n in shape)
    for i in range(across + 1):
        for j in range(-up if i else 1, up + 1):
            # The finer grid has had the closer ones.
            if finest or max(i, abs(j)) > _WINDOW // 2:
                yield i, j


def _tightest(face: GridFace, i: int, j: int) -> tuple[float, tuple[float, float]] | None:
    """The least ratio of all pairs of places that are so many steps apart, either way."""
    rows = slice(None, -i or None), slice(i, None)
    columns = slice(max(-j, 0), -j if j > 0 else None), slice(max(j, 0), j if j < 0 else None)
    ends = [tuple(each[r, c] for each in face[2:]) for r, c in zip(rows, columns, strict=True)]
    (z, p, q), (z_far, p_far, q_far) = ends
    dx, dy = i * (face.x[1] - face.x[0]), j * (face.y[1] - face.y[0])
    dz = z_far - z
    square = dx * dx + dy * dy + dz * dz
    least = None
    for number, above in enumerate(
        (
            (dz - p * dx - q * dy) / np.sqrt(1 + p * p + q * q),
            (p_far * dx + q_far * dy - dz) / np.sqrt(1 + p_far * p_far + q_far * q_far),
        )
    ):
        curved = 2 * above / square
        if not (curved > 0).any():
            continue
        row, column = np.unravel_index(np.nanargmax(curved), curved.shape)
        ratio = 1 / float(curved[row, column])
        if least is None or ratio < least[0]:
            x, y = face.x[rows[number]][row], face.y[columns[number]][column]
            least = ratio, (float(x), float(y))
    return least
