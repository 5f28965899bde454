"""The far field: light counted by its direction."""

import math
from collections.abc import Sequence

import numpy as np

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.kernels import count_directions, hits_of_directions
from workbench.analysis.tracing.pose import Pose
from workbench.arrays import Array, Mask
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
        count_directions(
            rays.direction, rays.flux, self._turn, self._scales, self._size, flux, beside
        )

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays go in the first of the images; see `Detector.hits`."""
        hits_of_directions(rays.direction, rays.flux, self._turn, self._scales[0], places)

    def in_the_way(self, rays: TracedRays, length: Array) -> Mask:
        """It is nowhere; see `Detector.in_the_way`."""
        return np.zeros(len(rays.flux), dtype=bool)


def _scale(far_field: FarField) -> Array:
    """Columns for each radian of H and that of 0; rows for each radian of V and that of 0."""
    (h, v), (half_h, half_v) = np.radians(far_field.center), np.radians(far_field.half_angle)
    n_x, n_y = far_field.pixels
    per_h, per_v = n_x / (2 * half_h), -n_y / (2 * half_v)
    return np.array([[per_h, n_x / 2 - per_h * h], [per_v, n_y / 2 - per_v * v]])
