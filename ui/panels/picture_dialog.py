"""Dialog that crops a picture and sets its levels, with a preview and a histogram."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QDialogButtonBox, QHBoxLayout, QLabel, QWidget

from ui.panels.crop import WHOLE, CropView
from ui.panels.edits import Edit, edited_scene
from ui.panels.entries import RowForm
from ui.panels.rows import Rows
from ui.widgets.controls import filled
from ui.widgets.dialog import Buttons, Dialog
from ui.words import tr
from workbench.arrays import Array
from workbench.scene import LEVELS, ImageTarget, Scene
from workbench.targets import cropped, levelled, pixel_values
from workbench.targets.picture import Picture
from workbench.targets.raster import averaged

_SIZE = QSize(860, 720)
_SEEN = 512  # pixels of the longer side of the preview, at most
_BINS = 128
_HIGH, _HANDLE = 84, 7  # pixels: height of the histogram, half a handle
_BETWEEN = 0.02  # from the black level to the white level, at least
_DIGITS = 3


class Histogram(QWidget):
    """Histogram of pixel values with handles for black level, mid-tones and white level."""

    moved = Signal(str, float)  # name of a field, its value

    def __init__(self) -> None:
        super().__init__()
        self.setFixedHeight(_HIGH)
        self.setMinimumWidth(2 * _BINS)
        self.setAccessibleName(tr("Histogram of the picture"))
        self.setToolTip(
            tr("Drag black level, mid-tones or white level; double-click to reset all three")
        )
        self._counts: Array = np.zeros(_BINS)
        self._levels = dict.fromkeys(LEVELS, 0.0)
        self._held = ""

    def show_values(self, values: Array, target: ImageTarget) -> None:
        """Show pixel values in [0, 1], and the levels of a target."""
        counts, _ = np.histogram(values, _BINS, (0.0, 1.0))
        self._counts = np.sqrt(counts / counts.max())  # a black background has most of them
        self._levels = {name: getattr(target, name) for name in LEVELS}
        self.update()

    @property
    def places(self) -> dict[str, float]:
        """Pixel value at each handle; that of the mid-tones becomes half of white."""
        black, white, gamma = (self._levels[name] for name in LEVELS)
        return {"black": black, "white": white, "gamma": black + (white - black) * 0.5**gamma}

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            x, places = event.position().x(), self.places
            self._held = min(places, key=lambda name: abs(self._x(places[name]) - x))
            self.mouseMoveEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self._held:
            return
        at = (event.position().x() - _HANDLE) / self._across
        black, white, _ = (self._levels[name] for name in LEVELS)
        if self._held == "black":
            at = min(max(at, 0.0), white - _BETWEEN)
        elif self._held == "white":
            at = max(min(at, 1.0), black + _BETWEEN)
        else:
            part = (at - black) / (white - black)
            at = min(max(math.log(min(max(part, 1e-3), 0.999)) / math.log(0.5), 0.1), 10.0)
        self.moved.emit(self._held, round(at, _DIGITS))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = ""

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        for name in LEVELS:
            self.moved.emit(name, ImageTarget.model_fields[name].default)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, palette = QPainter(self), self.palette()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        high, wide = self.height() - 2.0 * _HANDLE, self._across / _BINS
        painter.fillRect(QRectF(_HANDLE, 0, self._across, high), palette.base())
        skyline = [
            QPointF(_HANDLE + (number + end) * wide, high * (1 - count))
            for number, count in enumerate(self._counts.tolist())
            for end in (0, 1)
        ]
        ends = QPointF(_HANDLE, high), QPointF(_HANDLE + self._across, high)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(palette.placeholderText())
        painter.drawPolygon(QPolygonF([ends[0], *skyline, ends[1]]))
        painter.setPen(QPen(palette.windowText().color(), 1))
        fills = {"black": Qt.GlobalColor.black, "gamma": Qt.GlobalColor.gray}
        for name, place in self.places.items():
            x = self._x(place)
            painter.setBrush(fills.get(name, Qt.GlobalColor.white))
            painter.drawLine(QPointF(x, 0), QPointF(x, high))
            foot = high + 2 * _HANDLE - 1
            corners = QPointF(x, high), QPointF(x - _HANDLE, foot), QPointF(x + _HANDLE, foot)
            painter.drawPolygon(QPolygonF(corners))
        painter.end()

    @property
    def _across(self) -> float:
        return self.width() - 2.0 * _HANDLE

    def _x(self, value: float) -> float:
        return _HANDLE + value * self._across


class PictureDialog(Dialog):
    """Asks which part of a picture is kept, and for its inversion, levels and gamma.

    ``scene`` has an image target at ``path``.
    """

    def __init__(self, picture: Picture, scene: Scene, path: str, window: QWidget) -> None:
        super().__init__(tr("Crop and tone of the picture"), window, Buttons.Ok | Buttons.Cancel)
        self._picture, self._scene, self._path = picture, scene, path
        self._before = self.target
        rows, columns = picture.light.shape
        scale = min(1.0, _SEEN / max(rows, columns))
        shape = max(round(scale * rows), 1), max(round(scale * columns), 1)
        self._light = averaged(picture.light, shape)
        self.view, self.histogram = CropView(self.target.crop), Histogram()
        self._figures = QLabel()
        whole = self.buttons.addButton(tr("&Whole picture"), QDialogButtonBox.ButtonRole.ResetRole)
        whole.clicked.connect(lambda: self.view.show_crop(WHOLE))
        makers = Rows(lambda: self._scene)
        fields = {field.name: field for field in ImageTarget.fields()}
        made = [
            row
            for name in ("invert", *LEVELS)
            for row in makers.of_field(fields[name], f"{path}.{name}")
        ]
        self._form = form = RowForm(made, lambda: self._scene, self._edit)
        form.setLayout(form.in_form(made))
        tone = filled(QHBoxLayout(), (self.histogram, 1), form)
        self.fill((self.view, 1), tone, self._figures, size=_SIZE)
        self.view.changed.connect(self._show)
        self.histogram.moved.connect(self._move_level)
        form.changed.connect(self._show)
        form.show_rows()
        self._show()
        self.view.setFocus()

    @property
    def target(self) -> ImageTarget:
        target = self._scene.target
        if not isinstance(target, ImageTarget):
            raise TypeError("only a picture is cropped")
        return target

    @property
    def changes(self) -> dict[str, object]:
        """Changed fields of the target."""
        now = {name: getattr(self.target, name) for name in ("invert", *LEVELS)}
        now["crop"] = tuple(round(cut, 4) for cut in self.view.crop)
        return {name: value for name, value in now.items() if value != getattr(self._before, name)}

    def _edit(self, edits: list[Edit]) -> None:
        self._scene = edited_scene(self._scene, edits)

    def _move_level(self, name: str, value: float) -> None:
        path = f"{self._path}.{name}"
        self._form.edit(Edit(path, path, {path: value}, drag=name))

    def _show(self) -> None:
        self.buttons.button(Buttons.Ok).setEnabled(not self._form.refused)
        crop, target, tone = self.view.crop, self.target, self._picture.tone
        peak = cropped(self._picture.light, crop).max() or 1.0
        values = pixel_values(np.minimum(self._light / peak, 1.0), target, tone)
        light = levelled(values, target, tone)
        kept = cropped(light, crop)
        self.view.show_light(light)
        self.histogram.show_values(cropped(values, crop), target)
        left, top, right, bottom = crop
        width, height = 1 - left - right, 1 - top - bottom
        rows, columns = self._picture.light.shape
        size = tr("Kept: {width:.0f} × {height:.0f} % of the picture, aspect {aspect:.2f}").format(
            width=100 * width,
            height=100 * height,
            aspect=width * columns / (height * rows),
        )
        contrast = tr("Peak: {peak:.1f} × the mean; black: {black:.0f} % of the area").format(
            peak=kept.max() / (kept.mean() or 1.0), black=100 * (kept < 1 / 255).mean()
        )
        self._figures.setText(f"{size}. {contrast}")
