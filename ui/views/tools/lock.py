"""Locks and unlocks control points by painting over them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QObject, Qt, Signal

from ui.views.tools.brush import Brush
from ui.views.tools.tool import Pointer

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

Mask = npt.NDArray[np.bool_]


@dataclass
class _Paint:
    before: Mask | None
    locked: Mask
    value: bool  # that the brush leaves


class Lock(QObject):
    """The tool for locks: the first point decides whether it locks or unlocks.

    Parameters
    ----------
    view : SceneView
        Where control points and locks are shown.
    brush : Brush
        How many are painted at once.
    may : callable
        Whether locks may be changed now.

    Attributes
    ----------
    painted : Signal(ndarray, str)
        New locks, shape (n_u, n_v), and what was done.
    """

    painted = Signal(object, str)

    cursor = Qt.CursorShape.PointingHandCursor
    shows_net = True
    shows_handles = False

    def __init__(
        self, view: "SceneView", brush: Brush, may: Callable[[], bool], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._view, self._brush, self._may = view, brush, may
        self._paint: _Paint | None = None

    @property
    def hint(self) -> str:
        """What can be done with it, in a line."""
        locked = self._view.locked
        count = 0 if locked is None else int(locked.sum())
        return (
            "Paint over control points to lock them, or unlock them where you begin on a lock. "
            f"Brush, [ and ]: {self._brush.words}. {count} locked"
        )

    def press(self, at: Pointer) -> bool:
        """Begin to paint."""
        index, lens = self._brush.point_at(at), self._view.lens
        if index is None or lens is None:
            return False
        if not self._may():
            return True
        before = self._view.locked
        locked = np.zeros(lens.control_points, dtype=bool) if before is None else before.copy()
        self._paint = _Paint(before, locked, not locked[index])
        self.drag(at)
        return True

    def drag(self, at: Pointer) -> None:
        """Paint what the brush touches."""
        index, paint = self._brush.point_at(at), self._paint
        if index is None or paint is None:
            return
        # A new array each time: whoever shows it tells by that that it has changed.
        paint.locked = np.where(self._brush.touched(index), paint.value, paint.locked)
        self._view.show_locked(paint.locked)

    def release(self) -> None:
        """Leave it so."""
        paint, self._paint = self._paint, None
        if paint is not None:
            self.painted.emit(paint.locked, "lock" if paint.value else "unlock")

    def cancel(self) -> None:
        """Take it back."""
        paint, self._paint = self._paint, None
        if paint is not None:
            self._view.show_locked(paint.before)

    def hover(self, at: Pointer | None) -> None:
        """Show which ones would be painted."""
        if at is None:
            self._brush.hold(None)
        else:
            self._brush.point_at(at)

    def turn_wheel(self, steps: int) -> None:
        """Change the brush."""
        self._brush.resize(steps)
