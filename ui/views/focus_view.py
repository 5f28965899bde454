"""Through focus: the irradiance on a screen before or behind the scene's.

A moved slider is answered with few rays at once, and with many when it rests.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QPushButton, QSizePolicy, QSlider

from ui.background import Background, Task
from ui.document.frame import Frame, same_task
from ui.views.light_images import LightImageView
from ui.views.plot_view import PlotView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView
from ui.words import later, tr
from workbench.analysis.focus import screen_at
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.session import verified_error
from workbench.errors import RunFailed
from workbench.files.session import Session
from workbench.geometry.faces import ControlHeights
from workbench.pictures.error_curves import FocusCurve
from workbench.powers import written
from workbench.process import usable_threads


@dataclass(frozen=True, eq=False)
class FocusRequest:
    """Request for traces to screens at other distances."""

    session: Session
    heights: ControlHeights
    traces: tuple[tuple[float, int], ...]


def trace_through_focus(request: FocusRequest, task: Task) -> None:
    """Trace a request; report each z with its `Validation`, or None without flux."""
    for z, rays in request.traces:
        found = _light_at(request, z, rays, task)
        if task.stopped:
            return
        task.report((z, found))


def _light_at(request: FocusRequest, z: float, rays: int, task: Task) -> Validation | None:
    # Late: what it stands on is slow to import.
    from workbench.analysis.validation import validating

    session = request.session.of_image(0)  # about whose screen the light is followed
    steps = validating(
        session.scene, session.target, request.heights, rays, screen_z=z, threads=usable_threads()
    )
    try:
        return task.follow(steps)
    except RunFailed:
        return None


_LINES = 8  # of text, as high as it is beside an image


class FocusCurveView(PlotView):
    """Small plot of errors that grows as traces arrive."""

    _curve: FocusCurve

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumHeight(self.sizeHint().height())
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        self.setToolTip(tr("Relative L2 error against the distance; the dotted line is the screen"))
        self._ends, self._z = (0.0, 1.0), 0.0
        self._errors: dict[float, float] = {}

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), _LINES * self.fontMetrics().lineSpacing())

    @property
    def errors(self) -> list[tuple[float, float]]:
        return sorted(self._errors.items())

    def begin(self, frame: Frame, ends: tuple[float, float]) -> None:
        """Remove all errors, for another lens."""
        self._ends, self._errors = ends, {}
        self.show_frame(frame)
        self._begin_anew()

    def add(self, z: float, error: float) -> None:
        self._errors[z] = error
        self._ask()

    def mark(self, z: float) -> None:
        self._z = z
        self._ask()

    def _begin(self, axes: Axes, session: Session) -> Sequence[Artist]:
        self._curve = FocusCurve(axes, session.scene, self._ends)
        return [self._curve.mark]

    def _change(self, frame: Frame) -> bool:
        return self._curve.update(self.errors, self._z)


_TRACE = later("trace through focus")
_FEW, _MANY = 200_000, 4_000_000  # rays
_NO_DISTANCE = later("A far field has no distance to vary.")
_NEAREST, _SCREEN, _FARTHEST = 500, 1000, 1500  # of the way from lens to screen, per mille
_STEP, _PAGE = 5, 50
_PLACES, _CURVE_RAYS = 31, 100_000  # of the curve
_TALL = 3.5  # times the height of the curve; below that, it takes the place of the image


class FocusView(LightImageView, ComputingView):
    """A slider over screen distances, and the irradiance there."""

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._traced: Array | None = None
        self._heights: ControlHeights | None = None  # of the traced lens
        self._image_of, self._curve_of = Background(_TRACE, self), Background(_TRACE, self)
        self._image_of.progressed.connect(self._show_light)
        self._curve_of.progressed.connect(self._add_error)
        for traces in (self._image_of, self._curve_of):
            traces.failed.connect(self._show_place)
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setRange(_NEAREST, _FARTHEST)
        self._slider.setValue(_SCREEN)
        self._slider.setSingleStep(_STEP)
        self._slider.setPageStep(_PAGE)
        self._slider.setAccessibleName(tr("Distance of the screen"))
        self._slider.setToolTip(
            tr(
                "Show the irradiance at 0.5 to 1.5 times the distance of the screen; the scene is "
                "unchanged"
            )
        )
        self._slider.valueChanged.connect(self._slide)
        self._back = QPushButton(tr("At screen"))
        self._back.setToolTip(tr("Return to the distance of the screen"))
        self._back.clicked.connect(lambda: self._slider.setValue(_SCREEN))
        self._more = QPushButton(tr("Curve"))
        self._more.setToolTip(tr("Plot the error against the distance"))
        self._more.setCheckable(True)
        self._more.toggled.connect(self._show_curve)
        for number, control in enumerate((self._slider, self._back, self._more), 2):
            self._bottom.insertWidget(number, control, 1 if control is self._slider else 0)
        self._curve = FocusCurveView()
        self._curve.hide()
        self.add_below(self._curve)

    def _number(self, session: Session) -> int:
        return 0

    def _at_rest(self, session: Session) -> tuple[str, ...]:
        return (self._stated,)

    @property
    def z(self) -> float:
        """Z of the shown screen; needs a frame."""
        return self._z_of(self._slider.value())

    def show_frame(self, frame: Frame) -> None:
        if self._frame is None or not same_task(self._frame.session, frame.session):
            self._forget()
        super().show_frame(frame)

    def show_nothing(self, session: Session) -> None:
        self._forget()
        super().show_nothing(session)
        self._state("")

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share()

    def _want(self) -> None:
        at_a_distance = self._at_a_distance(self._frame)
        for control in (self._slider, self._back, self._more):
            control.setEnabled(at_a_distance)
        if not at_a_distance:
            self._want_nothing()
            self._state(tr(_NO_DISTANCE))
        elif self._seen():
            self._show_place(tr("computed when the design rests…"))
            self._compute_soon()

    def _forget(self) -> None:
        self._traced = None
        self._image_of.cancel()
        self._curve_of.cancel()

    def _slide(self) -> None:
        if self._seen() and self._at_a_distance(self._frame):
            self._trace()

    def _shown_array(self, frame: Frame) -> Array:
        return np.zeros_like(frame.session.target) if self._traced is None else self._traced

    def _compute(self) -> None:
        self._trace()
        self._trace_curve()

    def _trace(self) -> None:
        frame = self._frame
        assert frame is not None  # what nobody sees is not traced
        lens = frame.session, frame.state.heights
        self._curve.mark(self.z)
        self._show_place(tr("tracing…"))
        request = FocusRequest(*lens, ((self.z, _FEW), (self.z, _MANY)))
        self._image_of.begin(partial(trace_through_focus, request), request)

    def _show_light(self, request: FocusRequest, traced: tuple[float, Validation | None]) -> None:
        _, found = traced
        if found is None:
            self._traced = np.zeros_like(request.session.target)
            self._heights = request.heights
            self._show_place(tr("no flux arrives there"))
        else:
            self._traced, self._heights = found.irradiance, request.heights
            arrives = tr("{part:.1f} % of the light").format(part=100 * found.efficiency)
            self._show_place(
                tr("error {error}, {light}").format(error=verified_error(found), light=arrives)
            )
        self._show_veil()
        self._ask()

    def _is_behind(self) -> bool:
        if self._frame is None or self._traced is None:
            return False
        return self._heights != self._frame.state.heights

    def _show_place(self, what: str) -> None:
        assert self._frame is not None
        at_screen = f" ({tr('screen')})" if self._slider.value() == _SCREEN else ""
        place = written(self.z, self._frame.session.scene.unit)
        self._state(f"z = {place}{at_screen}: {what}")

    def _show_curve(self, shown: bool) -> None:
        self._curve.setVisible(shown)
        self._share()
        if self._seen() and self._at_a_distance(self._frame):
            self._trace_curve()

    def _share(self) -> None:
        fits = self.height() > _TALL * self._curve.sizeHint().height()
        self._canvas.setVisible(fits or not self._more.isChecked())

    def _trace_curve(self) -> None:
        self._curve_of.cancel()
        frame = self._frame
        if frame is None or not self._more.isChecked():
            return
        places = [
            self._z_of(round(part)) for part in np.linspace(_NEAREST, _FARTHEST, _PLACES).tolist()
        ]
        self._curve.begin(frame, (places[0], places[-1]))
        self._curve.mark(self.z)
        lens = frame.session, frame.state.heights
        request = FocusRequest(*lens, tuple((z, _CURVE_RAYS) for z in places))
        self._curve_of.begin(partial(trace_through_focus, request), request)

    def _add_error(self, request: FocusRequest, traced: tuple[float, Validation | None]) -> None:
        z, found = traced
        self._curve.add(z, 1.0 if found is None else found.relative_l2_corrected)

    def _z_of(self, part: int) -> float:
        frame = self._frame
        assert frame is not None
        return screen_at(frame.session.scene, frame.state.heights, part / _SCREEN)

    @staticmethod
    def _at_a_distance(frame: Frame | None) -> bool:
        return frame is None or frame.session.scene.receiver.at_distance

    def _why_empty(self, frame: Frame | None) -> str:
        if not self._at_a_distance(frame):
            return tr(_NO_DISTANCE)
        if frame is not None and self._traced is None:
            return tr("Computed when the design rests.")
        return super()._why_empty(frame)
