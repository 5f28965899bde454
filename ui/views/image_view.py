"""View of values over a rectangle, with shared zoom and read-out.

Wheel, + and − zoom; dragging and arrows pan; a double click or Home shows everything.
"""

from abc import abstractmethod
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QResizeEvent, QSinglePointEvent, QWheelEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QSizePolicy, QWidget

from ui.document.frame import Frame
from ui.views.image_canvas import ImageCanvas, Touch
from ui.views.plot_view import PlotView
from ui.views.shared_view import Part, Place, SharedView
from ui.views.tools import ARROWS, COMMANDS, ZOOMS
from ui.widgets.controls import filled
from ui.widgets.figures import translated
from ui.widgets.labels import ElidedLabel
from ui.widgets.native import available_size
from ui.words import tr
from workbench.arrays import Array
from workbench.files.session import Session
from workbench.pictures.axes import Extent, pixel_at
from workbench.powers import written

_NARROWEST = 200  # pixels
_BESIDE = 6  # as narrow, images that fit on a screen
_AROUND = 4  # pixels around the controls of the row below, which is as high in all images
_ZOOM = 1.25  # for each step of the wheel
_NEAREST = 200.0  # times; a pixel is large enough then
_TURN = 120.0  # of a wheel for one step
_DRAG = 4.0  # pixels that a click may shake
_STEP = 0.1  # of what is seen, for an arrow


