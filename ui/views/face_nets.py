"""Control nets of the freeform faces in the 3D view; one face is active.

1. State changes here and is drawn by `draw`; `changed` requests that.
2. Where a line of sight meets several nets, the nearest one is picked.
"""

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from workbench.arrays import Mask
from workbench.geometry.faces import NO_LOCKS, ControlPoint

if TYPE_CHECKING:
    from workbench.geometry.faces import ControlHeights, Locks
    from workbench.pictures.control_net import ControlNetPicture
    from workbench.pictures.projection import Projection
    from workbench.scene import Optic


class FaceNets(QObject):
    """Control points that are shown, picked, marked, brushed and locked."""

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._pictures: dict[str, ControlNetPicture] = {}
        self._sight: Projection | None = None
        self._face = ""
        self._marked: ControlPoint | None = None
        self._brush: tuple[tuple[int, int], float] | None = None
        self._locks: dict[str, Mask] = {}
        self._locks_of_design = NO_LOCKS
        self._pickable = False

    @property
    def face(self) -> str:
        """Name of the active face; empty before the first drawing."""
        return self._face

    @property
    def faces(self) -> tuple[str, ...]:
        """Names of all faces, in the order of the light."""
        return tuple(self._pictures)

    @property
    def picture(self) -> "ControlNetPicture | None":
        """Control points of the active face; None before the first drawing."""
        return self._pictures.get(self._face)

    @property
    def brush(self) -> tuple[tuple[int, int], float] | None:
        """Control point in the middle of the brush, and its radius in scene units."""
        return self._brush

    @property
    def locked(self) -> Mask | None:
        """Locked control points of the active face, shape (n_u, n_v)."""
        return self._locks.get(self._face)

    def pick(self, x: float, y: float) -> ControlPoint | None:
        """Return the control point of any face at a pixel, while nets are shown."""
        if self._sight is None or not self._pickable:
            return None
        start, end = self._sight.line(x, y)
        found = {face: net.pick(x, y) for face, net in self._pictures.items()}
        depths = {
            face: float((self._pictures[face].places[index] - start) @ (end - start))
            for face, index in found.items()
            if index is not None
        }
        if not depths:
            return None
        face = min(depths, key=depths.__getitem__)
        index = found[face]
        return None if index is None else ControlPoint(face, index)

    def aim(self, x: float, y: float) -> tuple[int, int] | None:
        """Activate the face at a pixel and return its control point there."""
        point = self.pick(x, y)
        if point is None:
            return None
        self.choose(point.face)
        return point.index

    def choose(self, face: str) -> None:
        """Activate a face."""
        if face != self._face:
            self._face, self._brush = face, None
            self.changed.emit()

    def show_brush(self, index: tuple[int, int] | None, radius: float) -> None:
        """Highlight the control points of a brush, radius in scene units; None for no brush."""
        brush = None if index is None else (index, radius)
        if brush != self._brush:
            self._brush = brush
            self.changed.emit()

    def show_locked(self, locked: Mask | None) -> None:
        """Show other locked control points of the active face."""
        if locked is None:
            self._locks.pop(self._face, None)
        else:
            self._locks[self._face] = locked
        self.changed.emit()

    def show_locks(self, locks: "Locks") -> None:
        """Show the locks of a design."""
        if locks is not self._locks_of_design:
            self._locks_of_design, self._locks = locks, dict(locks)
            self.changed.emit()

    def mark(self, point: ControlPoint | None) -> None:
        """Show the control points with a marked one for picking; None hides them."""
        if point != self._marked:
            self._marked = point
            self.changed.emit()

    def begin(self, plotter: Any, optic: "Optic", *, dark: bool) -> None:
        """Set the element whose nets are drawn."""
        # Late: these take seconds to load.
        from workbench.geometry.surface import freeform_nets
        from workbench.pictures.control_net import ControlNetPicture
        from workbench.pictures.projection import Projection

        self._pictures = {
            face: ControlNetPicture(plotter, optic, face, dark=dark)
            for face in freeform_nets(optic)
        }
        self._sight = Projection(plotter)
        if self._face not in self._pictures:
            self._face, self._brush = optic.face, None

    def draw(self, heights: "ControlHeights", shown: bool) -> None:
        """Set the heights; return whether the active net is shown."""
        self._pickable = shown or self._marked is not None
        for face, net in self._pictures.items():
            here = face == self._face
            # What was meant for another net is left out until the tool is moved.
            shape = net.places.shape[:2]
            brush, marked, locked = self._brush, self._marked, self._locks.get(face)
            if brush is not None and (brush[0][0] >= shape[0] or brush[0][1] >= shape[1]):
                brush = None
            net.update(heights[face])
            net.mark(marked.index if marked is not None and marked.face == face else None)
            net.show(shown and here)
            net.brush(*(brush if brush is not None and here else (None, 0.0)))
            net.lock(locked if locked is not None and locked.shape == shape else None)

    def recolour(self, dark: bool) -> None:
        """Change between dark and light background."""
        for net in self._pictures.values():
            net.recolour(dark)

    def close(self) -> None:
        """Release the plotter."""
        self._pictures, self._sight = {}, None
