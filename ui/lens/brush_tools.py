"""Tools for control points: brush, sculpting and locking."""

from collections.abc import Callable, Set
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from ui.views.scene_view import SceneView
from ui.views.tools import ARROWS, Pointer, Tool
from ui.words import tr
from workbench.arrays import Array, Mask
from workbench.design.brush import Stroke, bump, resized
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.powers import written

_FIRST = 0.1  # of the lens's half-width


class Brush:
    """Brush over control points: position, radius and highlighting."""

    def __init__(self, view: SceneView) -> None:
        self._view = view
        self._part = _FIRST  # of the half-width: it stays that with another lens
        self._index: tuple[int, int] | None = None
        self._last: tuple[int, int] | None = None  # place that it had, also while it has none

    @property
    def radius(self) -> float:
        """Radius in scene units; 0 for a single point."""
        net = self._net
        if net is None or not self._part:
            return 0.0
        return max(self._part * max(net.half_width), resized(net, 0.0, 1))

    @property
    def place(self) -> str:
        """Name of the edited face and a full stop, where there are several faces."""
        title = self._view.face_title
        return f"{title}. " if title else ""

    @property
    def words(self) -> str:
        if not self._part:
            return tr("a single point")
        return tr("radius {radius}").format(radius=written(self.radius, self._view.unit, 2))

    def resize(self, steps: int) -> None:
        net = self._net
        if net is not None:
            self._part = resized(net, self.radius, steps) / max(net.half_width)
            self.hold(self._index)
            self._view.refresh()  # also where its size alone has changed

    def aim(self, at: Pointer) -> tuple[int, int] | None:
        """Move the brush to the pointer, on any face; return the control point."""
        index = self._view.nets.aim(at.x, at.y)
        self.hold(index)
        return index

    def follow(self, at: Pointer) -> tuple[int, int] | None:
        net = self._view.nets.picture
        index = None if net is None else net.pick(at.x, at.y)
        self.hold(index)
        return index

    def step(self, right: int, up: int) -> tuple[int, int] | None:
        """Move the brush by control points along x and y; None without a lens."""
        net = self._net
        if net is None:
            return None
        shape = net.shape
        last = self._last or (shape[0] // 2, shape[1] // 2)
        i, j = (
            min(max(at + by, 0), n - 1) for at, by, n in zip(last, (right, up), shape, strict=True)
        )
        self.hold((i, j))
        return i, j

    def hold(self, index: tuple[int, int] | None) -> None:
        """Fix the brush at a control point, or hide it."""
        self._index = index
        self._last = index or self._last
        self._view.nets.show_brush(index, self.radius)

    def paint(self, over: Mask | None, index: tuple[int, int], value: bool) -> Mask:
        """Return locks (n_u, n_v) with a value under the brush."""
        net = self._net
        assert net is not None  # or there would be no control point
        painted = np.zeros(net.shape, dtype=bool) if over is None else over.copy()
        block, weights = bump(net, index, self.radius)
        painted[block] = np.where(weights > 0, value, painted[block])
        return painted

    @property
    def _net(self) -> ControlNet | None:
        optic = self._view.optic
        return None if optic is None else freeform_nets(optic)[self._view.nets.face]


class BrushTool(Tool):
    """A tool with a brush, which arrow keys move."""

    shows_net = True
    begins: Set[int] = frozenset()  # keys whose action begins where the brush is

    def __init__(self, view: SceneView, brush: Brush, parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._brush = view, brush
        self.keys = ARROWS.keys() | self.begins

    def press(self, at: Pointer) -> bool:
        index = self._brush.aim(at)
        if index is not None:
            self._begin(index, at)
        return index is not None

    def press_key(self, key: int) -> None:
        index = self._brush.step(0, 0) if key in self.begins else None
        if index is not None:
            self._begin(index, None)

    def _begin(self, index: tuple[int, int], at: Pointer | None) -> None: ...

    def repeat_key(self, key: int, fine: bool) -> None:
        if key in ARROWS:
            self._brush.step(*ARROWS[key])

    def hover(self, at: Pointer | None) -> None:
        if at is None:
            self._brush.hold(None)
        else:
            self._brush.aim(at)

    def turn_wheel(self, steps: int) -> None:
        self._brush.resize(steps)


_PAINTS: set[int] = {Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter}


@dataclass
class _Paint:
    face: str
    before: Mask | None
    locked: Mask | None
    value: bool  # that the brush leaves


class Lock(BrushTool):
    """The tool for locks: the first point decides whether it locks or unlocks."""

    painted = Signal(str, object, bool)  # str, ndarray, bool

    cursor = Qt.CursorShape.PointingHandCursor
    begins = _PAINTS

    def __init__(
        self, view: SceneView, brush: Brush, may: Callable[[], bool], parent: QObject
    ) -> None:
        super().__init__(view, brush, parent)
        self._may = may
        self._paint: _Paint | None = None

    @property
    def hint(self) -> str:
        locked = self._view.nets.locked
        count = 0 if locked is None else int(locked.sum())
        return tr(
            "{place}Paint control points to lock or unlock them; or use arrows and Space. Brush "
            "([\N{NO-BREAK SPACE}and\N{NO-BREAK SPACE}]): {words}. {count} locked"
        ).format(place=self._brush.place, words=self._brush.words, count=count)

    def drag(self, at: Pointer) -> None:
        index = self._brush.follow(at)
        if index is not None:
            self._touch(index)

    def release(self) -> None:
        paint, self._paint = self._paint, None
        if paint is not None:
            self.painted.emit(paint.face, paint.locked, paint.value)

    def cancel(self) -> None:
        paint, self._paint = self._paint, None
        if paint is not None:
            self._view.nets.show_locked(paint.before)

    def _begin(self, index: tuple[int, int], at: Pointer | None) -> None:
        if not self._may():
            return
        nets = self._view.nets
        before = nets.locked
        self._paint = _Paint(nets.face, before, before, before is None or not before[index])
        self._touch(index)

    def _touch(self, index: tuple[int, int]) -> None:
        paint = self._paint
        if paint is not None:
            # A new array each time, by which the view knows that it has changed.
            paint.locked = self._brush.paint(paint.locked, index, paint.value)
            self._view.nets.show_locked(paint.locked)


_FINE = 1 / 20  # of the movement of the hand or key, with Shift
_RISE = (
    1 / 100
)  # for a press of a key and each repeat: of the height range, or of half the lens's half-width
_RISES: dict[int, int] = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


@dataclass
class _ControlDrag:
    heights: ControlHeights  # before
    face: str
    stroke: Stroke
    place: Array  # of the control point in the middle, shape (3,)
    along: Array  # the axis of its element, shape (1, 3)
    at: Pointer | None  # None with a key
    rise: float = 0.0


class Sculpt(BrushTool):
    """The tool for the heights of control points."""

    shaped = Signal(object, bool)  # ControlHeights, bool
    refused = Signal(str)

    cursor = Qt.CursorShape.SizeVerCursor
    begins = _RISES.keys()

    def __init__(
        self,
        view: SceneView,
        brush: Brush,
        heights: Callable[[], ControlHeights | None],
        parent: QObject,
    ) -> None:
        super().__init__(view, brush, parent)
        self._heights = heights
        self._drag: _ControlDrag | None = None

    @property
    def hint(self) -> str:
        text = tr(
            "{place}Drag control points along z, or use arrows, Page Up and Page Down. Shift: "
            "fine, Esc: cancel. Brush ([\N{NO-BREAK SPACE}and\N{NO-BREAK SPACE}]): {words}"
        ).format(place=self._brush.place, words=self._brush.words)
        if self._drag is not None:
            text += tr(". Moved by {rise:+.4g} {unit}").format(
                rise=self._drag.rise, unit=self._view.unit
            )
        return text

    def drag(self, at: Pointer) -> None:
        drag, sight = self._drag, self._view.sight
        if drag is None or drag.at is None or sight is None:
            return
        moved = (at.x - drag.at.x, at.y - drag.at.y)
        (rise,) = sight.movement(drag.place, drag.along, moved)
        drag.at = at
        self._raise(drag, float(rise), at.fine)

    def repeat_key(self, key: int, fine: bool) -> None:
        super().repeat_key(key, fine)
        drag, optic = self._drag, self._view.optic
        if key in _RISES and drag is not None and optic is not None:
            low, high = optic.range_of(drag.face) or (0.0, max(optic.half_width) / 2)
            self._raise(drag, _RISES[key] * _RISE * (high - low), fine)

    def release(self) -> None:
        self._end(moved=True)

    def cancel(self) -> None:
        self._end(moved=False)

    def turn_wheel(self, steps: int) -> None:
        if self._drag is None:
            super().turn_wheel(steps)

    def _begin(self, index: tuple[int, int], at: Pointer | None) -> None:
        optic, nets = self._view.optic, self._view.nets
        heights, net, face = self._heights(), nets.picture, nets.face
        if optic is None or net is None or heights is None:
            return
        stroke = Stroke(optic, face, heights[face], nets.locked, index, self._brush.radius)
        if stroke.moves:
            along = optic.turn[None, :, 2]
            self._drag = _ControlDrag(heights, face, stroke, net.places(index), along, at)
        else:
            self.refused.emit(
                tr("All control points under the brush are locked. Unlock some first.")
            )

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
