"""Through focus: the irradiance on a screen before or behind the scene's.

A moved slider is answered with few rays at once, and with many when it rests.
"""

import numpy as np
from matplotlib.axes import Axes
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QPushButton, QSizePolicy, QSlider

from ui.background import Task
from ui.document.frame import Frame, same_task
from ui.views.light_images import LightImageView
from ui.views.plot_view import PlotView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView, Request
from ui.widgets.controls import named, push_button
from ui.words import later, tr
from workbench.analysis.focus import screen_at
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.session import verified_error
from workbench.errors import RunFailed
from workbench.files.session import Session
from workbench.pictures.error_curves import FocusCurve
from workbench.powers import written
from workbench.process import usable_threads

_TRACE = later("trace through focus")
_NEAREST, _SCREEN, _FARTHEST = 500, 1000, 1500  # of the way from lens to screen, per mille
_LINES = 8  # of text, as high as the curve is beside an image
_PLACES, _CURVE_RAYS = 31, 100_000  # of the curve


def z_at(frame: Frame, part: int) -> float:
    """Z of the screen at a part of the way from lens to screen, per mille."""
    return screen_at(frame.session.scene, frame.state.heights, part / _SCREEN)


def light_at(frame: Frame, part: int, rays: int, task: Task) -> Validation | RunFailed | None:
    """Trace the light on a screen, in a thread, or return why there is none; None if stopped."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.validation import validating

    session, heights = frame.session.of_image(0), frame.state.heights
    steps = validating(
        session.scene,
        session.target,
        heights,
        rays,
        screen_z=z_at(frame, part),
        threads=usable_threads(),
    )
    try:
        return task.follow(steps)
    except RunFailed as dark:
        return dark


class FocusCurveView(PlotView, ComputingView):
    """Small plot of errors that grows as traces arrive."""

    _WORK = _TRACE

    _curve: FocusCurve

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumHeight(self.sizeHint().height())
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        self.setToolTip(tr("Relative L2 error against the distance; the dotted line is the screen"))
        self._ends, self._z = (0.0, 1.0), 0.0
        self.errors: list[tuple[float, float]] = []
        self.background.progressed.connect(self._add)

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), _LINES * self.fontMetrics().lineSpacing())

    def mark(self, z: float) -> None:
        self._z = z
        self._ask()

    def _differs(self, before: Frame | None, frame: Frame) -> bool:
        return False  # it is drawn once its errors come

    def _seen(self) -> bool:
        at_a_distance = self._frame is not None and self._frame.session.scene.receiver.at_distance
        return at_a_distance and super()._seen()

    def _compute(self) -> None:
        assert self._frame is not None
        self.errors = []
        self._ends = z_at(self._frame, _NEAREST), z_at(self._frame, _FARTHEST)
        self._begin_anew()
        super()._compute()

    @staticmethod
    def _work(request: Request, task: Task) -> bool | None:
        for part in np.linspace(_NEAREST, _FARTHEST, _PLACES).round().astype(int).tolist():
            found = light_at(request.frame, part, _CURVE_RAYS, task)
            if found is None:
                return None
            error = found.relative_l2_corrected if isinstance(found, Validation) else 1.0
            task.report((z_at(request.frame, part), error))
        return True

    def _add(self, _: Request, error: tuple[float, float]) -> None:
        self.errors.append(error)
        self._ask()

    def _show_veil(self) -> None:
        """Leave that to the view around it."""

    def _begin(self, axes: Axes, session: Session) -> None:
        self._curve = FocusCurve(axes, session.scene, self._ends)

    def _change(self, frame: Frame) -> None:
        self._curve.update(self.errors, self._z)


_FEW, _MANY = 200_000, 4_000_000  # rays
_NO_DISTANCE = later("A far field has no distance to vary.")
_STEP, _PAGE = 5, 50  # of the slider
_TALL = 3.5  # times the height of the curve; below that, it takes the place of the image


class FocusView(LightImageView, ComputingView):
    """A slider over screen distances, and the irradiance there."""

    _WORK = _TRACE

    _answer: Validation | RunFailed | None

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self.background.progressed.connect(self._show_few)
        tip = tr(
            "Show the irradiance at 0.5 to 1.5 times the distance of the screen; the scene is "
            "unchanged"
        )
        self._slider = named(QSlider(Qt.Orientation.Horizontal), tr("Distance of the screen"), tip)
        self._slider.setRange(_NEAREST, _FARTHEST)
        self._slider.setValue(_SCREEN)
        self._slider.setSingleStep(_STEP)
        self._slider.setPageStep(_PAGE)
        self._slider.valueChanged.connect(self._slide)
        tip = tr("Return to the distance of the screen")
        self._back = push_button(tr("At screen"), tip, lambda: self._slider.setValue(_SCREEN))
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
        assert self._frame is not None
        return z_at(self._frame, self._slider.value())

    def show_design(self, session: Session) -> None:
        super().show_design(session)
        self._curve.show_design(session)

    def show_frame(self, frame: Frame) -> None:
        if self._frame is None or not same_task(self._frame.session, frame.session):
            self._forget()
            self.background.cancel()
        super().show_frame(frame)
        self._curve.show_frame(frame)

    def show_nothing(self, session: Session) -> None:
        super().show_nothing(session)
        self._curve.show_nothing(session)

    def allow(self, resting: bool) -> None:
        super().allow(resting)
        self._curve.allow(resting)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share()

    def _seen(self) -> bool:
        return super()._seen() and self._at_a_distance(self._frame)

    def _want(self) -> None:
        at_a_distance = self._at_a_distance(self._frame)
        for control in (self._slider, self._back, self._more):
            control.setEnabled(at_a_distance)
        super()._want()

    def _slide(self) -> None:
        if self._seen():
            self._compute()

    def _chosen(self) -> tuple[int, int]:
        """Part of the way to the screen, and number of rays."""
        return self._slider.value(), _MANY

    def _shown_array(self, frame: Frame) -> Array:
        if isinstance(self._answer, Validation):
            return self._answer.irradiance
        return np.zeros_like(frame.session.target)

    @staticmethod
    def _work(request: Request, task: Task) -> Validation | RunFailed | None:
        part, rays = request.choice
        task.report(light_at(request.frame, part, _FEW, task))
        return light_at(request.frame, part, rays, task)

    def _show_few(self, request: Request, found: Validation | RunFailed | None) -> None:
        self._store(Request(request.frame, (request.choice[0], _FEW)), found)

    def _is_behind(self) -> bool:
        if self._frame is None or self._answered is None:
            return False
        return self._answered.frame.state.heights != self._frame.state.heights

    def _compute(self) -> None:
        self._curve.mark(self.z)
        super()._compute()

    def _show_state(self) -> None:
        answered = self._answered
        if not self._at_a_distance(self._frame):
            self._state(tr(_NO_DISTANCE))
        elif answered is None or self._is_behind() or answered.choice[0] != self._slider.value():
            busy = self.background.busy
            self._show_place(tr("tracing…") if busy else tr("computed when the design rests…"))
        elif isinstance(self._answer, Validation):
            self._show_place(_in_words(self._answer))
        else:
            self._show_place(tr("no flux arrives there"))

    def _show_place(self, what: str) -> None:
        assert self._frame is not None
        at_screen = f" ({tr('screen')})" if self._slider.value() == _SCREEN else ""
        place = written(self.z, self._frame.session.scene.unit)
        self._state(f"z = {place}{at_screen}: {what}")

    def _fail(self, sentence: str) -> None:
        self._show_place(sentence)

    def _show_curve(self, shown: bool) -> None:
        self._curve.setVisible(shown)
        self._share()

    def _share(self) -> None:
        fits = self.height() > _TALL * self._curve.sizeHint().height()
        self._canvas.setVisible(fits or not self._more.isChecked())

    @staticmethod
    def _at_a_distance(frame: Frame | None) -> bool:
        return frame is None or frame.session.scene.receiver.at_distance

    def _why_empty(self, frame: Frame | None) -> str:
        if not self._at_a_distance(frame):
            return tr(_NO_DISTANCE)
        if frame is not None and self._answer is None:
            return tr("Computed when the design rests.")
        return super()._why_empty(frame)


def _in_words(found: Validation) -> str:
    arrives = tr("{part:.1f} % of the light").format(part=100 * found.efficiency)
    return tr("error {error}, {light}").format(error=verified_error(found), light=arrives)
