"""The signed error of the irradiance."""

from typing import TYPE_CHECKING

from ui.views.plot_view import PlotView
from workbench.pictures.images import ErrorImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class ErrorView(PlotView):
    """Irradiance minus target at equal flux: red where light is too much, blue where too little."""

    _image: ErrorImage

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = ErrorImage(axes, session.scene, session.target)
        return self._image.artists

    def _change(self, frame: "Frame") -> bool:
        return self._image.update(frame.snapshot.irradiance)
