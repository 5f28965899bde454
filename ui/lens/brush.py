"""The brush that tools for control points share, and what else they share."""

from collections.abc import Set
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject

from ui.views.keys import ARROWS
from ui.views.tools.tool import Pointer
from ui.words import tr
from workbench.arrays import Mask
from workbench.design.brush import bump, resized
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.powers import written

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_FIRST = 0.1  # of the lens's half-width


class Brush:
    """Finds control points under the pointer and shows which ones it takes along."""

    def __init__(self, view: "SceneView") -> None:
        self._view = view
        self._part = _FIRST  # of the half-width: it stays that with another lens
        self._index: tuple[int, int] | None = None
        self._last: tuple[int, int] | None = None  # place that it had, also while it has none

    @property
    def radius(self) -> float:
        """Scene units; 0 for a single point."""
        net = self._net
        if net is None or not self._part:
            return 0.0
        return max(self._part * max(net.half_width), resized(net, 0.0, 1))

    @property
    def place(self) -> str:
        """Which face it works on, where there are several, to stand before other words."""
        optic, nets = self._view.optic, self._view.nets
        if optic is None or len(nets.faces) < 2:
            return ""
        name = tr(optic.face_in_words(nets.face))
        return f"{name[0].upper()}{name[1:]}. "

    @property
    def words(self) -> str:
        """How large it is."""
        if not self._part:
            return tr("a single point")
        return tr("radius {radius}").format(radius=written(self.radius, self._view.unit, 2))

    def resize(self, steps: int) -> None:
        """Make it larger, or smaller."""
        net = self._net
        if net is not None:
            self._part = resized(net, self.radius, steps) / max(net.half_width)
            self.hold(self._index)
            self._view.refresh()  # also where there is nothing but its size to tell

    def aim(self, at: Pointer) -> tuple[int, int] | None:
        """The control point under the pointer, on whichever face, with the brush around it."""
        index = self._view.nets.aim(at.x, at.y)
        self.hold(index)
        return index

    def follow(self, at: Pointer) -> tuple[int, int] | None:
        """The same on the face where it is already."""
        net = self._view.nets.picture
        index = None if net is None else net.pick(at.x, at.y)
        self.hold(index)
        return index

    def step(self, right: int, up: int) -> tuple[int, int] | None:
        """Go on by so many control points along x and y; where to, or None without a lens.

        It goes from where it was last, even if the pointer has left the lens, and begins in the
        middle.
        """
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
        """Stay around a control point, wherever the pointer goes; or nowhere."""
        self._index = index
        self._last = index or self._last
        self._view.nets.show_brush(index, self.radius)

    def paint(self, over: Mask | None, index: tuple[int, int], value: bool) -> Mask:
        """Locks, shape (n_u, n_v), with a value where it is around a control point."""
        net = self._net
        assert net is not None  # or there would be no control point
        painted = np.zeros(net.shape, dtype=bool) if over is None else over.copy()
        block, weights = bump(net, index, self.radius)
        painted[block] = np.where(weights > 0, value, painted[block])
        return painted

    @property
    def _net(self) -> ControlNet | None:
        """That of the face that is worked on."""
        optic = self._view.optic
        return None if optic is None else freeform_nets(optic)[self._view.nets.face]


class BrushTool(QObject):
    """A tool that works on what the brush takes along; arrow keys move it."""

    shows_net = True
    shows_handles = False
    keys: Set[int] = ARROWS.keys()

    def __init__(self, view: "SceneView", brush: Brush, parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._brush = view, brush

    def repeat_key(self, key: int, fine: bool) -> None:
        """Go on to the next control point."""
        if key in ARROWS:
            self._brush.step(*ARROWS[key])

    def hover(self, at: Pointer | None) -> None:
        """Show what the brush would take along."""
        if at is None:
            self._brush.hold(None)
        else:
            self._brush.aim(at)

    def turn_wheel(self, steps: int) -> None:
        """Change the brush."""
        self._brush.resize(steps)
