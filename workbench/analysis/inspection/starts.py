"""First placements of a measurement whose axes are unknown: turned, tilted, upside down, mirrored.

The mean planes of the measurement and of the face are laid onto each other; angles about the
normal, and shifts where the measurement covers a part of the face only, are tried one by one.
"""

from itertools import product

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.inspection.placement import DesignedFace, Placement
from workbench.arrays import Array

_POINTS = 800  # of the measurement that are compared
_ANGLES = np.radians(np.arange(0, 360, 10))
_STEP = 0.1  # of shifts, in half-widths
_OVERLAP = 0.8  # part of the points that has to be on the face, where all of them can be
# Upright and upside down; then their mirror images.
_SIGNS = ((1, 1, 1), (1, -1, -1), (-1, 1, 1), (1, 1, -1))


def first_placements(points: Array, face: DesignedFace, count: int) -> list[Placement]:
    """Return the best first placements of points (n, 3): ``count`` true ones, as many mirrored."""
    some = thinned(points, _POINTS)
    centre, axes = mean_plane(some)
    goal, goal_axes = mean_plane(face.samples)
    size = _radius(some, centre, axes) / _radius(face.samples, goal, goal_axes)
    shifts = _shifts(face, size)
    least = _OVERLAP * min(1.0, size**-2)
    found: dict[bool, list[tuple[float, Placement]]] = {False: [], True: []}
    for angle, signs in product(_ANGLES, _SIGNS):
        about = Rotation.from_rotvec([0, 0, angle]).as_matrix()
        rotation = goal_axes @ about @ np.diag(signs) @ axes.T
        for x, y in shifts:
            there = goal + goal_axes[:, 0] * x + goal_axes[:, 1] * y - rotation @ centre
            placement = Placement(rotation, there)
            merit = _merit(placement.applied(some), face, least)
            found[placement.mirrored].append((merit, placement))
    return [
        placement
        for each in found.values()
        for _, placement in sorted(each, key=lambda pair: pair[0])[:count]
    ]


def thinned(points: Array, most: int) -> Array:
    """Return at most so many of the points (n, 3), drawn evenly; the same ones each time."""
    if len(points) <= most:
        return points
    return np.asarray(points[np.random.default_rng(1).choice(len(points), most, replace=False)])


def mean_plane(points: Array) -> tuple[Array, Array]:
    """Return the centre (3,) of points and the axes (3, 3) of their mean plane, as columns.

    The third axis is the normal, towards +z; the first is as near to x as possible.
    """
    centre = points.mean(axis=0)
    normal = np.linalg.svd(points - centre, full_matrices=False)[2][2]
    normal = normal if normal[2] >= 0 else -normal
    along = np.eye(3)[0] if abs(normal[0]) < 0.9 else np.eye(3)[1]
    along = along - normal * (normal @ along)
    along /= np.linalg.norm(along)
    return centre, np.stack([along, np.cross(normal, along), normal], axis=1)


def relief(points: Array) -> float:
    """Return the RMS of the distances of points from their mean plane."""
    centre, axes = mean_plane(points)
    return float(np.std((points - centre) @ axes[:, 2]))


def _radius(points: Array, centre: Array, axes: Array) -> float:
    return float(np.sqrt((((points - centre) @ axes[:, :2]) ** 2).sum(axis=1).mean()))


def _shifts(face: DesignedFace, size: float) -> list[tuple[float, float]]:
    """Shifts by which a measurement, of this size in parts of the face, may be off."""
    slack = abs(1 - size)
    steps = int(np.ceil(slack / _STEP)) if slack > _STEP / 2 else 0
    along = slack * np.linspace(-1, 1, 2 * steps + 1) if steps else np.zeros(1)
    r_x, r_y = face.net.half_width
    return [(r_x * x, r_y * y) for x in along.tolist() for y in along.tolist()]


def _merit(points: Array, face: DesignedFace, least: float) -> float:
    """Median distance from the face, apart from a plane; infinite beside the face."""
    there = points[face.inside(points)]
    if len(there) < least * len(points):
        return np.inf
    heights = face.rough_heights(there)
    plane = np.column_stack([np.ones(len(there)), there[:, :2]])
    off = heights - plane @ np.linalg.lstsq(plane, heights, rcond=None)[0]
    return float(np.median(np.abs(off)))
