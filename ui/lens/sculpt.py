"""Shapes the lens: moves control points along the optical axis."""

from collections.abc import Callable, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from ui.lens.brush import Brush, BrushTool
from ui.views.keys import ARROWS
from ui.views.tools.tool import Pointer
from ui.words import tr
from workbench.arrays import Array
from workbench.design.brush import Stroke
from workbench.geometry.faces import FaceArrays

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView
    from workbench.geometry.faces import ControlHeights

_ALONG = np.array([[0.0, 0.0, 1.0]])
_FINE = 1 / 20  # of the movement of the hand or key, with Shift
_RISE = (
    1 / 100
)  # for a press of a key and each repeat: of the height range, or of half the lens's half-width
_RISES: dict[int, int] = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


@dataclass
class _ControlDrag:
    heights: "ControlHeights"  # before
    face: str
    stroke: Stroke
    place: Array  # of the control point in the middle, shape (3,)
    at: Pointer | None  # None with a key
    rise: float = 0.0


class Sculpt(BrushTool):
    """The tool for the heights of control points.

    Parameters
    ----------
    view : SceneView
        Where they are shown.
    brush : Brush
        Which ones move together.
    heights : callable
        Those of the faces of the lens to shape, or None while none may be shaped.

    Attributes
    ----------
    shaped : Signal(ControlHeights, bool)
        New control heights, and whether the drag is over.
    refused : Signal(str)
        Why nothing moves.
    """

    shaped = Signal(object, bool)
    refused = Signal(str)

    cursor = Qt.CursorShape.SizeVerCursor
    keys: Set[int] = ARROWS.keys() | _RISES.keys()

    def __init__(
        self,
        view: "SceneView",
        brush: Brush,
        heights: Callable[[], "ControlHeights | None"],
        parent: QObject,
    ) -> None:
        super().__init__(view, brush, parent)
        self._heights = heights
        self._drag: _ControlDrag | None = None

    @property
    def hint(self) -> str:
        """What can be done with it, in a line."""
        text = tr(
            "{place}Drag control points along z, or use arrows, Page Up and Page "
            "Down; Shift: finely; Esc: back. Brush, "
            "[\N{NO-BREAK SPACE}and\N{NO-BREAK SPACE}]: {words}"
        ).format(place=self._brush.place, words=self._brush.words)
        if self._drag is not None:
            text += tr(". Moved by {rise:+.4g} {unit}").format(
                rise=self._drag.rise, unit=self._view.unit
            )
        return text

    def press(self, at: Pointer) -> bool:
        """Take hold of the control points in the brush."""
        index = self._brush.aim(at)
        if index is None:
            return False
        self._begin(index, at)
        return True

    def drag(self, at: Pointer) -> None:
        """Move them as far as the pointer goes along the axis as it is seen."""
        drag, sight = self._drag, self._view.sight
        if drag is None or drag.at is None or sight is None:
            return
        moved = (at.x - drag.at.x, at.y - drag.at.y)
        (rise,) = sight.movement(drag.place, _ALONG, moved)
        drag.at = at
        self._raise(drag, float(rise), at.fine)

    def press_key(self, key: int) -> None:
        """Take hold of the control points in the brush, wherever the pointer is."""
        index = self._brush.step(0, 0) if key in _RISES else None
        if index is not None:
            self._begin(index)

    def repeat_key(self, key: int, fine: bool) -> None:
        """Move them a little, or the brush."""
        super().repeat_key(key, fine)
        drag, optic = self._drag, self._view.optic
        if key in _RISES and drag is not None and optic is not None:
            low, high = optic.range_of(drag.face) or (0.0, max(optic.half_width) / 2)
            self._raise(drag, _RISES[key] * _RISE * (high - low), fine)

    def release(self) -> None:
        """Leave them there."""
        self._end(moved=True)

    def cancel(self) -> None:
        """Put them back."""
        self._end(moved=False)

    def turn_wheel(self, steps: int) -> None:
        """Change the brush."""
        if self._drag is None:
            super().turn_wheel(steps)

    def _begin(self, index: tuple[int, int], at: Pointer | None = None) -> None:
        optic, nets = self._view.optic, self._view.nets
        heights, net, face = self._heights(), nets.picture, nets.face
        if optic is None or net is None or heights is None:
            return
        stroke = Stroke(optic, face, heights[face], nets.locked, index, self._brush.radius)
        if stroke.moves:
            self._drag = _ControlDrag(heights, face, stroke, net.places[index].copy(), at)
        else:
            self.refused.emit(tr("All control points in the brush are locked; unlock some first."))

    def _raise(self, drag: _ControlDrag, by: float, fine: bool) -> None:
        drag.rise += by * (_FINE if fine else 1.0)
        self._shape(drag, drag.rise, settled=False)

    def _shape(self, drag: _ControlDrag, rise: float, *, settled: bool) -> None:
        shaped = FaceArrays({**drag.heights, drag.face: drag.stroke.raised(rise)})
        self.shaped.emit(shaped, settled)

    def _end(self, *, moved: bool) -> None:
        drag, self._drag = self._drag, None
        if drag is not None:
            self._shape(drag, drag.rise if moved else 0.0, settled=True)
