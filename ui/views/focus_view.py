"""Traces of a lens to screens elsewhere, for threads.

1. It is traced anew by other means than the optimiser's, only for eyes: never while hidden.
2. It follows the lens when it rests, as the derivative does. A slider that moves is answered with
   few rays at once, and with many when it stays.
"""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QSizePolicy, QSlider

from ui.background import Background, Task, other_cores, sentence_of
from ui.shown.frame import same_task
from ui.views.image_link import ImageLink
from ui.views.light_images import LightContent, LightImageView
from ui.views.plot_view import PlotCanvas
from ui.views.view import ComputingView, View
from ui.widgets.labels import WrappedLabel
from ui.widgets.plot_words import translate
from ui.words import later, tr
from workbench.analysis.focus import screen_at
from workbench.arrays import Array
from workbench.design.session import verified_error
from workbench.errors import RunFailed
from workbench.pictures.error_curves import FocusCurve
from workbench.powers import written

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.validation_figures import Validation
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights


@dataclass(frozen=True, eq=False)
class FocusRequest:
    """What the light of a lens is like on screens elsewhere."""

    session: "Session"
    heights: "ControlHeights"
    traces: tuple[tuple[float, int], ...]


def trace_through_focus(request: FocusRequest, task: Task) -> None:
    """Answer a request; meant for a thread.

    Reports for each screen its z and what the light is like there, a `Validation` or None for no
    light.
    """
    for z, rays in request.traces:
        found = _light_at(request, z, rays, task)
        if task.stopped:
            return
        task.report((z, found))


def _light_at(request: FocusRequest, z: float, rays: int, task: Task) -> "Validation | None":
    # Late: what it stands on is slow to import.
    from workbench.analysis.validation import validating

    session = request.session.of_image(0)  # about whose screen the light is followed
    steps = validating(
        session.scene,
        session.target,
        request.heights,
        rays,
        screen_z=z,
        threads=other_cores(),
    )
    try:
        return task.follow(steps)
    except RunFailed:
        return None


_LINES = 8  # of text, as high as it is beside an image


class FocusCurveView(View):
    """Small plot of errors that grows as traces arrive."""

    def __init__(self) -> None:
        super().__init__()
        self._canvas = PlotCanvas(self, bar=False)
        self._box.addWidget(self._canvas)
        self.setMinimumHeight(self.sizeHint().height())
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        self.setToolTip(tr("Relative L2 error against the distance; the dotted line is the screen"))
        self._ends = (0.0, 1.0)
        self._z = 0.0
        self._errors: dict[float, float] = {}
        self._curve: FocusCurve | None = None

    def sizeHint(self) -> QSize:
        """Some lines of text high."""
        return QSize(super().sizeHint().width(), _LINES * self.fontMetrics().lineSpacing())

    @property
    def errors(self) -> list[tuple[float, float]]:
        """Shown distances and errors."""
        return sorted(self._errors.items())

    def begin(self, session: "Session", ends: tuple[float, float]) -> None:
        """Remove all errors, for another lens."""
        self._ends, self._errors, self._curve = ends, {}, None
        self.show_design(session)

    def add(self, z: float, error: float) -> None:
        """Add an error."""
        self._errors[z] = error
        self._ask()

    def mark(self, z: float) -> None:
        """Mark the shown distance."""
        self._z = z
        self._ask()

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        if self._curve is None:
            self._curve = FocusCurve(self._canvas.begin(), session.scene, self._ends)
            self._canvas.animate([self._curve.mark])
            translate(self._canvas.figure)
        self._canvas.show_changes(self._curve.update(self.errors, self._z))

    def _recolour(self) -> None:
        self._canvas.recolour()


_TRACE = later("trace through focus")
_REST_MS = 250  # longer than between two frames of a run
_FEW, _MANY = 200_000, 4_000_000  # rays
_NO_DISTANCE = later("A far field is at no distance: there is nothing to focus.")
_NEAREST, _SCREEN, _FARTHEST = 500, 1000, 1500  # of the way from lens to screen, per mille
_STEP, _PAGE = 5, 50
_PLACES, _CURVE_RAYS = 31, 100_000  # of the curve
_ROOMY = 3.5  # times the height of the curve; below that, it takes the place of the image


class _TracedLight:
    light: Array | None = None
    heights: "ControlHeights | None" = None  # of the lens

    def of(self, frame: "Frame") -> Array:
        return np.zeros_like(frame.session.target) if self.light is None else self.light


