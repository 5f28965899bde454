"""The brush that tools for control points share."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ui.views.tools.tool import Pointer
from workbench.design.brush import bump, largest_size, radius_of
from workbench.geometry.surface import ControlNet

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_SIZE = 2  # at first: a point with its neighbours and some more


class Brush:
    """Finds control points under the pointer and shows which ones it takes along.

    Parameters
    ----------
    view : SceneView
        Where the control points are shown.
    """

    def __init__(self, view: "SceneView") -> None:
        self._view = view
        self._size = _SIZE
        self._index: tuple[int, int] | None = None

    @property
    def radius(self) -> float:
        """Scene units; 0 for a single point."""
        lens = self._view.lens
        return 0.0 if lens is None else radius_of(ControlNet.of(lens), self._size)

    @property
    def words(self) -> str:
        """How large it is."""
        if not self._size or self._view.lens is None:
            return "a single point"
        return f"radius {self.radius:.2g} {self._view.unit}"

    def resize(self, steps: int) -> None:
        """Make it larger, or smaller."""
        lens = self._view.lens
        if lens is not None:
            self._size = min(max(self._size + steps, 0), largest_size(ControlNet.of(lens)))
            self.hold(self._index)

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
