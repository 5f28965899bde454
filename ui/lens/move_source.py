"""Moves and widens the source, and moves elements of a train and the screen."""

import math
from collections.abc import Callable, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from ui.views.tools import ARROWS, Pointer, Tool
from ui.words import tr
from workbench.arrays import Array
from workbench.pictures.source_handles import ElementHandle, Handle, moved
from workbench.scene import Scene

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_ACROSS, _ALONG = np.eye(3)[:2], np.eye(3)[2:]
_FINE = 1 / 10  # of the movement of the hand or key, with Shift
_STEP = 1 / 50  # of a lens's half-width, for a press of a key and each repeat
_DIGITS = 3  # of a lens's half-width, that a place of the source is rounded to
_STEPS: dict[int, tuple[int, int, int]] = {
    **{key: (*across, 0) for key, across in ARROWS.items()},
    Qt.Key.Key_PageUp: (0, 0, 1),
    Qt.Key.Key_PageDown: (0, 0, -1),
}


@dataclass
class _Drag:
    before: Scene
    handle: Handle
    at: Pointer | None  # None with a key
    by: Array  # shape (3,), scene units


class MoveSource(Tool):
    """The tool for the source, for elements of a train, and for the distance of the screen."""

    begun = Signal()
    moved = Signal(object)  # Scene
    cancelled = Signal()

    cursor = Qt.CursorShape.OpenHandCursor
    shows_handles = True
    keys: Set[int] = _STEPS.keys()

    def __init__(
        self, view: "SceneView", scene: Callable[[], Scene | None], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._view, self._scene = view, scene
        self._drag: _Drag | None = None

    @property
    def hint(self) -> str:
        z = self._view.screen_z
        if z is None:
            return self._of_source
        screen = tr("Drag the screen along z: {z} {unit}.").format(z=f"{z:g}", unit=self._view.unit)
        return f"{screen} {self._of_source}"

    @property
    def _of_source(self) -> str:
        source = self._view.source
        if self._view.has_train:
            return tr("Drag the source or an element, with Ctrl along z. Shift: fine, Esc: cancel.")
        if source is None or source.place is None:
            return tr("Collimated light has no position")
        text = tr(
            "Drag the source, with Ctrl along z; or use arrows, Page Up and Page Down. Shift: "
            "fine, Esc: cancel. "
        )
        if len(source.corners):
            text += tr("Drag corners to resize. ")
        lengths = (
            f"{tr(field.in_window.title)} {_words(getattr(source, field.name), field.times)}"
            for field in source.fields()
            if field.measure.power == 1
        )
        return f"{text}{', '.join(lengths)} {self._view.unit}"

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
        place = _place_of(drag.before, drag.handle)
        if place is None:
            return
        middle = np.add(place, drag.by)
        along = drag.handle == "screen" or (at.along and not isinstance(drag.handle, int))
        to = _ALONG if along else _ACROSS
        gone = (at.x - drag.at.x, at.y - drag.at.y)
        drag.at = at
        self._move(drag, sight.movement(middle, to, gone) @ to, at.fine)

    def press_key(self, key: int) -> None:
        source = self._view.source
        if source is not None and source.place is not None:
            self._begin("middle")

    def repeat_key(self, key: int, fine: bool) -> None:
        drag, optic = self._drag, self._view.optic
        if drag is not None and optic is not None:
            self._move(drag, _STEP * max(optic.half_width) * np.array(_STEPS[key]), fine)

    def release(self) -> None:
        self._drag = None

    def cancel(self) -> None:
        drag, self._drag = self._drag, None
        if drag is not None:
            self.cancelled.emit()

    def _begin(self, handle: Handle, at: Pointer | None = None) -> None:
        scene = self._scene()
        if scene is not None:
            self._drag = _Drag(scene, handle, at, np.zeros(3))
            self.begun.emit()

    def _move(self, drag: _Drag, by: Array, fine: bool) -> None:
        optic = self._view.optic
        if optic is not None:
            drag.by = drag.by + by * (_FINE if fine else 1.0)
            digits = _DIGITS - math.floor(math.log10(max(optic.half_width)))
            self.moved.emit(moved(drag.before, drag.handle, drag.by, digits))


def _place_of(scene: Scene, handle: Handle) -> tuple[float, float, float] | None:
    if isinstance(handle, ElementHandle):
        return scene.elements[handle.number].position
    if handle == "screen":
        x, y, z = scene.receiver.middle_in_scene.tolist()
        return x, y, z
    return scene.source.place


def _words(lengths: tuple[float, ...], times: float) -> str:
    return f"({', '.join(f'{times * length:g}' for length in lengths)})"
