"""Predicted photo: traced at several wavelengths while it is visible and no run is active."""

from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QSlider

from ui.background import Task
from ui.views.choices import ImageChoice
from ui.views.image_view import ImageView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView, Request
from ui.widgets.controls import Chooser, named, push_button
from ui.words import capitalised, later, tr
from workbench.analysis.photo.light import LIGHTS
from workbench.pictures.images import PhotoImage
from workbench.process import usable_threads

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ui.document.frame import Frame
    from workbench.analysis.photo.photo import Photo
    from workbench.files.session import Session


_STEPS, _MOST = 3, 8  # of the slider for each stop, as on cameras; stops to either side
_NO_LENS = later("There is no lens yet. Start designs one.")
_WAITS = later("The photo is predicted when the design rests.")


class PhotoView(ImageView, ComputingView):
    """The photo, its exposure, and the illumination."""

    ENDINGS = (".png",)

    _WORK, _TITLE = later("photo prediction"), later("Photo")

    _answer: "Photo | None"

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.changed.connect(self._want)
        self.background.progressed.connect(
            lambda _, part: self._state(tr("Predicting… {part:.0f} %").format(part=100 * part))
        )
        self._state(tr(_NO_LENS))
        self._readout.setAccessibleName(tr("State of the photo"))
        self._add_controls()

    @property
    def photo(self) -> "Photo | None":
        """Photo of the shown lens; None if missing or of an earlier lens."""
        return self._answer if self._known else None

    @property
    def stops(self) -> float:
        return self._slider.value() / _STEPS

    @property
    def empty(self) -> bool:
        return self.photo is None

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the photo as PNG, with its exposure."""
        from workbench.analysis.photo.photo import write_png  # late: slow to import

        if self._answer is not None:
            write_png(self._answer, self.stops, file)

    def show_nothing(self, session: "Session") -> None:
        super().show_nothing(session)
        self._state(tr(_NO_LENS))

    def _add_controls(self) -> None:
        self._choice = ImageChoice(self._shared)
        lights = {name: capitalised(tr(light.title)) for name, light in LIGHTS.items()}
        tip = tr(
            "Light of the photo: that of the source (daylight for collimated light, a laser for a "
            "Gaussian beam, otherwise an LED), or another one"
        )
        chooser = Chooser({"": tr("Light of the source"), **lights})
        self._light = named(chooser, tr("Light of the photo"), tip)
        self._light.currentIndexChanged.connect(self._want)
        tip = tr("Exposure in stops; each stop doubles the brightness")
        self._slider = named(QSlider(Qt.Orientation.Horizontal), tr("Exposure"), tip)
        self._slider.setRange(-_MOST * _STEPS, _MOST * _STEPS)
        self._slider.setPageStep(_STEPS)
        self._slider.valueChanged.connect(self._expose)
        self._stops = QLabel()
        self._stops.setMinimumWidth(
            self._stops.fontMetrics().horizontalAdvance(tr("{number} stops").format(number="−8⅔ "))
        )
        tip = tr("Default exposure: the target's brightest pixel is white")
        name = tr("Default exposure")
        usual = push_button("0", tip, lambda: self._slider.setValue(0), name)
        usual.setMaximumWidth(2 * usual.sizeHint().height())
        self._expose()
        for widget in (self._light, self._slider, self._stops, usual, self._choice):
            self._bottom.addWidget(widget, 1 if widget is self._slider else 0)

    def _expose(self) -> None:
        self._stops.setText(_in_thirds(self._slider.value()))
        self._ask()

    def _want(self) -> None:
        if self._frame is not None:
            self._choice.show_scene(self._frame.session.scene)
        super()._want()

    def _chosen(self) -> tuple[int, str]:
        """Number of the image, and name of the light."""
        assert self._frame is not None  # of what nobody sees there is no photo
        return self._number(self._frame.session), self._light.currentData()

    @staticmethod
    def _work(request: Request, task: Task) -> "Photo | None":
        # Late: what it stands on is slow to import.
        from workbench.analysis.photo.photo import photographing

        number, light = request.choice
        frame = request.frame.of_image(number)
        steps = photographing(
            frame.session.scene,
            frame.session.target,
            frame.state.heights,
            LIGHTS.get(light),
            threads=usable_threads(),
        )
        return task.follow(steps, task.report)

    def _fail(self, sentence: str) -> None:
        self._state(sentence)

    def _show_state(self) -> None:
        if self.photo is not None:
            self._state(f"{capitalised(tr(self.photo.summary))}.")
        elif not self.background.busy:
            before = "" if self._answer is None else tr("Outdated. ")
            self._state(before + tr(_WAITS))
        if self._answer is None:
            self._ask()  # since a state is shown in place of the photo

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        super()._draw(*self._of_image(session, frame))

    def _why_empty(self, frame: "Frame | None") -> str:
        return self._stated if self._answer is None else ""

    def _new_image(self, axes: "Axes", session: "Session") -> PhotoImage:
        return PhotoImage(axes, session.scene)

    def _shown_array(self, frame: "Frame") -> "npt.NDArray[Any]":
        if self._answer is None:
            return np.zeros((1, 1, 3), dtype=np.uint8)
        return self._answer.picture(self.stops)


def _in_thirds(steps: int) -> str:
    whole, part = divmod(abs(steps), _STEPS)
    sign = "" if steps == 0 else "−" if steps < 0 else "+"
    number = f"{whole or ''}{('', '⅓', '⅔')[part]}" or "0"
    return tr("{number} stops").format(number=f"{sign}{number}")
