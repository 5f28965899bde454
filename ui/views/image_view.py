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
        self._state("")

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
        key, part = event.key(), self._part()
        if key in ZOOMS:
            self._zoom(part.mean(axis=1), ZOOMS[key])
        elif key in ARROWS:
            right, up = ARROWS[key]
            towards = np.array([[self._canvas.rightwards * right], [up]])
            self._show_part(part + _STEP * towards * np.diff(part))
        elif key == Qt.Key.Key_Home:
            self._shared.show(part=None)
        else:
            super().keyPressEvent(event)

    def _begin(self, axes: Axes, session: Session) -> None:
        before, self._image = self._image, self._new_image(axes, session)
        if before is not None and before.extent.bounds != self._image.extent.bounds:
            self._shared.show(part=None)

    def _change(self, frame: Frame) -> None:
        self._show_array(self._shown_array(frame))

    def _show_array(self, array: Array | None) -> None:
        self._image.update(array)
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
        self._canvas.show_part(self._shared.now.part or self._whole())
        if self._pointer is not None:  # at rest, while keys or another design move the image
            self._shared.pointed.emit(self._canvas.place_at(self._pointer))

    def _click(self, place: Place) -> None: ...

    def _drag(self, touch: Touch, start: Place) -> None:
        gone = np.subtract(start, self._canvas.place_at(touch.at))
        self._show_part(self._part() + gone[:, None])

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

    def _zoom(self, about: Place | Array, steps: float) -> None:
        part, whole, still = self._part(), np.reshape(self._whole(), (2, 2)), np.array(about)
        factor = _ZOOM**-steps
        if np.ptp(part[0]) > np.ptp(whole[0]) / _NEAREST or factor > 1:
            self._show_part(still[:, None] + factor * (part - still[:, None]))

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

    def _show_part(self, part: Array) -> None:
        """Show a part of the image, moved into it; all along an axis where it is larger."""
        whole = np.reshape(self._whole(), (2, 2))
        low, high = whole.T
        size = np.minimum(np.ptp(part, axis=1), high - low)
        start = np.clip(part[:, 0], low, high - size)
        shown = np.where((size < high - low)[:, None], np.stack([start, start + size], 1), whole)
        left, right, bottom, top = shown.ravel().tolist()
        self._shared.show(part=None if (shown == whole).all() else (left, right, bottom, top))

    def _part(self) -> Array:
        """Ends (2, 2) of the shown part along x and y."""
        return np.reshape(self._shared.now.part or self._whole(), (2, 2))

    def _whole(self) -> Part:
        bounds: Part = self._image.extent.bounds
        return bounds
