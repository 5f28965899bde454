"""Predicted photo: traced at several wavelengths while it is visible and no run is active."""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QPushButton, QSlider

from ui.background import Background, Task
from ui.document.frame import same_light
from ui.views.choices import ImageChoice
from ui.views.image_view import ImageView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView
from ui.widgets.controls import Chooser
from ui.words import capitalised, later, tr
from workbench.analysis.photo.light import LIGHTS
from workbench.pictures.axes import Extent
from workbench.pictures.images import PhotoImage
from workbench.process import usable_threads

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ui.document.frame import Frame
    from workbench.analysis.photo.photo import Photo
    from workbench.files.session import Session


@dataclass(frozen=True, eq=False)
class PhotoRequest:
    """Request for a photo."""

    frame: "Frame"
    image: int
    light: str

    def same(self, other: "PhotoRequest") -> bool:
        asked = (self.image, self.light) == (other.image, other.light)
        return asked and same_light(self.frame, other.frame)


def predict_photo(request: PhotoRequest, task: Task) -> "Photo | None":
    """Return the photo of a request, None if cancelled; for a thread.

    Reports the finished fraction.
    """
    # Late: what it stands on is slow to import.
    from workbench.analysis.photo.light import LIGHTS
    from workbench.analysis.photo.photo import photographing

    session = request.frame.session.of_image(request.image)
    steps = photographing(
        session.scene,
        session.target,
        request.frame.state.heights,
        LIGHTS.get(request.light),
        threads=usable_threads(),
    )
    return task.follow(steps, task.report)


_WORK = later("photo prediction")
_STEPS, _MOST = 3, 8  # of the slider for each stop, as on cameras; stops to either side
_NO_LENS = later("There is no lens yet. Start designs one.")
_WAITS = later("The photo is predicted when the design rests.")


class PhotoView(ImageView, ComputingView):
    """The photo, its exposure, and the illumination."""

    ENDINGS = (".png",)

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.changed.connect(self._want)
        self._predicted: tuple[PhotoRequest, Photo] | None = None
        self._wanted: PhotoRequest | None = None
        self.background = Background(_WORK, self)
        self.background.progressed.connect(
            lambda _, part: self._state(tr("Predicting… {part:.0f} %").format(part=100 * part))
        )
        self.background.done.connect(self._show)
        self.background.failed.connect(self._state)
        self._state(tr(_NO_LENS))
        self._readout.setAccessibleName(tr("State of the photo"))
        self._add_controls()

    @property
    def photo(self) -> "Photo | None":
        """Photo of the shown lens; None if missing or of an earlier lens."""
        if self._frame is None or self._predicted is None or not self._known(self._request()):
            return None
        return self._predicted[1]

    @property
    def stops(self) -> float:
        return self._slider.value() / _STEPS

    @property
    def empty(self) -> bool:
        return self.photo is None

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the photo as PNG, with its exposure."""
        from workbench.analysis.photo.photo import write_png  # late: slow to import

        if self._predicted is not None:
            write_png(self._predicted[1], self.stops, file)

    def show_nothing(self, session: "Session") -> None:
        self._predicted = None
        super().show_nothing(session)
        self._state(tr(_NO_LENS))

    def _add_controls(self) -> None:
        self._choice = ImageChoice(self._shared)
        self._light = Chooser()
        self._light.setAccessibleName(tr("Light of the photo"))
        self._light.setToolTip(
            tr(
                "Light of the photo: that of the source (daylight for collimated light, a laser "
                "for a Gaussian beam, otherwise an LED), or another one"
            )
        )
        self._light.addItem(tr("Light of the source"), "")
        for name, light in LIGHTS.items():
            self._light.addItem(capitalised(tr(light.title)), name)
        self._light.currentIndexChanged.connect(self._want)
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setRange(-_MOST * _STEPS, _MOST * _STEPS)
        self._slider.setPageStep(_STEPS)
        self._slider.setAccessibleName(tr("Exposure"))
        self._slider.setToolTip(tr("Exposure in stops; each stop doubles the brightness"))
        self._slider.valueChanged.connect(self._expose)
        self._stops = QLabel()
        self._stops.setMinimumWidth(
            self._stops.fontMetrics().horizontalAdvance(tr("{number} stops").format(number="−8⅔ "))
        )
        self._usual = QPushButton("0")
        self._usual.setToolTip(tr("Default exposure: the target's brightest pixel is white"))
        self._usual.setAccessibleName(tr("Default exposure"))
        self._usual.setMaximumWidth(2 * self._usual.sizeHint().height())
        self._usual.clicked.connect(lambda: self._slider.setValue(0))
        self._expose()
        for widget in (self._light, self._slider, self._stops, self._usual, self._choice):
            self._bottom.addWidget(widget, 1 if widget is self._slider else 0)

    def _expose(self) -> None:
        self._stops.setText(_in_thirds(self._slider.value()))
        self._ask()

    def _want(self) -> None:
        frame = self._frame
        if frame is None:
            return
        self._choice.show_scene(frame.session.scene)
        request = self._request()
        if self._known(request) or not (self._resting and self._seen()):
            self._want_nothing()
        elif not self.background.busy or not self._asked(request):
            self._want_nothing()
            self._rest.start()
        self._show_summary(request)

    def _want_nothing(self) -> None:
        super()._want_nothing()
        self._wanted = None

    def _request(self) -> PhotoRequest:
        assert self._frame is not None  # of what nobody sees there is no photo
        number = self._number(self._frame.session)
        return PhotoRequest(self._frame, number, self._light.currentData())

    def _known(self, request: PhotoRequest) -> bool:
        return self._predicted is not None and self._predicted[0].same(request)

    def _asked(self, request: PhotoRequest) -> bool:
        return self._wanted is not None and self._wanted.same(request)

    def _compute(self) -> None:
        request = self._wanted = self._request()
        self.background.begin(partial(predict_photo, request), request, tr("Photo"))

    def _show(self, request: PhotoRequest, photo: "Photo | None") -> None:
        if photo is not None:
            self._predicted = request, photo
            self._show_summary(request)
            self._ask()

    def _is_behind(self) -> bool:
        there = self._frame is not None and self._predicted is not None
        return there and not self._known(self._request())

    def _show_summary(self, request: PhotoRequest) -> None:
        self._show_veil()
        if self._known(request) and self._predicted is not None:
            self._state(f"{capitalised(tr(self._predicted[1].summary))}.")
        elif not self.background.busy:
            before = "" if self._predicted is None else tr("Outdated. ")
            self._state(before + tr(_WAITS))
        if self._predicted is None:
            self._ask()  # since a state is shown in place of the photo

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        super()._draw(*self._of_image(session, frame))

    def _why_empty(self, frame: "Frame | None") -> str:
        return self._stated if self._predicted is None else ""

    def _extent(self, session: "Session") -> Extent:
        return Extent.of_receiver(session.scene)

    def _unit(self, session: "Session") -> str:
        return ""

    def _new_image(self, axes: "Axes", session: "Session") -> PhotoImage:
        return PhotoImage(axes, session.scene)

    def _shown_array(self, frame: "Frame") -> "npt.NDArray[Any]":
        if self._predicted is None:
            return np.zeros((1, 1, 3), dtype=np.uint8)
        return self._predicted[1].picture(self.stops)


def _in_thirds(steps: int) -> str:
    whole, part = divmod(abs(steps), _STEPS)
    sign = "" if steps == 0 else "−" if steps < 0 else "+"
    number = f"{whole or ''}{('', '⅓', '⅔')[part]}" or "0"
    return tr("{number} stops").format(number=f"{sign}{number}")
