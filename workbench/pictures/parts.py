"""Which part of a scene is seen at a pixel."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.camera import box_around
from workbench.pictures.projection import Projection
from workbench.scene import Scene

_NEAR = 14.0  # pixels from a source, which may be as small as a point
_POINTS = (9, 9)  # of a source, along x and y


class SeenPart(NamedTuple):
    """A part of a scene: its path, and what it is called within a sentence."""

    path: str
    called: str


def part_at(scene: Scene, sight: Projection, x: float, y: float) -> SeenPart | None:
    """Return the part of a scene, as drawn, at a pixel; None where there is none."""
    body, (start, end) = sight.corner(x, y), sight.line(x, y)
    source = scene.source.seen(_POINTS)
    if len(source):
        away = np.hypot(*(sight.pixels(source) - (x, y)).T)
        nearest = source[away.argmin()]
        hidden = body is not None and (body - nearest) @ (end - start) < 0
        if away.min() <= _NEAR and not hidden:
            return SeenPart("source", Message("source"))
    if body is None:
        return None
    # Of boxes that hold the point the smallest: that of a tilted or curved receiver holds more.
    ranked = [(_distance(body, box), float(np.ptp(box)), part) for part, box in _boxes(scene)]
    return min(ranked, key=lambda each: each[:2])[2]


def _boxes(scene: Scene) -> Iterator[tuple[SeenPart, Array]]:
    """Elements and receivers, with points (n, 3) of a box around each."""
    for number, element in enumerate(scene.elements):
        yield SeenPart(f"elements[{number}]", element.name), box_around(element)
    for number, receiver in enumerate(scene.receivers):
        outline = receiver.outline(scene.elements[-1]).reshape(-1, 3)
        yield SeenPart(f"images[{number}].receiver", receiver.called), outline


def _distance(point: Array, box: Array) -> float:
    """Distance of a point from a box, in sizes of the box; rounded, as bodies may stick out."""
    beyond = np.maximum(box.min(axis=0) - point, point - box.max(axis=0))
    return round(float(np.linalg.norm(np.maximum(beyond, 0.0)) / np.ptp(box)), 3)
