"""A view with one matplotlib canvas."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from ui.views.canvas import Canvas
from ui.views.view import View, look_alike

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class PlotView(View):
    """Keeps a canvas, and on it a picture of one design."""

    _HAS_BAR = True

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._canvas = Canvas(self, bar=self._HAS_BAR)
        self._box.addWidget(self._canvas)
        self._shown: Session | None = None

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        if frame is None or self._shown is None or not look_alike(self._shown, session):
            self._canvas.animate(self._begin(self._canvas.begin(), session))
        self._shown = session
        everything = self._adapt()
        if frame is not None:
            everything |= self._change(frame)
        self._canvas.show_changes(everything)

    def _begin_anew(self) -> None:
        """Draw another picture of the same design."""
        self._shown = None
        self._ask()

    def _recolour(self) -> None:
        self._canvas.recolour()

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Put an empty picture of a design on the axes; the artists that will change."""
        raise NotImplementedError

    def _adapt(self) -> bool:
        """Follow what is neither design nor frame; whether more than the artists changed."""
        return False

    def _change(self, frame: "Frame") -> bool:
        """Bring the artists up to date; whether more than these changed."""
        raise NotImplementedError