class ImageView(PlotView):
    """Shows an image, and its value under the pointer."""

    _canvas: ImageCanvas
    _image: Any = None  # of workbench.pictures: a map with update(array)

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        narrowest = min(_NARROWEST, available_size(self).width() // _BESIDE)
        self._canvas.setMinimumWidth(narrowest)
        self._values: Array | None = None
        self._pointed: Place | None = None
        self._pointer: QPointF | None = None  # while the mouse is on this image
        self._grip: Touch | None = None  # where a drag began
        self._dragged = False
        self._look = self._options()
        self._stated = ""
        self._readout = ElidedLabel()
        self._readout.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._readout.setAccessibleName(tr("Value under the pointer"))
        row = QWidget()
        row.setFixedHeight(QComboBox().sizeHint().height() + _AROUND)
        self._bottom = filled(QHBoxLayout(row), (self._readout, 1), margins=(6, 0, 6, 0))
        self._box.addWidget(row)
        self._shared.changed.connect(self._follow)
        self._shared.pointed.connect(self._point)

    def show_nothing(self, session: Session) -> None:
        self._values = None
        super().show_nothing(session)
        self._read()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self._leave()
        elif isinstance(event, QSinglePointEvent) and self._shown is not None:
            self._follow_mouse(event)
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._read()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self._shown is None or event.modifiers() & COMMANDS:
            super().keyPressEvent(event)
            return
        key = event.key()
        left, right, bottom, top = self._part()
        if key in ZOOMS:
            self._zoom(((left + right) / 2, (bottom + top) / 2), ZOOMS[key])
        elif key in ARROWS:
            right_by, up_by = ARROWS[key]
            right_by *= self._canvas.rightwards
            dx, dy = _STEP * right_by * (right - left), _STEP * up_by * (top - bottom)
            self._show_part((left + dx, right + dx, bottom + dy, top + dy))
        elif key == Qt.Key.Key_Home:
            self._shared.show(part=None)
        else:
            super().keyPressEvent(event)

    def _begin(self, axes: Axes, session: Session) -> None:
        before, self._image = self._image, self._new_image(axes, session)
        if before is not None and before.extent.bounds != self._image.extent.bounds:
            self._shared.show(part=None)

    def _change(self, frame: Frame) -> None:
        self._image.update(self._shown_array(frame))
        self._values = self._image.values
        self._read()

    @abstractmethod
    def _new_image(self, axes: Axes, session: Session) -> Any: ...

    @abstractmethod
    def _shown_array(self, frame: Frame) -> Array | None: ...

    def _new_canvas(self) -> ImageCanvas:
        return ImageCanvas(self)

    def _options(self) -> tuple[object, ...]:
        """What makes another image of the same light."""
        now = self._shared.now
        return now.number, now.logarithmic, now.colours, now.contours

    def _follow(self) -> None:
        if self._options() != self._look:
            self._look = self._options()
            self._begin_anew()
        if self._shown is not None:
            self._adapt()

    def _adapt(self) -> None:
        self._canvas.show_part(self._part())
        if self._pointer is not None:  # at rest, while keys or another design move the image
            self._shared.pointed.emit(self._canvas.place_at(self._pointer))

    def _click(self, place: Place) -> None: ...

    def _drag(self, touch: Touch, start: Place) -> None:
        there = self._canvas.place_at(touch.at)
        left, right, bottom, top = self._part()
        dx, dy = start[0] - there[0], start[1] - there[1]
        self._show_part((left + dx, right + dx, bottom + dy, top + dy))

    def _drop(self) -> None: ...

    def _point(self, place: Place | None) -> None:
        self._pointed = place
        self._read()

    def _read(self) -> None:
        if self._shown is None:
            self._readout.clear()
            return
        extent: Extent = self._image.extent
        pixel = None
        if self._pointed is not None and self._values is not None:
            x, y = self._pointed
            pixel = pixel_at(extent.bounds, self._values.shape, x, y)
        if pixel is None or self._values is None:
            texts = self._at_rest(self._shown)
        else:
            value = written(self._values[pixel], translated(self._image.unit))
            if np.isnan(self._values[pixel]):
                value = tr("outside the {optic}", optic=self._shown.scene.optic.called)
            whole = tr("{value} at {x}, {y}").format(
                value=value, x=extent.in_words(0, x), y=extent.in_words(1, y)
            )
            short = f"{value} ({extent.number(0, x)}, {extent.number(1, y)})"  # in a narrow view
            both = [f"{whole} · {self._stated}"] if self._stated else []
            texts = *both, whole, short, value
        width, wide = self._readout.width(), self._readout.fontMetrics().horizontalAdvance
        self._readout.setText(next((text for text in texts if wide(text) <= width), texts[-1]))

    def _state(self, text: str) -> None:
        """Show a sentence wherever there is no value under the pointer."""
        self._stated = text
        self._read()

    def _at_rest(self, session: Session) -> tuple[str, ...]:
        return (self._stated,)

    def _follow_mouse(self, event: QSinglePointEvent) -> None:
        touch, kind = self._canvas.touch(event), event.type()
        if isinstance(event, QWheelEvent):
            if touch.inside:
                self._zoom(touch.place, event.angleDelta().y() / _TURN)
        elif kind in (QEvent.Type.MouseMove, QEvent.Type.Enter):
            self._move(touch)
        elif event.button() == Qt.MouseButton.LeftButton:
            if kind == QEvent.Type.MouseButtonRelease:
                self._release()
            elif touch.inside and kind == QEvent.Type.MouseButtonDblClick:
                self._press_twice()
            elif touch.inside:
                self._press(touch)

    def _zoom(self, about: Place, steps: float) -> None:
        left, right, bottom, top = self._part()
        factor, whole = _ZOOM**-steps, self._whole()
        if right - left > (whole[1] - whole[0]) / _NEAREST or factor > 1:
            x, y = about
            self._show_part(
                (
                    x + factor * (left - x),
                    x + factor * (right - x),
                    y + factor * (bottom - y),
                    y + factor * (top - y),
                )
            )

    def _press(self, touch: Touch) -> None:
        self._grip, self._dragged = touch, False

    def _press_twice(self) -> None:
        self._shared.show(part=None)

    def _move(self, touch: Touch) -> None:
        if touch.inside:
            self._pointer = touch.at
            self._canvas.show_scales(True)
            self._shared.pointed.emit(touch.place)
        else:
            self._leave()
        if self._grip is not None:
            self._dragged |= (touch.at - self._grip.at).manhattanLength() > _DRAG
            if self._dragged:
                self._drag(touch, self._grip.place)

    def _leave(self) -> None:
        if self._pointer is not None:
            self._pointer = None
            self._canvas.show_scales(False)
            self._shared.pointed.emit(None)

    def _release(self) -> None:
        if self._grip is not None and self._dragged:
            self._drop()
        elif self._grip is not None:
            self._click(self._grip.place)
        self._grip = None

    def _show_part(self, part: Part) -> None:
        whole = self._whole()
        left, right = _within(part[0], part[1], whole[0], whole[1])
        bottom, top = _within(part[2], part[3], whole[2], whole[3])
        part = (left, right, bottom, top)
        self._shared.show(part=None if part == whole else part)

    def _part(self) -> Part:
        return self._shared.now.part or self._whole()

    def _whole(self) -> Part:
        bounds: Part = self._image.extent.bounds
        return bounds


def _within(low: float, high: float, least: float, most: float) -> tuple[float, float]:
    if high - low >= most - least:
        return least, most
    shift = max(least - low, 0.0) + min(most - high, 0.0)
    return low + shift, high + shift
