"""The shape of the exit face as a map."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from ui.views.image_view import ImageView
from workbench.pictures.maps import Extent
from workbench.pictures.surface import ASPECTS, SurfaceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class SurfaceContent:
    """Height over the base, slope or a curvature of the exit face."""

    image: SurfaceImage
    aspect = ASPECTS[0]

    def extent(self, session: "Session") -> Extent:
        """All of the lens."""
        return Extent.around(session.scene.optic.half_width, session.scene.unit)

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """An empty map of the aspect."""
        self.image = SurfaceImage(axes, session.scene, self.aspect)
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the face of a frame."""
        return self.image.update(frame.state.heights[frame.session.scene.optic.face])

    def values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        """Those of the map."""
        return self.image.values

    def unit(self, session: "Session") -> str:
        """The aspect's own."""
        return self.aspect.unit.format(session.scene.unit)


class SurfaceView(ImageView):
    """A map of the exit face, to be chosen above it."""

    _content: SurfaceContent

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(SurfaceContent(), parent=parent)
        self._aspects = QComboBox()
        self._aspects.setAccessibleName("What the map shows")
        for number, aspect in enumerate(ASPECTS):
            self._aspects.addItem(aspect.name[0].upper() + aspect.name[1:])
            self._aspects.setItemData(number, aspect.tip, Qt.ItemDataRole.ToolTipRole)
        self._aspects.currentIndexChanged.connect(self._turn)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self._aspects)
        row.addStretch(1)
        self._box.insertLayout(0, row)
        self._turn()

    def _turn(self) -> None:
        self._content.aspect = aspect = ASPECTS[self._aspects.currentIndex()]
        self._aspects.setToolTip(f"<p>{aspect.tip}</p>")
        self._begin_anew()
