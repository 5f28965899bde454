"""The far field: light counted by its direction."""

import math
from collections.abc import Sequence

import numpy as np

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.arrays import Array, Mask
from workbench.compiled import jit
from workbench.scene import FarField


class FarFieldDetector:
    """Counts rays in the pixels to which they go; a `Detector`.

    Parameters
    ----------
    far_fields : sequence of FarField
        The directions in which each image is.
    front_z, onwards
        As for `detector_of`.
    pose : Pose
        How the lens stands.
    """

    def __init__(
        self, far_fields: Sequence[FarField], front_z: float, onwards: int, pose: Pose
    ) -> None:
        first = far_fields[0]
        self.images, self.pixels = len(far_fields), math.prod(first.pixels)
        self._size = first.pixels
        turn, _ = pose.to_scene(front_z)
        self._turn = turn * [[1.0], [1.0], [float(onwards)]]  # angles from where light goes
        self._scales = np.array([_scale(each) for each in far_fields])

    def count(self, rays: TracedRays, flux: Array, beside: Array) -> None:
        """Add rays to the images; see `Detector.count`."""
        _count(rays.direction, rays.flux, self._turn, self._scales, self._size, flux, beside)

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays go in the first of the images; see `Detector.hits`."""
        _hits(rays.direction, rays.flux, self._turn, self._scales[0], places)

    def in_the_way(self, rays: TracedRays, begin: float) -> Mask:
        """It is nowhere; see `Detector.in_the_way`."""
        return np.zeros(len(rays.flux), dtype=bool)


def _scale(far_field: FarField) -> Array:
    """Columns for each radian of H and that of 0; rows for each radian of V and that of 0."""
    (h, v), (half_h, half_v) = np.radians(far_field.center), np.radians(far_field.half_angle)
    n_x, n_y = far_field.pixels
    per_h, per_v = n_x / (2 * half_h), -n_y / (2 * half_v)
    return np.array([[per_h, n_x / 2 - per_h * h], [per_v, n_y / 2 - per_v * v]])


@jit(error_model="numpy")
def _count(direction, flux, turn, scales, pixels, image, beside):  # type: ignore[no-untyped-def]
    """Add flux to pixels; for the parameters see those of `plane`."""
    n_x, n_y = pixels
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        for far_field in range(len(scales)):
            column, row = _pixel(turn, direction[ray * step], scales[far_field])
            if 0 <= column < n_x and 0 <= row < n_y:
                image[far_field, int(row) * n_x + int(column)] += flux[ray]
            else:
                beside[far_field] += flux[ray]


@jit(error_model="numpy")
def _hits(direction, flux, turn, scale, places):  # type: ignore[no-untyped-def]
    """Get columns and rows, shape (m, 2)."""
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] != 0:
            places[ray, 0], places[ray, 1] = _pixel(turn, direction[ray * step], scale)


@jit(error_model="numpy", inline="always")
def _pixel(turn, way, scale):  # type: ignore[no-untyped-def]
    """Column and row of a direction; not finite where it goes back."""
    x, y, z = way[0], way[1], way[2]
    d_x = turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z
    d_y = turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z
    d_z = turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z
    if d_z <= 0:
        return math.inf, math.inf
    return (
        scale[0, 0] * math.atan2(d_x, d_z) + scale[0, 1],
        scale[1, 0] * math.atan2(d_y, math.hypot(d_x, d_z)) + scale[1, 1],
    )
