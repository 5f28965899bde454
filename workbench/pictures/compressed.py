"""Scenes drawn with compressed distances, so that a far screen or source does not shrink the lens.

The drawn scene has screen and source scaled towards the train. Rays keep their intersections with
all elements and end at the same point of the image. Trains with tilted elements stay as they are.
"""

import math

import numpy as np

from workbench.arrays import Array
from workbench.scene import Image, Scene, Screen, Source

# Largest distances from the train and width of the screen, in widths of its widest element.
_TO_SCREEN, _TO_SOURCE, _WIDTH = 2.0, 1.5, 1.5
# Ends of rays this near a screen are on it, in parts of its size.
_ROUNDING = 1e-9


def compress_distances(scene: Scene) -> Scene:
    """Return the scene with distances compressed; nothing is enlarged."""
    if _is_folded(scene):
        return scene
    drawn = scene.with_images(_drawn_images(scene))
    return drawn.model_copy(update={"source": _drawn_source(scene)})


def compress_paths(points: Array, scene: Scene) -> Array:
    """Return ray paths (n, k, 3) of a scene as drawn in its scene from `compress_distances`."""
    if _is_folded(scene):
        return points
    drawn = points.copy()
    drawn[:, 0] = _nearer(points[:, 0], scene.first.front_z, _source_scale(scene))
    screen, shown = scene.receiver, _drawn_screen(scene)
    if isinstance(screen, Screen) and shown is not None and shown != screen:
        x, y, off = screen.sides @ (points[:, -1] - screen.position).T
        arrives = np.abs(off) <= _ROUNDING * (abs(screen.z) + max(screen.half_width))
        scale = shown.half_width[0] / screen.half_width[0]
        drawn[arrives, -1] = shown.drawn(scene.elements[-1], scale * x[arrives], scale * y[arrives])
    return drawn


def _is_folded(scene: Scene) -> bool:
    return any(any(element.tilt) for element in scene.elements)


def _lens_width(scene: Scene) -> float:
    return 2 * max(max(element.half_width) for element in scene.elements)


def _drawn_screen(scene: Scene) -> Screen | None:
    screen = scene.receiver
    if not isinstance(screen, Screen):
        return None
    scale = min(1.0, _WIDTH * _lens_width(scene) / (2 * max(screen.half_width)))
    (r_x, r_y), (x, y) = screen.half_width, screen.center
    z = min(screen.z, scene.elements[-1].highest + _TO_SCREEN * _lens_width(scene))
    return screen.model_copy(
        update={"half_width": (scale * r_x, scale * r_y), "position": (scale * x, scale * y, z)}
    )


def _drawn_images(scene: Scene) -> list[Image]:
    """Images on smaller, nearer receivers; further ones in proportion, so that none hides."""
    screen, shown, top = scene.receiver, _drawn_screen(scene), scene.elements[-1].leaving_z
    if not isinstance(screen, Screen) or shown is None:
        return list(scene.images)
    first, *others = scene.images
    nearer, smaller = (
        (shown.z - top) / (screen.z - top),
        shown.half_width[0] / screen.half_width[0],
    )
    images = [first.model_copy(update={"receiver": shown})]
    for image in others:
        receiver = image.receiver
        if isinstance(receiver, Screen):
            x, y, z = receiver.position
            changes = {
                "position": (smaller * x, smaller * y, top + nearer * (z - top)),
                "half_width": tuple(smaller * r for r in receiver.half_width),
            }
            receiver = receiver.model_copy(update=changes)
        images.append(image.model_copy(update={"receiver": receiver}))
    return images


def _source_scale(scene: Scene) -> float:
    away = scene.first.front_z - scene.source.nearest_z
    return 1.0 if math.isinf(away) else min(1.0, _TO_SOURCE * _lens_width(scene) / away)


def _drawn_source(scene: Scene) -> Source:
    source, scale = scene.source, _source_scale(scene)
    if source.place is None:
        return source
    x, y, z = _nearer(np.array(source.place), scene.first.front_z, scale).tolist()
    return source.placed((x, y, z)).shrunk(scale)


def _nearer(places: Array, entrance_z: float, scale: float) -> Array:
    middle = np.array([0.0, 0.0, entrance_z])
    return np.asarray(middle + scale * (places - middle))
