"""Irradiance and target along a line across the screen."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QWidget

from ui.views.image_link import ImageLink, Line, Place
from ui.views.plot_view import PlotView
from workbench.pictures.section import Cut, SectionCurves, cut_between, cut_through

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session
    from workbench.scene import Scene

_DIRECTIONS = ("x", "y", "line")


class SectionView(PlotView):
    """A cross-section through the pinned place or along the drawn line, marked in the images.

    Parameters
    ----------
    link : ImageLink, optional
        Tells of clicks and lines in the images, and shows place or line there.
    """

    _HAS_BAR = False
    _curves: SectionCurves

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._link = link or ImageLink(self)
        self._place: Place = (0.0, 0.0)
        self._line: Line | None = None  # from corner to corner until one is drawn
        self._direction = QComboBox()
        self._direction.addItems(["Along x", "Along y", "Along a line"])
        self._direction.setAccessibleName("Direction of the cross-section")
        self._direction.currentIndexChanged.connect(self._turn)
        self._where = QLabel()
        self._where.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self._direction)
        row.addWidget(self._where, 1)
        self._box.insertLayout(0, row)
        self._link.pinned.connect(self._pin)
        self._link.changed.connect(self._follow)
        self._link.drawn.connect(self._take)

    def showEvent(self, event: QShowEvent) -> None:
        """Mark place or line in the images."""
        super().showEvent(event)
        self._mark()

    def hideEvent(self, event: QHideEvent) -> None:
        """Mark nothing that belongs to nothing."""
        self._link.show_pin(None)
        self._link.show_line(None)
        super().hideEvent(event)

    @property
    def _along(self) -> str:
        return _DIRECTIONS[self._direction.currentIndex()]

    def _turn(self) -> None:
        self._mark()
        self._ask()

    def _mark(self) -> None:
        if self.isVisible():
            by_line = self._along == "line"
            self._link.show_line(self._line if by_line else None)
            self._link.show_pin(None if by_line else self._place)

    def _pin(self, place: Place) -> None:
        if self.isVisible() and self._along != "line":
            self._place = place
            self._link.show_pin(place)
            self._ask()

    def _follow(self) -> None:
        """Take over a line while it is being drawn."""
        if self.isVisible() and self._link.line not in (None, self._line):
            assert self._link.line is not None
            self._take(self._link.line)

    def _take(self, line: Line) -> None:
        self._line = line
        with QSignalBlocker(self._direction):
            self._direction.setCurrentIndex(_DIRECTIONS.index("line"))
        self._turn()

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        r_x, r_y = session.scene.screen.half_width

        def beyond(place: Place) -> bool:  # on a larger screen
            return abs(place[0]) > r_x or abs(place[1]) > r_y

        if beyond(self._place):
            self._place = (0.0, 0.0)
        if self._line is None or any(map(beyond, self._line)):
            self._line = (-r_x, -r_y), (r_x, r_y)
        self._mark()
        self._curves = SectionCurves(axes, session.scene, session.target)
        return self._curves.artists

    def _change(self, frame: "Frame") -> bool:
        scene = frame.session.scene
        self._where.setText(self._tell(scene.unit))
        return self._curves.update(frame.snapshot.irradiance, self._cut(scene))

    def _cut(self, scene: "Scene") -> Cut:
        if self._along == "line":
            assert self._line is not None  # since the picture began
            return cut_between(scene, *self._line)
        return cut_through(scene, self._along, self._place)

    def _tell(self, unit: str) -> str:
        if self._along == "line":
            assert self._line is not None
            start, end = (f"({x:.3g}, {y:.3g})" for x, y in self._line)
            return f"from {start} to {end} {unit}; Shift and drag on an image draws another"
        across = "yx"["xy".index(self._along)]
        at = self._place["xy".index(across)]
        return f"at {across} = {at:.3g} {unit}; click an image to move it"
