"""An image of light, in an even or a logarithmic scale."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtWidgets import QToolButton, QWidget

from ui.views.image_link import ImageLink
from ui.views.image_view import ImageView
from workbench.pictures.images import IrradianceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class LightImageView(ImageView):
    """Flux per area, on a scale that follows the target."""

    _image: IrradianceImage

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(link, parent)
        self._logarithmic = False
        self._button = QToolButton()
        self._button.setText("Log")
        self._button.setCheckable(True)
        self._button.setToolTip("Logarithmic colours, over three decades: stray light is seen")
        self._button.toggled.connect(self._link.set_logarithmic)
        self._bottom.addWidget(self._button)

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = IrradianceImage(axes, session.scene, session.target)
        self._logarithmic = False
        return self._image.artists

    def _change_image(self, frame: "Frame") -> bool:
        return self._image.update(self._shown_values(frame))

    def _adapt(self) -> bool:
        everything = super()._adapt()
        if self._link.logarithmic == self._logarithmic:
            return everything
        self._logarithmic = self._link.logarithmic
        self._button.setChecked(self._logarithmic)
        self._image.set_logarithmic(self._logarithmic)
        return True

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        raise NotImplementedError
