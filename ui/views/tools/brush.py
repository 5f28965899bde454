"""The brush that tools for control points share."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ui.views.tools.tool import Pointer
from workbench.design.brush import bump, resized
from workbench.geometry.surface import ControlNet

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_FIRST = 0.1  # of the lens's half-width


class Brush:
    """Finds control points under the pointer and shows which ones it takes along.

    Parameters
    ----------
    view : SceneView
        Where the control points are shown.
    """

    def __init__(self, view: "SceneView") -> None:
        self._view = view
        self._part = _FIRST  # of the half-width: it stays that with another lens
        self._index: tuple[int, int] | None = None

    @property
    def radius(self) -> float:
        """Scene units; 0 for a single point."""
        lens = self._view.lens
        if lens is None or not self._part:
            return 0.0
        return max(self._part * max(lens.half_width), resized(ControlNet.of(lens), 0.0, 1))

    @property
    def words(self) -> str:
        """How large it is."""
        return f"radius {self.radius:.2g} {self._view.unit}" if self._part else "a single point"

    def resize(self, steps: int) -> None:
        """Make it larger, or smaller."""
        lens = self._view.lens
        if lens is not None:
            radius = resized(ControlNet.of(lens), self.radius, steps)
            self._part = radius / max(lens.half_width)
            self.hold(self._index)
            self._view.refresh()  # also where there is nothing but its size to tell

    def point_at(self, at: Pointer) -> tuple[int, int] | None:
        """The control point under the pointer, with the brush around it."""
        index = self._view.net.pick(at.x, at.y) if self._view.net else None
        self.hold(index)
        return index

    def hold(self, index: tuple[int, int] | None) -> None:
        """Stay around a control point, wherever the pointer goes; or nowhere."""
        self._index = index
        self._view.show_brush(index, self.radius)

    def touched(self, index: tuple[int, int]) -> npt.NDArray[np.bool_]:
        """What it takes along around a control point, shape (n_u, n_v)."""
        lens = self._view.lens
        assert lens is not None
        touched = np.zeros(lens.control_points, dtype=bool)
        block, weights = bump(ControlNet.of(lens), index, self.radius)
        touched[block] = weights > 0
        return touched
