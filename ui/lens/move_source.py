"""Moves source, elements and screen, widens the source, and thickens lenses."""

import math
from collections.abc import Callable, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from ui.panels.edits import field_in_words
from ui.views.scene_view import SceneView
from ui.views.tools import ARROWS, Pointer, Tool
from ui.words import tr
from workbench.arrays import Array
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.pictures.handles import Handle

_FINE = 1 / 10  # of the movement of the hand or key, with Shift
_STEP = 1 / 50  # of a lens's half-width, for a press of a key and each repeat
_DIGITS = 3  # of a lens's half-width, that lengths are rounded to
_STEPS: dict[int, tuple[int, int, int]] = {
    **{key: (*across, 0) for key, across in ARROWS.items()},
    Qt.Key.Key_PageUp: (0, 0, 1),
    Qt.Key.Key_PageDown: (0, 0, -1),
}
_BY_KEYS = "source.position"


@dataclass
class _Drag:
    before: Scene
    handle: "Handle"
    at: Pointer | None  # None with a key
    by: Array  # shape (3,), scene units


class MoveSource(Tool):
    """The tool for source, elements, thicknesses of lenses, and distance of the screen."""

    moved = Signal(object, str)  # Scene, text of the step
    cancelled = Signal()

    cursor = Qt.CursorShape.OpenHandCursor
    shows_handles = True
    keys: Set[int] = _STEPS.keys()

    def __init__(self, view: SceneView, scene: Callable[[], Scene | None], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._scene = view, scene
        self._drag: _Drag | None = None
        self._value = ""  # of the field that is pointed at, or was dragged last

    @property
    def hint(self) -> str:
        text = tr(
            "Drag a handle, with Ctrl along z: source, elements, thickness at the lower rim, "
            "distance of a screen. Shift: fine, Esc: cancel."
        )
        by_keys = tr("Arrows, Page Up and Page Down move the source.")
        paths = [] if self._view.handles is None else [h.path for h in self._view.handles.shown]
        value = f"{self._value}." if self._value else ""
        return " ".join(filter(None, (value, text, by_keys if _BY_KEYS in paths else "")))

    def press(self, at: Pointer) -> bool:
        handle = self._view.handles.pick(at.x, at.y) if self._view.handles else None
        if handle is None:
            return False
        self._begin(handle, at)
        return True

    def drag(self, at: Pointer) -> None:
        drag, sight = self._drag, self._view.sight
        if drag is None or drag.at is None or sight is None:
            return
        to = drag.handle.directions[at.along]
        gone = (at.x - drag.at.x, at.y - drag.at.y)
        drag.at = at
        self._move(drag, sight.movement(drag.handle.place + drag.by, to, gone) @ to, at.fine)

    def hover(self, at: Pointer | None) -> None:
        handles, frame = self._view.handles, self._view.frame
        if handles is None or frame is None:
            return
        handle = None if at is None else handles.pick(at.x, at.y)
        value = "" if handle is None else field_in_words(frame.session.scene, handle.path)
        if value != self._value:
            self._value = value
            self._view.refresh()

    def press_key(self, key: int) -> None:
        for handle in self._view.handles.shown if self._view.handles else ():
            if handle.path == _BY_KEYS:
                self._begin(handle)

    def repeat_key(self, key: int, fine: bool) -> None:
        drag, optic = self._drag, self._view.optic
        if drag is not None and optic is not None:
            self._move(drag, _STEP * max(optic.half_width) * np.array(_STEPS[key]), fine)

    def release(self) -> None:
        self._drag = self.dragged = None

    def cancel(self) -> None:
        drag, self._value = self._drag, ""
        self.release()
        if drag is not None:
            self.cancelled.emit()

    def _begin(self, handle: "Handle", at: Pointer | None = None) -> None:
        scene = self._scene()
        if scene is not None:
            self._drag = _Drag(scene, handle, at, np.zeros(3))

    def _move(self, drag: _Drag, by: Array, fine: bool) -> None:
        optic = self._view.optic
        if optic is None:
            return
        drag.by = drag.by + by * (_FINE if fine else 1.0)
        digits = _DIGITS - math.floor(math.log10(max(optic.half_width)))
        self.dragged = scene = drag.handle.change(drag.before, drag.by, digits)
        self._value = field_in_words(scene, drag.handle.path)
        self.moved.emit(scene, drag.handle.text)
        self._view.refresh()
