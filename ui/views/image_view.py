"""A view of an image on the screen: zoomed, moved and read together with others like it.

The wheel zooms about the pointer, dragging moves, a double click shows the whole screen again, a
click pins the place that cross-sections go through.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from ui.views.image_link import ImageLink, Part, Place
from ui.views.plot_view import PlotView
from workbench.pictures.images import pixel_at

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.frame import Frame
    from workbench.files.session import Session
    from workbench.scene import Screen

_NARROWEST = 250  # pixels; less would be labels alone
_ZOOM = 1.25  # for each step of the wheel
_NEAREST = 200.0  # times; a pixel is large enough then
_DRAG = 4.0  # pixels that a click may shake
_PIN = "#8a8f98"  # seen on light and dark


class ImageView(PlotView):
    """Shows an image of the screen, and its value under the pointer.

    Parameters
    ----------
    link : ImageLink, optional
        What it has in common with other images; by default it stands alone.
    """

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumWidth(_NARROWEST)
        self._link = link or ImageLink(self)
        self._axes: Axes | None = None
        self._pin_lines: list[Any] = []
        self._values: npt.NDArray[np.float64] | None = None
        self._pointed: Place | None = None
        self._grip: tuple[Place, Place] | None = None  # pixels and place where a drag began
        self._dragged = False
        self._readout = QLabel()
        self._readout.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._readout.setAccessibleName("Value under the pointer")
        self._bottom = QHBoxLayout()
        self._bottom.setContentsMargins(6, 0, 6, 2)
        self._bottom.addWidget(self._readout, 1)
        self._box.addLayout(self._bottom)
        self._link.changed.connect(self._ask)
        self._link.pointed.connect(self._point)
        canvas = self._canvas
        canvas.mpl_connect("scroll_event", self._zoom)
        canvas.mpl_connect("button_press_event", self._press)
        canvas.mpl_connect("button_release_event", self._release)
        canvas.mpl_connect("motion_notify_event", self._move)
        canvas.mpl_connect("axes_leave_event", lambda _: self._link.pointed.emit(None))

    def show_nothing(self, session: "Session") -> None:
        """Show a design of which there is no image."""
        self._values = None
        super().show_nothing(session)
        self._read()

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        before = self._shown
        if before is not None and before.scene.screen.half_width != session.scene.screen.half_width:
            self._link.show_part(None)
        self._axes = axes
        artists = self._begin_image(axes, session)
        self._pin_lines = [
            axes.axvline(0, color=_PIN, linewidth=0.9, linestyle="--", visible=False),
            axes.axhline(0, color=_PIN, linewidth=0.9, linestyle="--", visible=False),
        ]
        return [*artists, *self._pin_lines]

    def _change(self, frame: "Frame") -> bool:
        everything = self._change_image(frame)
        self._values = self._shown_values(frame)
        self._read()
        return everything

    def _adapt(self) -> bool:
        """Follow the link; whether the axes changed."""
        axes, link = self._axes, self._link
        assert axes is not None and self._shown is not None
        for line in self._pin_lines:
            line.set_visible(link.pin is not None)
        if link.pin is not None:
            upright, level = self._pin_lines
            upright.set_xdata([link.pin[0]] * 2)
            level.set_ydata([link.pin[1]] * 2)
        part = link.part or _whole(self._shown.scene.screen)
        if part == (*axes.get_xlim(), *axes.get_ylim()):
            return False
        axes.set_xlim(*part[:2])
        axes.set_ylim(*part[2:])
        return True

    def _begin_image(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Put an empty image on the axes; the artists that will change."""
        raise NotImplementedError

    def _change_image(self, frame: "Frame") -> bool:
        """Bring the image up to date; whether more than its artists changed."""
        raise NotImplementedError

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        """What the image shows, shape (n_y, n_x)."""
        raise NotImplementedError

    def _point(self, place: Place | None) -> None:
        self._pointed = place
        self._read()

    def _read(self) -> None:
        """Tell position and value under the pointer."""
        if self._pointed is None or self._shown is None or self._values is None:
            self._readout.clear()
            return
        scene, (x, y) = self._shown.scene, self._pointed
        pixel = pixel_at(scene, x, y)
        # Another screen may have come, whose first image has not.
        if pixel is not None and self._values.shape == scene.screen.pixels[::-1]:
            value = f"{self._values[pixel]:.4g} / {scene.unit}²"
            self._readout.setText(f"{value} at x = {x:.3g}, y = {y:.3g} {scene.unit}")

    def _zoom(self, event: Any) -> None:
        if event.inaxes is self._axes and self._shown is not None:
            screen, factor = self._shown.scene.screen, _ZOOM**-event.step
            left, right, bottom, top = self._link.part or _whole(screen)
            if right - left > 2 * screen.half_width[0] / _NEAREST or factor > 1:
                x, y = event.xdata, event.ydata
                sides = [x + factor * (side - x) for side in (left, right)]
                sides += [y + factor * (side - y) for side in (bottom, top)]
                self._show_part(sides)

    def _press(self, event: Any) -> None:
        if event.inaxes is not self._axes or event.button != 1:
            return
        if event.dblclick:
            self._link.show_part(None)
        self._grip = (event.x, event.y), (event.xdata, event.ydata)
        self._dragged = event.dblclick

    def _move(self, event: Any) -> None:
        if event.inaxes is self._axes:
            self._link.pointed.emit((event.xdata, event.ydata))
        if self._grip is None or self._axes is None or self._shown is None:
            return
        (i, j), (x, y) = self._grip
        self._dragged |= abs(event.x - i) + abs(event.y - j) > _DRAG
        if self._dragged:
            there = self._axes.transData.inverted().transform((event.x, event.y))
            left, right, bottom, top = self._link.part or _whole(self._shown.scene.screen)
            dx, dy = x - there[0], y - there[1]
            self._show_part([left + dx, right + dx, bottom + dy, top + dy])

    def _release(self, event: Any) -> None:
        if self._grip is not None and not self._dragged:
            self._link.pinned.emit(self._grip[1])
        self._grip = None

    def _show_part(self, sides: list[float]) -> None:
        """See a part that does not reach beyond the screen, or all of it."""
        assert self._shown is not None
        whole = _whole(self._shown.scene.screen)
        left, right = _within(sides[0], sides[1], whole[0], whole[1])
        bottom, top = _within(sides[2], sides[3], whole[2], whole[3])
        part = (left, right, bottom, top)
        self._link.show_part(None if part == whole else part)


def _whole(screen: "Screen") -> Part:
    r_x, r_y = screen.half_width
    return (-r_x, r_x, -r_y, r_y)


def _within(low: float, high: float, least: float, most: float) -> tuple[float, float]:
    """An interval moved, and if need be cut, to fit into another."""
    if high - low >= most - least:
        return least, most
    shift = max(least - low, 0.0) + min(most - high, 0.0)
    return low + shift, high + shift
