"""The signed error of the irradiance."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ui.views.screen_image_view import ScreenImageView
from workbench.pictures.images import ErrorImage, signed_error

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class ErrorView(ScreenImageView):
    """Irradiance minus target at equal flux: red where light is too much, blue where too little."""

    _image: ErrorImage

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = ErrorImage(axes, session.scene, session.target)
        return self._image.artists

    def _change_image(self, frame: "Frame") -> bool:
        return self._image.update(frame.snapshot.irradiance)

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        session = frame.session
        return signed_error(session.scene, session.target, frame.snapshot.irradiance)
