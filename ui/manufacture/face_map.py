"""A map of a freeform face, with what is beyond a limit hatched."""

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtWidgets import QHBoxLayout

from ui.panels.editors import Chooser
from ui.views.face_choice import FaceChoice
from ui.views.image_view import ImageView
from ui.words import later, tr
from workbench.analysis.manufacture_limits import Limits
from workbench.arrays import Array
from workbench.pictures.axes import Extent
from workbench.pictures.manufacture import MAPS, draw_map, map_unit

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.analysis.manufacture import SurfaceMaps
    from workbench.files.session import Session

_TIPS = later(
    (
        "Thickness along z",
        "Angle between the face and a plane across the axis",
        "One over the radius of concave places; zero elsewhere",
        "One over the radius of convex places; zero elsewhere",
    )
)


class FaceContent:
    """A map of a freeform face, once its lens is looked at."""

    name = next(iter(MAPS))

    def __init__(self) -> None:
        self.maps: SurfaceMaps | None = None
        self.limits = Limits()
        self._drawn = np.zeros((1, 1))

    def extent(self, session: "Session") -> Extent:
        """All of the lens."""
        return Extent.around(session.scene.optic.half_width, session.scene.unit)

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Draw the map; another lens has another picture."""
        if self.maps is not None:
            self._drawn = draw_map(axes, self.name, self.maps, self.limits, session.scene.unit)
        return ()

    def change(self, frame: "Frame") -> bool:
        """Nothing changes within a picture."""
        return False

    def values(self, frame: "Frame") -> Array:
        """Those of the map."""
        return self._drawn

    def unit(self, session: "Session") -> str:
        """Unit of the map, as it stands behind a number."""
        return map_unit(self.name, session.scene.unit).removeprefix("1 ")


class FaceMap(ImageView):
    """One of `MAPS`, to be chosen above it."""

    _content: FaceContent
    _WAITING = later("Computed when no run changes it…")

    def __init__(self) -> None:
        super().__init__(FaceContent())
        self._maps: Mapping[str, SurfaceMaps] = {}
        self.faces = FaceChoice()
        self.faces.currentIndexChanged.connect(self._choose)
        self.chooser = Chooser()
        self.chooser.setAccessibleName(tr("What the map shows"))
        for name in MAPS:
            self.chooser.addItem(tr(name), name)
        self.chooser.currentIndexChanged.connect(self._turn)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self.faces)
        row.addWidget(self.chooser)
        self._box.insertLayout(0, row)
        self._turn(0)

    def show_maps(self, frame: "Frame", maps: "Mapping[str, SurfaceMaps]") -> None:
        """Show the chosen face of the lens of a frame; maps by the names of faces."""
        self._maps = maps
        self.faces.offer(frame.session.scene.optic)
        self.show_frame(frame)
        self._choose()

    def show_limits(self, limits: Limits) -> None:
        """Hatch what is beyond other limits."""
        if limits != self._content.limits:
            self._content.limits = limits
            self._begin_anew()

    def show_nothing(self, session: "Session") -> None:
        """Show a design of which there is no lens."""
        self._maps, self._content.maps = {}, None
        super().show_nothing(session)

    def _choose(self) -> None:
        self._content.maps = self._maps.get(self.faces.face)
        self._begin_anew()

    def _turn(self, number: int) -> None:
        self._content.name = self.chooser.currentData()
        self.chooser.setToolTip(
            f"<p>{tr(_TIPS[number])}{tr('; what is beyond a limit is hatched')}</p>"
        )
        self._begin_anew()
