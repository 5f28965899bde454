"""Directions that are turned about the axes x and y."""

import math

import numpy as np

from workbench.arrays import Array


def turned(about: tuple[float, float]) -> Array:
    """The matrix (3, 3) of a turn; its columns are where it takes x, y and z.

    Parameters
    ----------
    about : tuple[float, float]
        Degrees about x and about y, as a rotation vector: their root sum of squares is the angle
        between the axis z before and after it.

    Notes
    -----
    Rodrigues' formula, 1 + sin(a) K + (1 − cos(a)) K² with the cross product K of its axis.
    """
    angle = math.hypot(*about)
    if angle == 0:
        return np.eye(3)
    x, y = (part / angle for part in about)
    cross = np.array([[0.0, 0.0, y], [0.0, 0.0, -x], [-y, x, 0.0]])
    radians = math.radians(angle)
    turn = math.sin(radians) * cross + (1 - math.cos(radians)) * cross @ cross
    return np.asarray(np.eye(3) + turn)
