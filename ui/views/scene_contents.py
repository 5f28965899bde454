"""Contents of the 3D view: lens, rays, receivers, nets, source handles, marked points.

They are made again for another design task, and updated for another frame of the same task.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QObject

from ui.shown.frame import some_rays
from ui.views.face_nets import FaceNets
from ui.views.tools.tool import Tool
from ui.words import later, tr
from workbench.arrays import Array
from workbench.pictures.images import LIGHT

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights
    from workbench.pictures.actors import PointMarkers
    from workbench.pictures.lens import LensPicture
    from workbench.pictures.projection import Projection
    from workbench.pictures.source_handles import SourceHandles
    from workbench.pictures.surface import FaceColours

_SPOT = 5.0  # pixels
# What stands above the colours of faces.
_SCALES = {"material": "", "height": later("Height"), "curvature": later("Mean curvature")}
_SPOTS = {True: "#ff5a5a", False: "#c81e1e"}  # by dark; as rays that are lost


@dataclass(frozen=True)
class SceneLook:
    """Options of the 3D view."""

    rays: int = 15
    exploded: bool = False
    perspective: bool = False
    by_weight: bool = False
    faces: "FaceColours" = "material"
    exaggerated: bool = False
    colours: str = LIGHT


class SceneContents:
    """Contents of a plotter."""

    def __init__(self, parent: QObject) -> None:
        self.nets = FaceNets(parent)
        self.picture: LensPicture | None = None
        self.handles: SourceHandles | None = None
        self.sight: Projection | None = None
        self._dots: PointMarkers | None = None
        self._marked: tuple[ControlHeights, Array] | None = None

    def begin(
        self, plotter: Any, session: "Session", look: SceneLook, *, dark: bool
    ) -> "LensPicture":
        """Replace the contents by those of a design."""
        # Late: these take seconds to load.
        from workbench.pictures.actors import PointMarkers
        from workbench.pictures.lens import LensPicture
        from workbench.pictures.projection import Projection
        from workbench.pictures.source_handles import SourceHandles

        plotter.clear_actors()
        self.picture = LensPicture(
            plotter,
            session.scene,
            session.target,
            dark=dark,
            explode=look.exploded,
            perspective=look.perspective,
            by_weight=look.by_weight,
        )
        self.nets.begin(plotter, session.scene.optic, dark=dark)
        if self.handles is not None:
            self.handles.close()
        self.handles = SourceHandles(plotter, dark=dark)
        self._dots = PointMarkers(plotter, _SPOT)
        self._dots.colour(_SPOTS[dark])
        self.sight = Projection(plotter)
        return self.picture

    def mark(self, heights: "ControlHeights", places: Array) -> None:
        """Mark points (n, 3) of a lens with these heights, while it is shown."""
        self._marked = heights, places

    def draw(self, frame: "Frame", look: SceneLook, tool: Tool | None) -> None:
        """Draw a lens with its light, and the state of tools."""
        picture, handles, dots, marked = self.picture, self.handles, self._dots, self._marked
        assert picture is not None and handles is not None and dots is not None  # made by `begin`
        picture.set_colours(look.colours)
        picture.set_faces(look.faces, look.exaggerated, tr(_SCALES[look.faces]))
        paths, lit = some_rays(frame.paths, look.rays), frame.state.irradiance
        further = [light.irradiance for light in frame.state.further]
        picture.update(frame.surfaces, paths, lit, frame.source, further)
        here = marked is not None and marked[0] == frame.state.heights
        dots.place(marked[1] if marked is not None and here else np.zeros((0, 3)))
        self.nets.draw(frame.state.heights, tool is not None and tool.shows_net)
        if tool is not None and tool.shows_handles:
            elements = frame.session.scene.elements
            # At their rims: the source may be close to the vertex of the first one.
            rims = [
                element.in_scene(np.array([0.0, element.half_width[1], element.position[2]]))
                for element in elements
            ]
            handles.show(frame.source, np.reshape(rims if len(rims) > 1 else [], (-1, 3)))
        else:
            handles.show(None)

    def recolour(self, *, dark: bool) -> None:
        """Change between dark and light background."""
        self.nets.recolour(dark)
        if self.picture is not None:
            self.picture.recolour(dark)
        if self.handles is not None:
            self.handles.recolour(dark)
        if self._dots is not None:
            self._dots.colour(_SPOTS[dark])

    def close(self) -> None:
        """Release VTK objects."""
        if self.handles is not None:
            self.handles.close()
        self.picture = self.handles = self.sight = self._dots = None
        self.nets.close()
