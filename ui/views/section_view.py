"""Irradiance and target along a line across the receiver.

Arrow keys move the point or line by a pixel, with Shift by ten; with Ctrl only the end of the line.
"""

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from PySide6.QtCore import Qt
from PySide6.QtGui import QHideEvent, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QSizePolicy

from ui.document.frame import Frame
from ui.views.plot_view import PlotView
from ui.views.shared_view import Line, Place, SharedView
from ui.views.tools import ARROWS
from ui.widgets.controls import Chooser, named
from ui.words import later, tr
from workbench.files.session import Session
from workbench.pictures.axes import Extent
from workbench.pictures.section import Cut, SectionCurves, cut_between, cut_through
from workbench.scene import AnyReceiver, Scene

_DIRECTIONS = later({"x": "Along x", "y": "Along y", "line": "Along a line"})
_TIP = later(
    "Cross-section along x or y through the point clicked in an image,\nor along a line drawn "
    "with Shift and drag.\nArrow keys move the point or line by a pixel, with Shift by ten; with "
    "Ctrl the end of the line"
)
_FAR = 10  # pixels, with Shift
_SHORTEST = 0.5  # pixels that are left of a line

_Keys = Qt.KeyboardModifier


class SectionView(PlotView):
    """Cross-section through the pinned point or along the drawn line."""

    _curves: SectionCurves

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._place: Place = (0.0, 0.0)
        self._image_number = self._shared.now.number
        self._line: Line | None = None  # from corner to corner until one is drawn
        titles = {direction: tr(text) for direction, text in _DIRECTIONS.items()}
        self._direction = named(Chooser(titles), tr("Along"))
        self._direction.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self._direction.activated.connect(self._turn)
        corner = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom
        self._over.addWidget(self._direction, 0, 0, corner)
        self._shared.pinned.connect(self._pin)
        self._shared.changed.connect(self._follow)
        self._shared.drawn.connect(self._show_line)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._mark()

    def hideEvent(self, event: QHideEvent) -> None:
        self._shared.show(pin=None, line=None)
        super().hideEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step, keys = ARROWS.get(event.key()), event.modifiers()
        if step is None or self._shown is None or keys & _Keys.AltModifier:
            super().keyPressEvent(event)
            return
        receiver = self._shown.scene.receiver
        pixels = tuple((_FAR if keys & _Keys.ShiftModifier else 1) * k for k in step)
        if self._along != "line":
            (self._place,) = _moved(receiver, pixels, self._place)
        else:
            assert self._line is not None  # since the picture began
            start, end = self._line
            if keys & _Keys.ControlModifier:
                (end,) = _moved(receiver, pixels, end)
            else:
                start, end = _moved(receiver, pixels, start, end)
            if math.dist(receiver.to_pixels(*start), receiver.to_pixels(*end)) >= _SHORTEST:
                self._line = start, end
        self._turn()

    @property
    def _along(self) -> str:
        return str(self._direction.currentData())

    def _turn(self) -> None:
        self._mark()
        self._ask()

    def _mark(self) -> None:
        if self.isVisible():
            by_line = self._along == "line"
            pin, line = (None, self._line) if by_line else (self._place, None)
            self._shared.show(pin=pin, line=line)

    def _pin(self, place: Place) -> None:
        if self.isVisible() and self._along != "line":
            self._place = place
            self._turn()

    def _follow(self) -> None:
        if self._shared.now.number != self._image_number:
            self._image_number = self._shared.now.number
            self._ask()
        line = self._shared.now.line
        if self.isVisible() and line is not None and line != self._line:
            self._show_line(line)

    def _show_line(self, line: Line) -> None:
        self._line = line
        self._direction.choose("line")
        self._turn()

    def _draw(self, session: Session, frame: Frame | None) -> None:
        super()._draw(*self._of_image(session, frame))

    def _begin(self, axes: Axes, session: Session) -> None:
        receiver = session.scene.receiver
        left, right, bottom, top = receiver.bounds

        def beyond(place: Place) -> bool:  # on a larger receiver, or on one elsewhere
            return not (left <= place[0] <= right and bottom <= place[1] <= top)

        if beyond(self._place):
            self._place = receiver.middle
        if self._line is None or any(map(beyond, self._line)):
            self._line = (left, bottom), (right, top)
        self._mark()
        self._curves = SectionCurves(axes, session.scene, session.target)

    def _change(self, frame: Frame) -> None:
        self._curves.update(frame.state.irradiance, self._cut(frame.session.scene))

    def _cut(self, scene: Scene) -> Cut:
        if self._along == "line":
            assert self._line is not None  # since the picture began
            extent = Extent.of_receiver(scene)
            start, end = (f"({extent.number(0, x)}, {extent.number(1, y)})" for x, y in self._line)
            self._direction.setToolTip(
                tr("From {start} to {end} {unit}.\n{tip}").format(
                    start=start, end=end, unit=extent.unit, tip=tr(_TIP)
                )
            )
            return cut_between(scene, *self._line)
        self._direction.setToolTip(tr(_TIP))
        return cut_through(scene, self._along, self._place)


def _moved(receiver: AnyReceiver, pixels: Sequence[int], *places: Place) -> list[Place]:
    at, (low, high) = np.array(places), np.reshape(receiver.bounds, (2, 2)).T
    by = (high - low) / receiver.pixels * pixels
    by = by.clip(low - at.min(axis=0), high - at.max(axis=0))
    return [(x, y) for x, y in (at + by).clip(low, high).tolist()]
