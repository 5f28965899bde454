"""Locks and unlocks control points by painting over them."""

from collections.abc import Callable, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal

from ui.lens.brush import Brush, BrushTool
from ui.views.keys import ARROWS
from ui.views.tools.tool import Pointer
from ui.words import tr
from workbench.arrays import Mask

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_PAINTS: set[int] = {Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter}


@dataclass
class _Paint:
    face: str
    before: Mask | None
    locked: Mask | None
    value: bool  # that the brush leaves


class Lock(BrushTool):
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
    painted : Signal(str, ndarray, bool)
        The name of a face, its new locks, shape (n_u, n_v), and what was done.
    """

    painted = Signal(str, object, bool)

    cursor = Qt.CursorShape.PointingHandCursor
    keys: Set[int] = ARROWS.keys() | _PAINTS

    def __init__(
        self, view: "SceneView", brush: Brush, may: Callable[[], bool], parent: QObject
    ) -> None:
        super().__init__(view, brush, parent)
        self._may = may
        self._paint: _Paint | None = None

    @property
    def hint(self) -> str:
        """What can be done with it, in a line."""
        locked = self._view.nets.locked
        count = 0 if locked is None else int(locked.sum())
        return tr(
            "{place}Paint over control points to lock them, or unlock them where you "
            "begin on a lock; or use arrows and Space. Brush, "
            "[\N{NO-BREAK SPACE}and\N{NO-BREAK SPACE}]: {words}. {count} locked"
        ).format(place=self._brush.place, words=self._brush.words, count=count)

    def press(self, at: Pointer) -> bool:
        """Begin to paint."""
        index = self._brush.aim(at)
        if index is None:
            return False
        self._begin(index)
        return True

    def drag(self, at: Pointer) -> None:
        """Paint what the brush touches."""
        index = self._brush.follow(at)
        if index is not None:
            self._touch(index)

    def press_key(self, key: int) -> None:
        """Paint what the brush touches, wherever the pointer is."""
        index = self._brush.step(0, 0) if key in _PAINTS else None
        if index is not None:
            self._begin(index)

    def release(self) -> None:
        """Leave it so."""
        paint, self._paint = self._paint, None
        if paint is not None:
            self.painted.emit(paint.face, paint.locked, paint.value)

    def cancel(self) -> None:
        """Take it back."""
        paint, self._paint = self._paint, None
        if paint is not None:
            self._view.nets.show_locked(paint.before)

    def _begin(self, index: tuple[int, int]) -> None:
        if not self._may():
            return
        nets = self._view.nets
        before = nets.locked
        self._paint = _Paint(nets.face, before, before, before is None or not before[index])
        self._touch(index)

    def _touch(self, index: tuple[int, int]) -> None:
        paint = self._paint
        if paint is not None:
            # A new array each time: whoever shows it tells by that that it has changed.
            paint.locked = self._brush.paint(paint.locked, index, paint.value)
            self._view.nets.show_locked(paint.locked)
