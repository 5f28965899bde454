"""A screen across the axis, or several of them that do not hide each other."""

import math

import numpy as np

from workbench.analysis.tracing.elements import Array, TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.compiled import jit
from workbench.scene import Lens, Screen


class PlaneDetector:
    """Counts rays in the pixels that they hit; a `Detector`.

    Parameters
    ----------
    screen : Screen
        How large it is, and its pixels.
    planes : ndarray, shape (images,)
        z of each screen in the scene.
    lens : Lens
        Gives the entrance face, from which rays count.
    pose : Pose
        How the lens stands.
    """

    def __init__(self, screen: Screen, planes: Array, lens: Lens, pose: Pose) -> None:
        self.images, self.pixels = len(planes), math.prod(screen.pixels)
        self._size, self._planes = screen.pixels, planes
        self._to_scene = pose.to_scene(lens.entrance_z)
        added = np.array(screen.to_pixels(0.0, 0.0))
        with_factor = np.array(screen.to_pixels(1.0, 1.0))
        # Column of x and row of y as factors and what is added.
        self._scale = np.column_stack([with_factor - added, added])

    def count(self, rays: TracedRays, flux: Array, beside: Array) -> None:
        """Add rays to the images; see `Detector.count`."""
        _count(*rays, *self._to_scene, self._planes, self._scale, self._size, flux, beside)

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays meet the first of the screens; see `Detector.hits`."""
        _hits(*rays, *self._to_scene, self._planes[0], self._scale, places)


@jit(error_model="numpy")
def _count(  # type: ignore[no-untyped-def]
    position, direction, flux, turn, shift, planes, scale, pixels, image, beside
):
    """Add flux to pixels.

    Parameters
    ----------
    position, direction, flux
        The rays, see `TracedRays`.
    turn, shift : array, shapes (3, 3) and (3,)
        From the lens to the scene.
    planes : array, shape (k,)
        Where screens are, z.
    scale : array, shape (2, 2)
        Column of x and row of y: factor and what is added.
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
            column, row = _hit(start, way, planes[plane], scale)
            # Also not a number, of a ray along the screen, is not in there.
            if 0 <= column < n_x and 0 <= row < n_y:
                image[plane, int(row) * n_x + int(column)] += flux[ray]
            else:
                beside[plane] += flux[ray]


@jit(error_model="numpy")
def _hits(position, direction, flux, turn, shift, plane, scale, places):  # type: ignore[no-untyped-def]
    """Get columns and rows, shape (m, 2), on one screen; for the parameters see `_count`."""
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        start = _turned(turn, position[ray], shift)
        way = _turned(turn, direction[ray * step], (0.0, 0.0, 0.0))
        places[ray, 0], places[ray, 1] = _hit(start, way, plane, scale)


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
def _hit(start, way, plane, scale):  # type: ignore[no-untyped-def]
    """Column and row where a ray meets a screen; not finite where it does not."""
    ahead = plane - start[2]
    path = ahead / way[2] if way[2] > 0 or ahead * way[2] > 0 else math.inf
    return (
        scale[0, 0] * (start[0] + way[0] * path) + scale[0, 1],
        scale[1, 0] * (start[1] + way[1] * path) + scale[1, 1],
    )
