"""Parts of a scene seen at a pixel, and handles that drag source, elements, lenses and screen.

The handles of a source that is small on screen stand beside it, so that the source itself can still
be dragged. They follow the camera: each rendering places them anew.
"""

import weakref
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.actors import PointMarkers
from workbench.pictures.camera import box_around
from workbench.pictures.projection import Projection
from workbench.scene import Scene
from workbench.scene.paths import value_at

_COLOUR = {True: "#ffffff", False: "#000000"}  # by dark
_SIZE = 11.0  # pixels
_PICK_DISTANCE = 14.0  # pixels; farther away no handle is picked, and no source
_CORNER_DISTANCE = 3 * _PICK_DISTANCE  # least pixels from the middle to a corner handle
_INSIDE = (9, 9)  # points of a source, along x and y, that drag all of it
_ACROSS, _ALONG = np.eye(3)[:2], np.eye(3)[2:]
_BEYOND = 1.03  # of its extents: the handle of a screen, which the screen would half hide


@dataclass(frozen=True)
class Handle:
    """A place in the scene whose drag changes a field."""

    path: str
    """Of the field, as in files."""
    text: str
    """What a drag does, for the list of steps."""
    place: Array
    """Where the handle is drawn, shape (3,)."""
    change: Callable[[Scene, Array, int], Scene]
    """Return a scene, not checked, after a drag by a vector (3,), rounded to some decimals."""
    directions: tuple[Array, Array] = (_ACROSS, _ALONG)
    """Unit vectors (k, 3) of a drag, and of one with Ctrl."""
    area: Array | None = None
    """Places (n, 3) that drag it as well, unless a handle is as near."""
    middle: Array | None = None
    """Place from which it keeps a distance in pixels."""


def handles_of(scene: Scene) -> list[Handle]:
    """Return the handles of a scene."""
    return [*_of_source(scene), *_of_elements(scene), *_of_screen(scene)]


def _of_source(scene: Scene) -> list[Handle]:
    source = scene.source
    if source.place is None:
        return []
    middle = np.array(source.place)
    whole = Handle(
        "source.position",
        Message("move the source"),
        middle,
        _move_source,
        area=source.seen(_INSIDE),
    )
    corners = [
        Handle(
            "source.half_width",
            Message("move the source"),
            corner,
            partial(_widen_source, number),
            directions=(_ACROSS, _ACROSS),
            middle=middle,
        )
        for number, corner in enumerate(source.corners)
    ]
    return [*corners, whole]


def _move_source(scene: Scene, by: Array, digits: int) -> Scene:
    source = scene.source
    if source.place is None:
        return scene
    source = source.placed(_rounded(source.place, by, digits))
    return scene.model_copy(update={"source": source})


def _widen_source(number: int, scene: Scene, by: Array, digits: int) -> Scene:
    """Widen or narrow the source on both sides of its middle."""
    source = scene.source
    return scene.model_copy(update={"source": source.widened(source.corners[number] + by, digits)})


def _of_elements(scene: Scene) -> list[Handle]:
    handles = []
    for number, element in enumerate(scene.elements):
        # At the rims: the source may be close to the vertex of the first element.
        x, y, z = 0.0, element.half_width[1], element.position[2]
        path = f"elements[{number}]"
        handles.append(
            Handle(
                f"{path}.position",
                Message("move the element"),
                element.in_scene(np.array([x, y, z])),
                partial(_move_element, number),
            )
        )
        if (thickness := value_at(element, "thickness")) is not None:  # of lenses
            back, front = element.in_scene(np.array([[x, -y, z + thickness], [x, -y, z]]))
            axis = ((back - front) / thickness)[None]
            handles.append(
                Handle(
                    f"{path}.thickness",
                    Message("change the thickness"),
                    back,
                    partial(_thicken, number, axis[0]),
                    directions=(axis, axis),
                )
            )
    return handles


def _move_element(number: int, scene: Scene, by: Array, digits: int) -> Scene:
    return _changed(scene, number, "position", partial(_rounded, by=by, digits=digits))