class FocusView(LightImageView, ComputingView):
    """A slider over screen distances, and the irradiance there."""

    def __init__(self, link: ImageLink | None = None) -> None:
        self._traced = _TracedLight()
        super().__init__(LightContent(self._traced.of), link)
        self._image_of, self._curve_of = Background(_TRACE, self), Background(_TRACE, self)
        self._image_of.progressed.connect(self._take)
        self._curve_of.progressed.connect(self._take_error)
        for traces in (self._image_of, self._curve_of):
            traces.failed.connect(lambda _, error: self._tell(sentence_of(error, tr(_TRACE))))
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._trace_anew)
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setRange(_NEAREST, _FARTHEST)
        self._slider.setValue(_SCREEN)
        self._slider.setSingleStep(_STEP)
        self._slider.setPageStep(_PAGE)
        self._slider.setAccessibleName(tr("Distance of the screen"))
        self._slider.setToolTip(
            tr(
                "Look at the light before or behind the screen: half to one and a half "
                "times its distance. The scene stays as it is"
            )
        )
        self._slider.valueChanged.connect(self._slide)
        self._place = WrappedLabel()
        self._back = QPushButton(tr("At screen"))
        self._back.setToolTip(tr("Go back to the distance of the scene's screen"))
        self._back.clicked.connect(lambda: self._slider.setValue(_SCREEN))
        self._more = QPushButton(tr("Curve"))
        self._more.setToolTip(
            tr("Trace the light to many distances and draw the error against them")
        )
        self._more.setCheckable(True)
        self._more.toggled.connect(self._show_curve)
        row = QHBoxLayout()
        row.setContentsMargins(6, 0, 6, 2)
        row.addWidget(self._slider, 1)
        row.addWidget(self._back)
        row.addWidget(self._more)
        self._place.setContentsMargins(6, 0, 6, 4)
        self._curve = FocusCurveView()
        self._curve.hide()
        self._box.addLayout(row)
        self._box.addWidget(self._place)
        self.add_below(self._curve)

    def _number(self, session: "Session") -> int:
        return 0

    @property
    def z(self) -> float:
        """Z of the shown screen; needs a frame."""
        return self._z_of(self._slider.value())

    def show_frame(self, frame: "Frame") -> None:
        """Store another lens."""
        if self._frame is None or not same_task(self._frame.session, frame.session):
            self._forget()
        super().show_frame(frame)
        self._show_veil()
        self._want()

    def show_nothing(self, session: "Session") -> None:
        """Show a design that cannot be traced."""
        self._want_nothing()
        self._forget()
        super().show_nothing(session)
        self._place.clear()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show image and curve if there is space for both."""
        super().resizeEvent(event)
        self._share()

    def closeEvent(self, event: QCloseEvent) -> None:
        """End the threads with the view."""
        self.close_threads()
        super().closeEvent(event)

    def close_threads(self) -> None:
        """Cancel traces and wait for them; safe to call twice."""
        self._want_nothing()
        self._image_of.close()
        self._curve_of.close()

    def _want(self) -> None:
        at_a_distance = self._at_a_distance(self._frame)
        for control in (self._slider, self._back, self._more):
            control.setEnabled(at_a_distance)
        if not at_a_distance:
            self._want_nothing()
            self._place.setText(tr(_NO_DISTANCE))
        elif self._seen():
            self._tell(tr("traced when the design rests…"))
            self._rest.start()

    def _want_nothing(self) -> None:
        self._rest.stop()
        self._image_of.cancel()
        self._curve_of.cancel()

    def _forget(self) -> None:
        self._traced.light = None
        self._image_of.cancel()
        self._curve_of.cancel()

    def _slide(self) -> None:
        if self._seen() and self._at_a_distance(self._frame):
            self._trace()

    def _trace_anew(self) -> None:
        self._trace()
        self._trace_curve()

    def _trace(self) -> None:
        frame = self._frame
        assert frame is not None  # what nobody sees is not traced
        lens = frame.session, frame.state.heights
        self._curve.mark(self.z)
        self._tell(tr("tracing…"))
        request = FocusRequest(*lens, ((self.z, _FEW), (self.z, _MANY)))
        self._image_of.begin(partial(trace_through_focus, request), request)

    def _take(self, request: FocusRequest, traced: "tuple[float, Validation | None]") -> None:
        _, found = traced
        if found is None:
            self._traced.light = np.zeros_like(request.session.target)
            self._traced.heights = request.heights
            self._tell(tr("no light arrives there"))
        else:
            self._traced.light, self._traced.heights = found.irradiance, request.heights
            arrives = tr("{part:.1f} % of the light").format(part=100 * found.efficiency)
            self._tell(
                tr("error {error}, {light}").format(error=verified_error(found), light=arrives)
            )
        self._show_veil()
        self._ask()

    def _is_behind(self) -> bool:
        frame, traced = self._frame, self._traced
        if frame is None or traced.light is None:
            return False
        return traced.heights != frame.state.heights

    def _tell(self, what: str) -> None:
        assert self._frame is not None
        at_screen = f" ({tr('screen')})" if self._slider.value() == _SCREEN else ""
        place = written(self.z, self._frame.session.scene.unit)
        self._place.setText(f"z = {place}{at_screen}: {what}")

    def _show_curve(self, shown: bool) -> None:
        self._curve.setVisible(shown)
        self._share()
        if self._seen() and self._at_a_distance(self._frame):
            self._trace_curve()

    def _share(self) -> None:
        roomy = self.height() > _ROOMY * self._curve.sizeHint().height()
        self._canvas.setVisible(roomy or not self._more.isChecked())

    def _trace_curve(self) -> None:
        self._curve_of.cancel()
        frame = self._frame
        if frame is None or not self._more.isChecked():
            return
        places = [
            self._z_of(round(part)) for part in np.linspace(_NEAREST, _FARTHEST, _PLACES).tolist()
        ]
        self._curve.begin(frame.session, (places[0], places[-1]))
        self._curve.mark(self.z)
        lens = frame.session, frame.state.heights
        request = FocusRequest(*lens, tuple((z, _CURVE_RAYS) for z in places))
        self._curve_of.begin(partial(trace_through_focus, request), request)

    def _take_error(self, request: FocusRequest, traced: "tuple[float, Validation | None]") -> None:
        z, found = traced
        self._curve.add(z, 1.0 if found is None else found.relative_l2_corrected)

    def _z_of(self, part: int) -> float:
        frame = self._frame
        assert frame is not None
        return screen_at(frame.session.scene, frame.state.heights, part / _SCREEN)

    @staticmethod
    def _at_a_distance(frame: "Frame | None") -> bool:
        return frame is None or frame.session.scene.receiver.at_distance

    def _why_empty(self, frame: "Frame | None") -> str:
        if not self._at_a_distance(frame):
            return tr(_NO_DISTANCE)
        if frame is not None and self._traced.light is None:
            return tr("The light there is traced when the design rests.")
        return super()._why_empty(frame)
