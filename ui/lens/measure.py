"""Measures the distance of two points on lens and screen."""

import numpy as np
from PySide6.QtCore import QObject, Qt

from ui.views.scene_view import SceneView
from ui.views.tools import Pointer, Tool
from ui.words import tr
from workbench.arrays import Array

_DIGITS = 5


class Measure(Tool):
    """The tool for distances: two clicks, or a drag from point to point."""

    cursor = Qt.CursorShape.CrossCursor

    def __init__(self, view: SceneView, parent: QObject) -> None:
        super().__init__(parent)
        self._view = view
        self._points: tuple[Array, ...] = ()

    @property
    def hint(self) -> str:
        if self._view.exploded:
            return tr("Switch off View > Compress distances first, then measure.")
        if len(self._points) < 2:
            return tr("Click two points on lens or screen, or drag from one to the other.")
        by = self._points[1] - self._points[0]
        x, y, z = (f"{length:.{_DIGITS}g}" for length in by)
        length = f"{np.linalg.norm(by):.{_DIGITS}g}"
        return tr("Distance {length} {unit}: x {x}, y {y}, z {z}").format(
            length=length, unit=self._view.unit, x=x, y=y, z=z
        )

    @property
    def ruled(self) -> tuple[Array, ...]:
        return self._points

    def press(self, at: Pointer) -> bool:
        place = self._place(at)
        if place is None:
            return False
        self._show((*self._points, place) if len(self._points) == 1 else (place,))
        return True

    def drag(self, at: Pointer) -> None:
        place = self._place(at)
        if place is not None:
            self._show((self._points[0], place))

    def cancel(self) -> None:
        self._show(())

    def _place(self, at: Pointer) -> Array | None:
        sight = self._view.sight
        return None if sight is None or self._view.exploded else sight.corner(at.x, at.y)

    def _show(self, points: tuple[Array, ...]) -> None:
        self._points = points
        self._view.refresh()
