"""Shapes the lens: drags control points along the optical axis."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QObject, Qt, Signal

from ui.views.tools.brush import Brush
from ui.views.tools.tool import Pointer
from workbench.design.brush import Stroke

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

Array = npt.NDArray[np.float64]

_ALONG = np.array([[0.0, 0.0, 1.0]])
_FINE = 1 / 20  # of the movement of the hand, with Shift


@dataclass
class _Drag:
    stroke: Stroke
    place: Array  # of the control point in the middle, shape (3,)
    at: Pointer
    rise: float = 0.0


class Sculpt(QObject):
    """The tool for the heights of control points.

    Parameters
    ----------
    view : SceneView
        Where they are shown.
    brush : Brush
        Which ones move together.
    heights : callable
        Those of the lens to shape, or None while none may be shaped.

    Attributes
    ----------
    shaped : Signal(ndarray, bool)
        New control heights, and whether the drag is over.
    refused : Signal(str)
        Why nothing moves.
    """

    shaped = Signal(object, bool)
    refused = Signal(str)

    cursor = Qt.CursorShape.SizeVerCursor
    shows_net = True
    shows_handles = False

    def __init__(
        self, view: "SceneView", brush: Brush, heights: Callable[[], Array | None], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._view, self._brush, self._heights = view, brush, heights
        self._drag: _Drag | None = None

    @property
    def hint(self) -> str:
        """What can be done with it, in a line."""
        text = (
            "Drag control points along z; Shift: finely; Esc: back. "
            f"Brush, [ and ]: {self._brush.words}"
        )
        if self._drag is not None:
            text += f". Moved by {self._drag.rise:+.4g} {self._view.unit}"
        return text

    def press(self, at: Pointer) -> bool:
        """Take hold of the control points in the brush."""
        index, lens = self._brush.point_at(at), self._view.lens
        if index is None or lens is None or self._view.net is None:
            return False
        heights = self._heights()
        if heights is None:
            return True
        stroke = Stroke(lens, heights, self._view.locked, index, self._brush.radius)
        if not stroke.moves:
            self.refused.emit("All control points in the brush are locked; unlock some first.")
            return True
        self._drag = _Drag(stroke, self._view.net.places[index].copy(), at)
        return True

    def drag(self, at: Pointer) -> None:
        """Move them as far as the pointer goes along the axis as it is seen."""
        drag, sight = self._drag, self._view.sight
        if drag is None or sight is None:
            return
        moved = (at.x - drag.at.x, at.y - drag.at.y)
        (rise,) = sight.movement(drag.place, _ALONG, moved)
        drag.rise += float(rise) * (_FINE if at.fine else 1.0)
        drag.at = at
        self.shaped.emit(drag.stroke.raised(drag.rise), False)

    def release(self) -> None:
        """Leave them there."""
        self._end(moved=True)

    def cancel(self) -> None:
        """Put them back."""
        self._end(moved=False)

    def hover(self, at: Pointer | None) -> None:
        """Show which ones would move."""
        if at is None:
            self._brush.hold(None)
        else:
            self._brush.point_at(at)

    def turn_wheel(self, steps: int) -> None:
        """Change the brush."""
        if self._drag is None:
            self._brush.resize(steps)

    def _end(self, *, moved: bool) -> None:
        drag, self._drag = self._drag, None
        if drag is not None:
            self.shaped.emit(drag.stroke.raised(drag.rise if moved else 0.0), True)
