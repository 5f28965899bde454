"""A map of the exit face, with what is beyond a limit hatched."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.panels.editors import Chooser
from ui.views.image_view import ImageView
from workbench.analysis.manufacture_limits import Limits
from workbench.pictures.manufacture import MAPS, draw_map, map_unit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.analysis.manufacture import SurfaceMaps
    from workbench.files.session import Session

_TIPS = (
    "Thickness along z",
    "Angle between the face and the plane of the entrance face",
    "One over the radius of hollows; zero where there is none",
    "One over the radius of humps; zero where there is none",
)


class FaceMap(ImageView):
    """One of `MAPS`, to be chosen above it."""

    _WAITING = "Computed when the lens rests…"

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent=parent)
        self._maps: SurfaceMaps | None = None
        self._limits = Limits()
        self._drawn: npt.NDArray[np.float64] | None = None
        self.chooser = Chooser()
        self.chooser.setAccessibleName("What the map shows")
        for name in MAPS:
            self.chooser.addItem(name)
        self.chooser.currentIndexChanged.connect(self._turn)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self.chooser)
        self._box.insertLayout(0, row)
        self._turn(0)

    def show_maps(self, frame: "Frame", maps: "SurfaceMaps") -> None:
        """Show the face of the lens of a frame."""
        self._maps = maps
        self.show_frame(frame)
        self._begin_anew()

    def show_limits(self, limits: Limits) -> None:
        """Hatch what is beyond other limits."""
        if limits != self._limits:
            self._limits = limits
            self._begin_anew()

    def show_nothing(self, session: "Session") -> None:
        """Show a design of which there is no lens."""
        self._maps = None
        super().show_nothing(session)

    def _turn(self, number: int) -> None:
        self.chooser.setToolTip(f"<p>{_TIPS[number]}; what is beyond a limit is hatched</p>")
        self._begin_anew()

    def _half_width(self, session: "Session") -> tuple[float, float]:
        return session.scene.lens.half_width

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        if self._maps is not None:
            name = self.chooser.currentText()
            self._drawn = draw_map(axes, name, self._maps, self._limits, session.scene.unit)
        return ()

    def _change_image(self, frame: "Frame") -> bool:
        return False  # another lens has another picture

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        assert self._drawn is not None  # frames come with maps
        return self._drawn

    def _value_unit(self, unit: str) -> str:
        return map_unit(self.chooser.currentText(), unit)
