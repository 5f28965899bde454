"""The shape of the exit face as a map."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from ui.views.image_view import ImageView
from workbench.pictures.surface import ASPECTS, SurfaceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class SurfaceView(ImageView):
    """Height over the base, slope or a curvature of the exit face."""

    _image: SurfaceImage

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent=parent)
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
        self._aspect = ASPECTS[self._aspects.currentIndex()]
        self._aspects.setToolTip(f"<p>{self._aspect.tip}</p>")
        self._begin_anew()

    def _half_width(self, session: "Session") -> tuple[float, float]:
        return session.scene.lens.half_width

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = SurfaceImage(axes, session.scene, self._aspect)
        return self._image.artists

    def _change_image(self, frame: "Frame") -> bool:
        return self._image.update(frame.snapshot.control_points)

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        return self._image.values

    def _value_unit(self, unit: str) -> str:
        return self._aspect.unit.format(unit)
