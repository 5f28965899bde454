"""Distances drawn shorter than they are, so that no screen or source makes the lens a dot.

What is drawn is another scene: its screen and its source are shrunk towards the middle of the
lens, each as a whole. Rays keep where they meet the lens, and end at the same place of the image.
"""

import math

import numpy as np
import numpy.typing as npt

from workbench.scene import Scene, Source

Array = npt.NDArray[np.float64]

# Longest distances from the lens, and largest width of the screen, in widths of the lens.
_TO_SCREEN, _TO_SOURCE, _WIDTH = 2.0, 1.5, 1.5


def exploded(scene: Scene) -> Scene:
    """The scene as it is drawn; nothing is moved farther away, and nothing enlarged."""
    screen = scene.screen
    x, y = (r * _screen_scale(scene) for r in screen.half_width)
    z = _drawn_screen_z(scene)
    return scene.model_copy(
        update={
            "screen": screen.model_copy(update={"half_width": (x, y), "z": z}),
            "source": _drawn_source(scene),
        }
    )


def explode_paths(points: Array, scene: Scene) -> Array:
    """Paths of rays as they are drawn in the `exploded` scene.

    Parameters
    ----------
    points : ndarray, shape (n, k, 3)
        Start, places on each face, screen plane; see `workbench.optics.paths.RayPaths`.
    scene : Scene
        The scene that they were traced in.
    """
    drawn = points.copy()
    drawn[:, 0] = _nearer(points[:, 0], scene.lens.entrance_z, _source_scale(scene))
    arrives = points[:, -1, 2] == scene.screen.z
    drawn[arrives, -1, :2] *= _screen_scale(scene)
    drawn[arrives, -1, 2] = _drawn_screen_z(scene)
    return drawn


def _lens_width(scene: Scene) -> float:
    return 2 * max(scene.lens.half_width)


def _screen_scale(scene: Scene) -> float:
    return min(1.0, _WIDTH * _lens_width(scene) / (2 * max(scene.receiver.half_extent)))


def _drawn_screen_z(scene: Scene) -> float:
    return min(scene.screen.z, scene.lens.highest + _TO_SCREEN * _lens_width(scene))


def _source_scale(scene: Scene) -> float:
    away = scene.lens.entrance_z - scene.source.nearest_z
    return 1.0 if math.isinf(away) else min(1.0, _TO_SOURCE * _lens_width(scene) / away)


def _drawn_source(scene: Scene) -> Source:
    source, scale = scene.source, _source_scale(scene)
    if source.place is None:
        return source
    x, y, z = _nearer(np.array(source.place), scene.lens.entrance_z, scale).tolist()
    return source.placed((x, y, z)).shrunk(scale)


def _nearer(places: Array, entrance_z: float, scale: float) -> Array:
    middle = np.array([0.0, 0.0, entrance_z])
    return np.asarray(middle + scale * (places - middle))