def _thicken(number: int, axis: Array, scene: Scene, by: Array, digits: int) -> Scene:
    return _changed(scene, number, "thickness", lambda d: round(d + float(axis @ by), digits))


def _changed(scene: Scene, number: int, field: str, change: Callable[[Any], Any]) -> Scene:
    element = scene.elements[number]
    changed = element.model_copy(update={field: change(value_at(element, field))})
    return scene.with_element(number, changed)


def _of_screen(scene: Scene) -> list[Handle]:
    if scene.receiver.stands_at is None:
        return []
    top = scene.receiver.outline(scene.elements[-1], _BEYOND)[:, -1].mean(axis=0)
    return [
        Handle(
            "images[0].receiver.position",
            Message("move the screen"),
            top,
            _move_screen,
            directions=(_ALONG, _ALONG),
        )
    ]


def _move_screen(scene: Scene, by: Array, digits: int) -> Scene:
    z = round(scene.receiver.plane_z + float(by[2]), digits)
    return scene.with_receiver(scene.receiver.moved_to(z))


def _rounded(
    place: tuple[float, float, float], by: Array, digits: int
) -> tuple[float, float, float]:
    x, y, z = (np.round(np.add(place, by), digits) + 0.0).tolist()  # without -0
    return x, y, z


class Handles:
    """Draws handles on a plotter of the caller; none at first."""

    def __init__(self, plotter: Any, *, dark: bool = False) -> None:
        self._markers = PointMarkers(plotter, _SIZE, round=False)
        self._projection = Projection(plotter)
        self.shown: list[Handle] = []
        self._renderer, handles = plotter.renderer, weakref.ref(self)

        def follow(*_: object) -> None:
            if (present := handles()) is not None:
                present._place()

        self._observer = self._renderer.AddObserver("StartEvent", follow)
        self.recolour(dark)

    def show(self, scene: Scene | None) -> None:
        """Show the handles of a scene, or none."""
        self.shown = [] if scene is None else handles_of(scene)
        self._place()

    def close(self) -> None:
        """Stop following the camera."""
        self._renderer.RemoveObserver(self._observer)

    def recolour(self, dark: bool) -> None:
        """Change between dark and light background."""
        self._markers.colour(_COLOUR[dark])

    def pick(self, x: float, y: float) -> Handle | None:
        """Return the handle at a pixel from the lower left; None if there is none."""
        return self._nearest(x, y, self._places()) or self._nearest(
            x, y, [handle.place if handle.area is None else handle.area for handle in self.shown]
        )

    def _nearest(self, x: float, y: float, places: list[Array]) -> Handle | None:
        away = [self._projection.away(each.reshape(-1, 3), x, y).min() for each in places]
        if not away or min(away) > _PICK_DISTANCE:
            return None
        return self.shown[int(np.argmin(away))]

    def _place(self) -> None:
        self._markers.place(np.reshape(self._places(), (-1, 3)))

    def _places(self) -> list[Array]:
        """Where the handles are drawn, each of shape (3,)."""
        return [
            handle.place if handle.middle is None else self._apart(handle.place, handle.middle)
            for handle in self.shown
        ]

    def _apart(self, place: Array, middle: Array) -> Array:
        seen, around = self._projection.pixels(np.array([place, middle]))
        away = float(np.linalg.norm(seen - around))
        # A corner seen at the middle itself has no direction on screen.
        times = max(1.0, _CORNER_DISTANCE / max(away, 1e-9)) if away > 0 else 1.0
        return np.asarray(middle + times * (place - middle))


class SeenPart(NamedTuple):
    """A part of a scene: its path, and what it is called within a sentence."""

    path: str
    called: str


def part_at(scene: Scene, sight: Projection, x: float, y: float) -> SeenPart | None:
    """Return the part of a scene, as drawn, at a pixel; None where there is none."""
    body, (start, end) = sight.corner(x, y), sight.line(x, y)
    source = scene.source.seen(_INSIDE)
    if len(source):
        away = sight.away(source, x, y)
        nearest = source[away.argmin()]
        hidden = body is not None and (body - nearest) @ (end - start) < 0
        if away.min() <= _PICK_DISTANCE and not hidden:
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
