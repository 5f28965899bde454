"""The loss over the iterations."""

from typing import TYPE_CHECKING

from ui.views.plot_view import PlotView
from workbench.pictures.loss import LossCurve

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class LossView(PlotView):
    """Loss of this run and of those that it continues."""

    _HAS_BAR = False
    _curve: LossCurve

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._curve = LossCurve(axes)
        return self._curve.artists

    def _change(self, frame: "Frame") -> bool:
        ahead = frame.snapshot.iterations - frame.snapshot.iteration
        return self._curve.update(frame.losses, frame.losses.size + ahead, frame.stage_starts)
