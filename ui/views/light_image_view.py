"""An image of light, in an even or a logarithmic scale."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtWidgets import QWidget

from ui.views.image_link import ImageLink
from ui.views.screen_image_view import ScreenImageView
from workbench.pictures.images import IrradianceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class LightImageView(ScreenImageView):
    """Flux per area, on a scale that follows the target."""

    _NAME: str
    _image: IrradianceImage

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(link, parent)
        self._look: tuple[bool, str] = (False, "")  # logarithmic, colours
        self._logarithmic = self._add_tool(
            "logarithmic",
            "Logarithmic colours",
            "Logarithmic colours, over three decades: stray light is seen",
        )
        self._logarithmic.toggled.connect(self._link.set_logarithmic)

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = IrradianceImage(axes, session.scene, session.target, self._NAME)
        self._look = (False, "")
        return self._image.artists

    def _change_image(self, frame: "Frame") -> bool:
        return self._image.update(self._shown_values(frame))

    def _adapt(self) -> bool:
        everything, look = super()._adapt(), (self._link.logarithmic, self._link.colours)
        if look == self._look:
            return everything
        self._look = look
        self._logarithmic.setChecked(self._link.logarithmic)
        self._image.set_logarithmic(self._link.logarithmic)
        self._image.set_colours(self._link.colours)
        return True

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        raise NotImplementedError
