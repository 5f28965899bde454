"""Contents of the 3D view: lens, rays, receivers, nets, handles, marked points.

They are created for a design task, and updated for each frame. Tools work on one face at a time;
the pointer picks the net nearest to the eye.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.document.frame import Frame, some_rays
from ui.views.shared_view import ViewOptions
from ui.views.tools import Tool
from ui.words import later, tr
from workbench.analysis.manufacture import exceeding_points
from workbench.arrays import Array, Mask
from workbench.files.session import Session
from workbench.geometry.faces import NO_LOCKS, ControlHeights, ControlPoint, Locks
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.pictures.control_net import ControlNetPicture
    from workbench.pictures.projection import Projection


class FaceNets(QObject):
    """Control points that are shown, picked, marked, brushed and locked."""

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._pictures: dict[str, ControlNetPicture] = {}
        self._sight: Projection | None = None
        self.face = ""  # id of the selected one; empty before the first drawing
        self._marked: ControlPoint | None = None
        self.brush: tuple[tuple[int, int], float] | None = None
        self._locks: dict[str, Mask] = {}
        self._locks_of_design = NO_LOCKS
        self._pickable = False

    @property
    def faces(self) -> tuple[str, ...]:
        """Ids of all freeform faces, in the order of the light."""
        return tuple(self._pictures)

    @property
    def picture(self) -> "ControlNetPicture | None":
        """The control points of that face; None before the first drawing."""
        return self._pictures.get(self.face)

    @property
    def locked(self) -> Mask | None:
        """Shown locks of the selected face, shape (n_u, n_v)."""
        return self._locks.get(self.face)

    def pick(self, x: float, y: float) -> ControlPoint | None:
        """Return the shown control point of any face at a window position."""
        if self._sight is None or not self._pickable:
            return None
        start, end = self._sight.line(x, y)
        found = {face: net.pick(x, y) for face, net in self._pictures.items()}
        depths = {
            face: float((self._pictures[face].places(index) - start) @ (end - start))
            for face, index in found.items()
            if index is not None
        }
        if not depths:
            return None
        face = min(depths, key=depths.__getitem__)
        index = found[face]
        return None if index is None else ControlPoint(face, index)

    def aim(self, x: float, y: float) -> tuple[int, int] | None:
        """Select the face at a window position; return its control point there."""
        point = self.pick(x, y)
        if point is None:
            return None
        self.choose(point.face)
        return point.index

    def choose(self, face: str) -> None:
        if face != self.face:
            self.face, self.brush = face, None
            self.changed.emit()

    def show_brush(self, index: tuple[int, int] | None, radius: float) -> None:
        brush = None if index is None else (index, radius)
        if brush != self.brush:
            self.brush = brush
            self.changed.emit()

    def show_locked(self, locked: Mask | None) -> None:
        if locked is None:
            self._locks.pop(self.face, None)
        else:
            self._locks[self.face] = locked
        self.changed.emit()

    def show_locks(self, locks: Locks) -> None:
        if locks is not self._locks_of_design:
            self._locks_of_design, self._locks = locks, dict(locks)
            self.changed.emit()

    def mark(self, point: ControlPoint | None) -> None:
        if point != self._marked:
            self._marked = point
            self.changed.emit()

    def begin(self, plotter: Any, scene: Scene, *, dark: bool) -> None:
        # Late: these take seconds to load.
        from workbench.geometry.surface import freeform_nets
        from workbench.pictures.control_net import ControlNetPicture
        from workbench.pictures.projection import Projection

        self._pictures = {
            face: ControlNetPicture(plotter, optic, face, dark=dark)
            for optic in scene.optics
            for face in freeform_nets(optic)
        }
        self._sight = Projection(plotter)
        if self.face not in self._pictures:
            self.face, self.brush = scene.optic.designed_face, None

    def draw(self, heights: ControlHeights, shown: bool) -> None:
        self._pickable = shown or self._marked is not None
        for face, net in self._pictures.items():
            here = face == self.face
            # What was meant for another net is left out until the tool is moved.
            shape = net.shape
            brush, marked, locked = self.brush, self._marked, self._locks.get(face)
            if brush is not None and (brush[0][0] >= shape[0] or brush[0][1] >= shape[1]):
                brush = None
            net.update(heights[face])
            net.mark(marked.index if marked is not None and marked.face == face else None)
            net.show(shown and here)
            net.brush(*(brush if brush is not None and here else (None, 0.0)))
            net.lock(locked if locked is not None and locked.shape == shape else None)

    def recolour(self, dark: bool) -> None:
        for net in self._pictures.values():
            net.recolour(dark)

    def close(self) -> None:
        self._pictures, self._sight = {}, None


_SPOT = 5.0  # pixels
# What stands above the colours of faces.
_SCALES = {
    "material": "",
    "height": later("Height"),
    "curvature": later("Mean curvature"),
    "limits": later("within limits | exceeded"),  # columns of VTK, one over each colour
}
_RULES = {True: "#ffffff", False: "#101820"}  # by dark
Spots = tuple[ControlHeights, Array]
"""Marked points (n, 3) of a lens, and its heights."""

_SPOTS = {True: "#ff5a5a", False: "#c81e1e"}  # by dark; as rays that are lost


class SceneContents:
    """Contents of a plotter for one design."""

    def __init__(
        self, plotter: Any, session: Session, options: ViewOptions, nets: FaceNets, *, dark: bool
    ) -> None:
        # Late: these take seconds to load.
        from workbench.pictures.actors import PointMarkers, Rule
        from workbench.pictures.handles import Handles
        from workbench.pictures.lens import LensPicture
        from workbench.pictures.projection import Projection

        plotter.clear_actors()
        self.picture = LensPicture(
            plotter,
            session.scene,
            session.target,
            dark=dark,
            explode=options.exploded,
            perspective=options.perspective,
            by_weight=options.by_weight,
        )
        self._nets = nets
        nets.begin(plotter, session.scene, dark=dark)
        self.handles = Handles(plotter, dark=dark)
        self._dots = PointMarkers(plotter, _SPOT)
        self._dots.colour(_SPOTS[dark])
        self._rule = Rule(plotter, _RULES[dark])
        self.sight = Projection(plotter)

    def draw(
        self, frame: Frame, options: ViewOptions, tool: Tool | None, spots: Spots | None
    ) -> None:
        self.picture.set_colours(options.colours)
        beyond: dict[str, Mask] = {}
        if options.faces == "limits":
            for optic in frame.session.scene.optics:
                beyond |= exceeding_points(
                    optic, frame.surfaces, frame.state.heights, options.limits
                )
        scale = tr(_SCALES[options.faces])
        self.picture.set_faces(options.faces, options.exaggerated, scale, beyond)
        paths, lit = some_rays(frame.paths, options.rays), frame.state.irradiance
        further = [light.irradiance for light in frame.state.further]
        self.picture.update(frame.surfaces, paths, lit, frame.source, further)
        self._rule.place(() if tool is None else tool.ruled)
        here = spots is not None and spots[0] == frame.state.heights
        self._dots.place(spots[1] if spots is not None and here else np.zeros((0, 3)))
        self._nets.draw(frame.state.heights, tool is not None and tool.shows_net)
        if tool is None or not tool.shows_handles:
            self.handles.show(None)
        else:
            own = {"source": frame.source}  # a stage of a run may have its own
            self.handles.show(tool.dragged or frame.session.scene.model_copy(update=own))

    def recolour(self, *, dark: bool) -> None:
        for part in (self._nets, self.picture, self.handles):
            part.recolour(dark)
        self._dots.colour(_SPOTS[dark])
        self._rule.colour(_RULES[dark])

    def close(self) -> None:
        self.handles.close()
        self._nets.close()
