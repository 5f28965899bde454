"""What the mouse does on an image while regions are marked.

A drag draws a rectangle, or takes an edge or a corner of a region along. Clicks are corners of a
polygon, until a double click or Enter. What is drawn becomes an edit when the hand lets go.
"""

from typing import TYPE_CHECKING

import numpy as np

from ui.views.image_link import ImageLink, Place
from ui.views.region_hand import Grip, around, between, grip_at, reshaped
from ui.words import tr

if TYPE_CHECKING:
    from workbench.scene import AnyReceiver, Scene
    from workbench.scene.region import AnyRegion


class RegionTool:
    """Draws and edits regions on an image of a scene.

    A drag draws a rectangle, or moves an edge or a corner of a region. Clicks are corners of a
    polygon, until a double click or Enter. The edit is made on release.
    """

    def __init__(self, link: ImageLink) -> None:
        self._link = link
        self._scene: Scene | None = None
        self._start: Place = (0.0, 0.0)
        self._grip: Grip | None = None
        self._drawn: AnyRegion | None = None
        self._corners: list[Place] = []

    def press(self, scene: "Scene", place: Place, margin: Place) -> None:
        """Begin at a point of the receiver; edges are grabbed within a margin."""
        self._scene, self._start, self._drawn = scene, self._parts(scene.receiver, place), None
        near = np.divide(margin, np.multiply(scene.receiver.half_extent, 2))
        if self._link.draft:  # the next corner of a polygon may be anywhere
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
        """Apply the drawn region."""
        scene, drawn, grip = self._scene, self._drawn, self._grip
        self._link.show_draft(())
        if scene is None or drawn is None:
            return
        if grip is None:
            self._link.regions_drawn.emit((*scene.regions, drawn), tr("new region"))
        elif drawn != scene.regions[grip.number]:
            regions: list[AnyRegion] = list(scene.regions)
            regions[grip.number] = drawn
            self._link.regions_drawn.emit(
                tuple(regions), tr("move of {region}").format(region=drawn.name)
            )

    def click(self, place: Place) -> None:
        """Add a corner to a polygon."""
        if not self._link.draft:  # what was begun before was given up
            self._corners = []
        if self._scene is not None and self._grip is None:
            self._corners.append(self._parts(self._scene.receiver, place))
            self._show(self._corners)

    def close(self) -> None:
        """End the polygon at its last corner."""
        scene = self._scene
        drawn = around(self._corners, self._name) if self._link.draft else None
        self._forget()
        if scene is not None and drawn is not None:
            self._link.regions_drawn.emit((*scene.regions, drawn), tr("new region"))

    def leave(self) -> None:
        """Discard the drawn region; without one, end marking."""
        if self._link.draft:
            self._forget()
        else:
            self._link.set_marking(False)

    @property
    def _name(self) -> str:
        assert self._scene is not None  # since something was drawn
        return tr("Region {number}").format(number=len(self._scene.regions) + 1)

    def _forget(self) -> None:
        self._corners, self._drawn, self._scene = [], None, None
        self._link.show_draft(())

    def _show(self, outline: "list[Place]") -> None:
        assert self._scene is not None
        receiver = self._scene.receiver
        closed = [*outline, outline[0]] if len(outline) > 2 else outline
        places = receiver.middle + 2 * np.reshape(closed, (-1, 2)) * receiver.half_extent
        self._link.show_draft(tuple((float(x), float(y)) for x, y in places))

    @staticmethod
    def _parts(receiver: "AnyReceiver", place: Place) -> Place:
        x, y = np.subtract(place, receiver.middle) / np.multiply(receiver.half_extent, 2)
        return float(x), float(y)
