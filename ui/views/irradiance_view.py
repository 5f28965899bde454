"""The irradiance on the screen."""

from typing import TYPE_CHECKING

from ui.views.plot_view import PlotView
from workbench.pictures.images import IrradianceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class IrradianceView(PlotView):
    """Flux per area as the optimiser sees it, on a scale that follows the target."""

    _image: IrradianceImage

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = IrradianceImage(axes, session.scene, session.target)
        return self._image.artists

    def _change(self, frame: "Frame") -> bool:
        return self._image.update(frame.snapshot.irradiance)
