"""Regions on images: drawing and editing by mouse.

Coordinates are fractions of the receiver's width and height, from its centre.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ui.views.shared_view import Place, SharedView
from ui.words import tr
from workbench.arrays import Array
from workbench.scene import AnyReceiver, PolygonRegion, RectangleRegion, Scene
from workbench.scene.image import AnyRegion

_DIGITS = 4  # of places; less than a pixel of any receiver
_LEAST = 1e-3  # width of a region
_EDGE = 0.5


class Grip(NamedTuple):
    """Grabbed corners of a region: one, or both of an edge."""

    number: int
    corners: tuple[int, ...]


def grip_at(regions: Sequence[AnyRegion], place: Place, margin: Place) -> Grip | None:
    """Return the edge or corner at a point, of the last region that has one there."""
    for number, region in reversed(list(enumerate(regions))):
        corners = _corners_at(_corners_of(region) / margin, np.array(place) / margin)
        if corners:
            return Grip(number, corners)
    return None


def reshaped(region: AnyRegion, grip: Grip, start: Place, place: Place) -> AnyRegion:
    """The region after its grip was dragged from one point to another."""
    corners, held, by = _corners_of(region), list(grip.corners), np.subtract(place, start)
    if isinstance(region, PolygonRegion):
        moved = {k: _within(corners[k] + by) for k in held}
        kept = (moved.get(k, corner) for k, corner in enumerate(region.corners))
        return region.model_copy(update={"corners": tuple(kept)})
    across = np.ptp(corners[held], axis=0) == 0  # an edge moves across itself alone
    opposite = [(k + 2) % 4 for k in held]
    return _framed(region, [*corners[held] + across * by, *corners[opposite]]) or region


def between(start: Place, place: Place, name: str) -> AnyRegion | None:
    """The rectangle between two corners; None if too small to be intended."""
    return _framed(RectangleRegion(name=name), [start, place])


def around(corners: Sequence[Place], name: str) -> PolygonRegion | None:
    """The polygon of these corners without repeated ones; None for less than 3."""
    places = [_within(corner) for corner in corners]
    distinct = tuple(p for k, p in enumerate(places) if p != places[k - 1])
    return PolygonRegion(name=name, corners=distinct) if len(distinct) >= 3 else None


def _corners_of(region: AnyRegion) -> Array:
    """Corners (n, 2) of a polygon, or of the rectangle around another region."""
    if isinstance(region, PolygonRegion):
        return np.array(region.corners)
    (left, bottom), (right, top) = region.outline.min(axis=0), region.outline.max(axis=0)
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])


def _framed(region: AnyRegion, places: Sequence[Any]) -> AnyRegion | None:
    """The region with the bounds of some places; None if too small."""
    inside = [_within(place) for place in places]
    low, high = np.min(inside, axis=0), np.max(inside, axis=0)
    if (high - low < _LEAST).any():
        return None
    center, size = ((low + high) / 2).round(_DIGITS + 1), (high - low).round(_DIGITS)
    return region.model_copy(
        update={"center": tuple(center.tolist()), "size": tuple(size.tolist())}
    )


def _corners_at(corners: Array, place: Array) -> tuple[int, ...]:
    far = np.linalg.norm(corners - place, axis=1)
    if far.min() <= 1:
        return (int(far.argmin()),)
    along = np.roll(corners, -1, axis=0) - corners
    part = ((place - corners) * along).sum(axis=1) / np.square(along).sum(axis=1).clip(1e-300)
    nearest = corners + part.clip(0, 1)[:, None] * along
    beside = np.linalg.norm(nearest - place, axis=1)
    first = int(beside.argmin())
    return (first, (first + 1) % len(corners)) if beside[first] <= 1 else ()


def _within(place: Any) -> Place:
    x, y = np.clip(place, -_EDGE, _EDGE).round(_DIGITS).tolist()
    return x, y


class RegionTool:
    """Draws and edits regions on an image of a scene.

    A drag draws a rectangle, or moves an edge or a corner of a region. Clicks are corners of a
    polygon, until a double click or Enter.
    """

    def __init__(self, shared: SharedView) -> None:
        self._shared = shared
        self._scene: Scene | None = None
        self._start: Place = (0.0, 0.0)
        self._grip: Grip | None = None
        self._drawn: AnyRegion | None = None
        self._corners: list[Place] = []

    def press(self, scene: Scene, place: Place, margin: Place) -> None:
        """Begin at a point of the receiver; edges are grabbed within a margin."""
        self._scene, self._start, self._drawn = scene, self._parts(scene.receiver, place), None
        near = np.divide(margin, np.multiply(scene.receiver.half_extent, 2))
        if self._shared.now.draft:  # the next corner of a polygon may be anywhere
            self._grip = None
        else:
            self._grip = grip_at(scene.regions, self._start, (float(near[0]), float(near[1])))

    def drag(self, place: Place) -> None:
        """Draw a rectangle up to a point, or move an edge there."""
        scene = self._scene
        if scene is None:
            return
        self._corners = []
        here = self._parts(scene.receiver, place)
        if self._grip is None:
            self._drawn = between(self._start, here, self._name)
        else:
            region = scene.regions[self._grip.number]
            self._drawn = reshaped(region, self._grip, self._start, here)
        self._show([] if self._drawn is None else [tuple(p) for p in self._drawn.outline])

    def drop(self) -> None:
        scene, drawn, grip = self._scene, self._drawn, self._grip
        self._shared.show(draft=())
        if scene is None or drawn is None:
            return
        if grip is None:
            self._shared.regions_drawn.emit((*scene.regions, drawn), tr("new region"))
        elif drawn != scene.regions[grip.number]:
            regions: list[AnyRegion] = list(scene.regions)
            regions[grip.number] = drawn
            self._shared.regions_drawn.emit(
                tuple(regions), tr("move of {region}").format(region=drawn.name)
            )

    def click(self, place: Place) -> None:
        if not self._shared.now.draft:  # what was begun before was given up
            self._corners = []
        if self._scene is not None and self._grip is None:
            self._corners.append(self._parts(self._scene.receiver, place))
            self._show(self._corners)

    def close(self) -> None:
        scene = self._scene
        drawn = around(self._corners, self._name) if self._shared.now.draft else None
        self._forget()
        if scene is not None and drawn is not None:
            self._shared.regions_drawn.emit((*scene.regions, drawn), tr("new region"))

    def leave(self) -> None:
        """Discard the drawn region; without one, end marking."""
        if self._shared.now.draft:
            self._forget()
        else:
            self._shared.mark_regions(False)

    @property
    def _name(self) -> str:
        assert self._scene is not None  # since something was drawn
        return tr("Region {number}").format(number=len(self._scene.regions) + 1)

    def _forget(self) -> None:
        self._corners, self._drawn, self._scene = [], None, None
        self._shared.show(draft=())

    def _show(self, outline: list[Place]) -> None:
        assert self._scene is not None
        receiver = self._scene.receiver
        closed = [*outline, outline[0]] if len(outline) > 2 else outline
        places = receiver.middle + 2 * np.reshape(closed, (-1, 2)) * receiver.half_extent
        self._shared.show(draft=tuple((float(x), float(y)) for x, y in places))

    @staticmethod
    def _parts(receiver: AnyReceiver, place: Place) -> Place:
        x, y = np.subtract(place, receiver.middle) / np.multiply(receiver.half_extent, 2)
        return float(x), float(y)
