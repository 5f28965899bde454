"""A screen, or several of them that do not hide each other."""

import math
from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.arrays import Array, Mask
from workbench.compiled import jit
from workbench.scene import Screen


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
        _count(*rays, *self._to_scene, self._planes, self._size, flux, beside)

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays meet the first of the screens; see `Detector.hits`."""
        _hits(*rays, *self._to_scene, self._planes[0], self._size, places)

    def in_the_way(self, rays: TracedRays, begin: float) -> Mask:
        """See `Detector.in_the_way`."""
        turn, shift = self._to_scene
        middle, away, columns, rows = self._planes[0]
        place, way = rays.position @ turn.T + shift, rays.direction @ turn.T
        with np.errstate(divide="ignore", invalid="ignore"):
            ahead = (middle - place) @ away / (way @ away)
            hit = place + way * ahead[:, None]
        n_x, n_y = self._size
        across, up = np.abs((hit - middle) @ columns), np.abs((hit - middle) @ rows)
        found: Mask = (ahead < 0) & (across <= n_x / 2) & (up <= n_y / 2) & (hit[:, 2] > begin)
        return found


def _plane(screen: Screen, onwards: int) -> Array:
    """A screen as rows (4, 3): its middle, away from the light, and columns and rows for lengths.

    Those of its middle are half of all.
    """
    turned = Rotation.from_euler("XYZ", screen.tilt, degrees=True).as_matrix().T
    (r_x, r_y), (n_x, n_y) = screen.half_width, screen.pixels
    per_length = turned[0] * (n_x / (2 * r_x)), -turned[1] * (n_y / (2 * r_y))
    return np.array([[*screen.center, screen.z], onwards * turned[2], *per_length])


@jit(error_model="numpy")
def _count(  # type: ignore[no-untyped-def]
    position, direction, flux, turn, shift, planes, pixels, image, beside
):
    """Add flux to pixels.

    Parameters
    ----------
    position, direction, flux
        The rays, see `TracedRays`.
    turn, shift : array, shapes (3, 3) and (3,)
        From the lens to the scene.
    planes : array, shape (k, 4, 3)
        Where screens are; see `_plane`.
    pixels : tuple[int, int]
        Along x and y.
    image, beside : array, shapes (k, n_y n_x), (k,)
        Get the flux in the pixels and that beside each screen added.
    """
    n_x, n_y = pixels
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        start = _turned(turn, position[ray], shift)
        way = _turned(turn, direction[ray * step], (0.0, 0.0, 0.0))
        for plane in range(len(planes)):
            column, row = _hit(start, way, planes[plane])
            column, row = column + n_x / 2, row + n_y / 2
            # Also not a number, of a ray along the screen, is not in there.
            if 0 <= column < n_x and 0 <= row < n_y:
                image[plane, int(row) * n_x + int(column)] += flux[ray]
            else:
                beside[plane] += flux[ray]


@jit(error_model="numpy")
def _hits(position, direction, flux, turn, shift, plane, pixels, places):  # type: ignore[no-untyped-def]
    """Get columns and rows, shape (m, 2), on one screen; for the parameters see `_count`."""
    n_x, n_y = pixels
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        start = _turned(turn, position[ray], shift)
        way = _turned(turn, direction[ray * step], (0.0, 0.0, 0.0))
        column, row = _hit(start, way, plane)
        places[ray, 0], places[ray, 1] = column + n_x / 2, row + n_y / 2


@jit(error_model="numpy", inline="always")  # a call costs as much
def _turned(turn, vector, shift):  # type: ignore[no-untyped-def]
    """A vector in the scene."""
    x, y, z = vector[0], vector[1], vector[2]
    return (
        turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z + shift[0],
        turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z + shift[1],
        turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z + shift[2],
    )


@jit(error_model="numpy", inline="always")  # a call costs as much
def _hit(start, way, plane):  # type: ignore[no-untyped-def]
    """Column and row from the middle where a ray meets a screen; not finite where it does not."""
    ahead = along = 0.0
    for k in range(3):
        ahead += (plane[0, k] - start[k]) * plane[1, k]
        along += way[k] * plane[1, k]
    path = ahead / along if along > 0 or ahead * along > 0 else math.inf
    column = row = 0.0
    for k in range(3):
        from_middle = start[k] + way[k] * path - plane[0, k]
        column += from_middle * plane[2, k]
        row += from_middle * plane[3, k]
    return column, row
