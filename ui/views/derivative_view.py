"""Derivative of the irradiance with respect to one control height."""

from typing import TYPE_CHECKING

from matplotlib.axes import Axes
from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QSpinBox

from ui.background import Task
from ui.document.frame import Frame, same_task
from ui.views.choices import FaceChoice
from ui.views.image_view import ImageView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView, Request
from ui.widgets.controls import named
from ui.words import later, tr
from workbench.arrays import Array
from workbench.files.session import Session
from workbench.geometry.faces import ControlPoint
from workbench.geometry.surface import nets_of
from workbench.pictures.images import DerivativeImage
from workbench.powers import written

if TYPE_CHECKING:
    from workbench.analysis.derivatives import DerivativeMap


class DerivativeView(ImageView, ComputingView):
    """Choice of a control point, its derivative map, and the sum of the map."""

    _WORK = later("derivative map")

    _image: DerivativeImage
    _answer: "DerivativeMap | None"

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.picked.connect(self.choose)
        self._faces = FaceChoice()
        self._boxes = (_index_box("x"), _index_box("y"))
        for number, control in enumerate((self._faces, *self._boxes)):
            self._bottom.insertWidget(number, control)
        self._faces.currentIndexChanged.connect(self._turn)
        for box in self._boxes:
            box.valueChanged.connect(self._want)

    @property
    def point(self) -> ControlPoint:
        along_x, along_y = self._boxes
        return ControlPoint(self._faces.face, (along_x.value(), along_y.value()))

    def choose(self, point: ControlPoint) -> None:
        with QSignalBlocker(self._faces):
            self._faces.choose(point.face)
        self._offer()
        for box, number in zip(self._boxes, point.index, strict=True):
            with QSignalBlocker(box):
                box.setValue(number)
        self._want()

    def show_frame(self, frame: Frame) -> None:
        if self._frame is None or not same_task(self._frame.session, frame.session):
            self._forget()
            self._faces.show_scene(frame.session.scene)
        self._frame = frame
        self._offer()
        super().show_frame(frame)

    def _turn(self) -> None:
        self._offer()
        self._want()

    def _offer(self) -> None:
        if self._frame is None:
            return
        net = nets_of(self._frame.session.scene)[self._faces.face]
        for box, n in zip(self._boxes, net.shape, strict=True):
            if box.maximum() != n - 1:
                with QSignalBlocker(box):
                    box.setMaximum(n - 1)
                    box.setValue(n // 2)

    def _chosen(self) -> ControlPoint:
        return self.point

    def _want(self) -> None:
        super()._want()
        if self._seen():
            self._shared.show(point=self.point)

    def _want_nothing(self) -> None:
        super()._want_nothing()
        self._shared.show(point=None)

    @staticmethod
    def _work(request: Request, task: Task) -> "DerivativeMap":
        # Late: torch comes with it, and the window shows before that.
        from workbench.analysis.derivatives import irradiance_derivative

        frame, point = request.frame, request.choice
        scene, heights = frame.session.scene, frame.state.heights
        return irradiance_derivative(scene, heights, point.index, face=point.face)

    def _show_state(self) -> None:
        frame, found = self._frame, self._answer
        if self._known and frame is not None and found is not None:
            self._state(_in_words(found, frame.session.scene.unit))
        elif self.background.busy:
            self._state(tr("Computing…"))
        else:
            self._state(tr("Computed when the design rests…"))

    def _fail(self, sentence: str) -> None:
        self._forget()
        self._state(sentence)
        self._ask()

    def _why_empty(self, frame: Frame | None) -> str:
        if frame is not None and self._answer is None:
            return self._stated
        return super()._why_empty(frame)

    def _new_image(self, axes: Axes, session: Session) -> DerivativeImage:
        return DerivativeImage(axes, session.scene)

    def _shown_array(self, frame: Frame) -> Array | None:
        return None if self._answer is None else self._answer.map


def _index_box(axis: str) -> QSpinBox:
    name = tr("Control point along {axis}").format(axis=axis)
    tip = tr("Number of the control point along {axis}, counted from 0").format(axis=axis)
    box = named(QSpinBox(), name, tip)
    box.setKeyboardTracking(False)
    return box


def _in_words(found: "DerivativeMap", unit: str) -> str:
    x, y = found.position
    place = f"x = {written(x, unit, 3)}, y = {written(y, unit, 3)}"
    part = (
        tr(", {part} of the total flux there").format(
            part=written(found.sum / found.flux, digits=2)
        )
        if found.flux
        else ""
    )
    total = tr("Sum: flux on the screen changes by {sum} per {unit}{part}").format(
        sum=written(found.sum, digits=2), unit=unit, part=part
    )
    return f"{place}. {total}"
