"""Rays of a file where they are in a scene."""

from fractions import Fraction
from typing import NamedTuple

import numpy as np

from workbench import units
from workbench.arrays import Array, Mask
from workbench.measured.rays.rayset import RaySet

_METRES = units.METRES | {"feet": 12 * units.METRES["inch"]}


class PlacedRays(NamedTuple):
    """Rays in a scene.

    Attributes
    ----------
    position, direction : ndarray, shape (m, 3)
        Starts in scene units, and unit vectors.
    flux : ndarray, shape (m,)
        All together 1.
    """

    position: Array
    direction: Array
    flux: Array

    def onto(self, z: float) -> tuple[Array, Array, Mask]:
        """Where rays cross a plane, shape (m,) each, and which of them do.

        Those that go away from it, or start behind it, do not; their places are 0.
        """
        ahead = self.direction[:, 2]
        way = z - self.position[:, 2]
        come = (ahead > 0) & (way >= 0)
        far = np.where(come, way, 0.0) / np.where(come, ahead, 1.0)
        x, y = (self.position[:, axis] + far * self.direction[:, axis] for axis in (0, 1))
        return np.where(come, x, 0.0), np.where(come, y, 0.0), come


def placed(
    rays: RaySet, file_unit: str, unit: str, matrix: Array, position: tuple[float, float, float]
) -> PlacedRays:
    """Rays of a file in a scene.

    Parameters
    ----------
    rays : RaySet
        As they were read.
    file_unit, unit : str
        Units of length of the file and of the scene.
    matrix : ndarray, shape (3, 3)
        Turns directions of the file into those of the scene.
    position : tuple of 3 float
        Where the origin of the file is in the scene.
    """
    scale: Fraction = _METRES[file_unit] / _METRES[unit]
    start = float(scale) * rays.position.astype(np.float64) @ matrix.T + np.array(position)
    direction = rays.direction.astype(np.float64) @ matrix.T
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    flux = rays.flux.astype(np.float64)
    return PlacedRays(start, direction, flux / flux.sum())
