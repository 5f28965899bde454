"""What stands in the 3D scene: lens, rays and screens, nets, handles of the source, marked places.

All of it is made anew for another design task, and drawn again for another frame of the same.
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
    from workbench.pictures.face_colours import FaceColours
    from workbench.pictures.lens import LensPicture
    from workbench.pictures.projection import Projection
    from workbench.pictures.source_handles import SourceHandles

_SPOT = 5.0  # pixels
# What stands above the colours of faces.
_SCALES = {"material": "", "height": later("Height"), "curvature": later("Mean curvature")}
_SPOTS = {True: "#ff5a5a", False: "#c81e1e"}  # by dark; as rays that are lost


@dataclass(frozen=True)
class SceneLook:
    """How the 3D scene is drawn.

    Attributes
    ----------
    rays : int
        How many of them along each axis.
    exploded : bool
        Draw long distances short and a large screen small.
    perspective : bool
        Else in parallel.
    by_weight : bool
        Colour rays by the part of their light that arrives, else by where they end.
    faces : FaceColours
        What the colours of freeform faces say.
    exaggerated : bool
        Light the relief of freeform faces as if it were higher.
    colours : str
        Of light, one of `workbench.pictures.axes.UNSIGNED`.
    """

    rays: int = 15
    exploded: bool = False
    perspective: bool = False
    by_weight: bool = False
    faces: "FaceColours" = "material"
    exaggerated: bool = False
    colours: str = LIGHT


class SceneContents:
    """What is drawn into a plotter.

    Parameters
    ----------
    parent : QObject
        Owns the nets.

    Attributes
    ----------
    nets : FaceNets
        The control points.
    picture : LensPicture or None
        Lens, rays, screens and source; like the next two None before the first drawing.
    handles : SourceHandles or None
        What the source is dragged by.
    sight : Projection or None
        What is seen where.
    """

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
        """Put the scene of a design into a plotter, in place of what is there."""
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
        """Mark places of a lens with these heights, shape (n, 3), as long as it is on show."""
        self._marked = heights, places

    def draw(self, frame: "Frame", look: SceneLook, tool: Tool | None) -> None:
        """Draw a lens with its light, and what a tool works on."""
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
        handles.show(frame.source if tool is not None and tool.shows_handles else None)

    def recolour(self, *, dark: bool) -> None:
        """Take the colours of a dark or a light window."""
        self.nets.recolour(dark)
        if self.picture is not None:
            self.picture.recolour(dark)
        if self.handles is not None:
            self.handles.recolour(dark)
        if self._dots is not None:
            self._dots.colour(_SPOTS[dark])

    def close(self) -> None:
        """Let go of what VTK holds."""
        if self.handles is not None:
            self.handles.close()
        self.picture = self.handles = self.sight = self._dots = None
        self.nets.close()
