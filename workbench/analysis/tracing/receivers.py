"""Where light is counted: a class a kind, and a row in ``_DETECTORS``."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import Detector, TracedRays
from workbench.analysis.tracing.kernels import (
    count_directions,
    count_on_planes,
    hits_of_directions,
    hits_on_plane,
)
from workbench.analysis.tracing.pose import Pose
from workbench.arrays import Array, Mask
from workbench.scene import AnyReceiver, FarField, Screen


class PlaneDetector:
    """Counts rays in the pixels that they hit; a `Detector`.

    Parameters
    ----------
    screens : sequence of Screen
        Where they are; all with the same pixels.
    front_z, onwards
        As for `detector_of`.
    pose : Pose
        How the lens stands.
    """

    def __init__(self, screens: Sequence[Screen], front_z: float, onwards: int, pose: Pose) -> None:
        first = screens[0]
        self.images, self.pixels = len(screens), math.prod(first.pixels)
        self._size = first.pixels
        self._to_scene = pose.to_scene(front_z)
        self._planes = np.array([_plane(screen, onwards) for screen in screens])

    def count(self, rays: TracedRays, flux: Array, beside: Array) -> None:
        """Add rays to the images; see `Detector.count`."""
        count_on_planes(*rays, *self._to_scene, self._planes, self._size, flux, beside)

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays meet the first of the screens; see `Detector.hits`."""
        hits_on_plane(*rays, *self._to_scene, self._planes[0], self._size, places)

    def in_the_way(self, rays: TracedRays, length: Array) -> Mask:
        """See `Detector.in_the_way`."""
        turn, shift = self._to_scene
        middle, away, columns, rows = self._planes[0]
        place, way = rays.position @ turn.T + shift, rays.direction @ turn.T
        with np.errstate(divide="ignore", invalid="ignore"):
            ahead = (middle - place) @ away / (way @ away)
            hit = place + way * ahead[:, None]
        n_x, n_y = self._size
        across, up = np.abs((hit - middle) @ columns), np.abs((hit - middle) @ rows)
        passed = (ahead < 0) & (ahead > -length)
        found: Mask = passed & (across <= n_x / 2) & (up <= n_y / 2)
        return found


def _plane(screen: Screen, onwards: int) -> Array:
    """A screen as rows (4, 3): its middle, away from the light, and columns and rows for lengths.

    Those of its middle are half of all.
    """
    turned = Rotation.from_euler("XYZ", screen.tilt, degrees=True).as_matrix().T
    (r_x, r_y), (n_x, n_y) = screen.half_width, screen.pixels
    per_length = turned[0] * (n_x / (2 * r_x)), -turned[1] * (n_y / (2 * r_y))
    return np.array([[*screen.center, screen.z], onwards * turned[2], *per_length])


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


_DETECTORS: Mapping[type, Callable[[Any, float, int, Pose], Detector]] = {
    Screen: PlaneDetector,
    FarField: FarFieldDetector,
}


def detector_of(
    receivers: Sequence[AnyReceiver], front_z: float, onwards: int, pose: Pose
) -> Detector:
    """The detector of some receivers of one kind, at least one, which do not hide each other.

    `receivers`: the receivers; `front_z`: the z of the scene from which rays count z; `onwards`: 1
    if light comes to them towards +z, -1 if towards -z; `pose`: how the lens stands.
    """
    return _DETECTORS[type(receivers[0])](receivers, front_z, onwards, pose)
