"""Irradiance and target along a line across the screen."""

from typing import TYPE_CHECKING

from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QWidget

from ui.views.image_link import ImageLink, Place
from ui.views.plot_view import PlotView
from workbench.pictures.section import SectionCurves

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session


class SectionView(PlotView):
    """A cross-section through the pinned place, which is marked in the images meanwhile.

    Parameters
    ----------
    link : ImageLink, optional
        Tells of clicks in the images, and shows the place there.
    """

    _HAS_BAR = False
    _curves: SectionCurves

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._link = link or ImageLink(self)
        self._place: Place = (0.0, 0.0)
        self._along = QComboBox()
        self._along.addItems(["Along x", "Along y"])
        self._along.setAccessibleName("Direction of the cross-section")
        self._along.currentIndexChanged.connect(self._turn)
        self._where = QLabel()
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self._along)
        row.addWidget(self._where, 1)
        self._box.insertLayout(0, row)
        self._link.pinned.connect(self._pin)

    def showEvent(self, event: QShowEvent) -> None:
        """Mark the place in the images."""
        super().showEvent(event)
        self._link.show_pin(self._place)

    def hideEvent(self, event: QHideEvent) -> None:
        """Mark no place that belongs to nothing."""
        self._link.show_pin(None)
        super().hideEvent(event)

    def _turn(self) -> None:
        self._shown = None
        self._ask()

    def _pin(self, place: Place) -> None:
        if self.isVisible():
            self._place = place
            self._link.show_pin(place)
            self._ask()

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        r_x, r_y = session.scene.screen.half_width
        if abs(self._place[0]) >= r_x or abs(self._place[1]) >= r_y:  # of a larger screen
            self._place = (0.0, 0.0)
            self._link.show_pin(self._place)
        along = "xy"[self._along.currentIndex()]
        self._curves = SectionCurves(axes, session.scene, session.target, along)
        return self._curves.artists

    def _change(self, frame: "Frame") -> bool:
        self._curves.update(frame.snapshot.irradiance, *self._place)
        across = 1 - self._along.currentIndex()
        unit = frame.session.scene.unit
        self._where.setText(
            f"at {'xy'[across]} = {self._place[across]:.3g} {unit}; click an image to move it"
        )
        return False
