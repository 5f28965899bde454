"""Derivative of the irradiance with respect to one control height."""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSpinBox

from ui.background import Background, Task
from ui.document.frame import same_task
from ui.views.choices import FaceChoice
from ui.views.plot_view import PlotView
from ui.views.shared_view import SharedView
from ui.views.view import ComputingView
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.geometry.faces import ControlPoint
from workbench.geometry.surface import nets_of
from workbench.pictures.images import DerivativeImage
from workbench.powers import written

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.document.frame import Frame
    from workbench.analysis.derivatives import DerivativeMap
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights
    from workbench.scene import Scene


@dataclass(frozen=True, eq=False)
class DerivativeRequest:
    """Request for a derivative map."""

    scene: "Scene"
    heights: "ControlHeights"
    point: "ControlPoint"


class DerivativeView(PlotView, ComputingView):
    """Choice of a control point, its derivative map, and the sum of the map."""

    _image: DerivativeImage

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.picked.connect(self.choose)
        self._background = Background(later("derivative map"), self)
        self._background.done.connect(self._show_map)
        self._background.failed.connect(self._give_up)
        self._map: DerivativeMap | None = None
        self._of: DerivativeRequest | None = None  # what the map answers
        self._faces = FaceChoice()
        self._boxes = (_index_box("x"), _index_box("y"))
        self._place = QLabel()
        self._sum = WrappedLabel()
        self._box.insertLayout(0, self._row())
        self._box.addWidget(self._sum)
        self._sum.setContentsMargins(6, 0, 6, 4)
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

    def show_frame(self, frame: "Frame") -> None:
        if self._frame is None or not same_task(self._frame.session, frame.session):
            self._map = None
            self._faces.show_scene(frame.session.scene)
        self._frame = frame
        self._offer()
        super().show_frame(frame)

    def show_nothing(self, session: "Session") -> None:
        self._map = None
        super().show_nothing(session)
        self._place.clear()
        self._sum.clear()

    def _row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        name = QLabel(tr("Control point"))
        name.setToolTip(tr("Choose a control point here, or click it in the 3D scene."))
        row.addWidget(name)
        row.addWidget(self._faces)
        for box in self._boxes:
            row.addWidget(box)
        row.addWidget(self._place, 1)
        return row

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

    def _want(self) -> None:
        self._background.cancel()
        if self._seen():
            self._sum.setText(tr("Computed when the design rests…"))
            self._compute_soon()
            self._shared.show(point=self.point)
        self._show_veil()

    def _want_nothing(self) -> None:
        super()._want_nothing()
        self._shared.show(point=None)

    def _compute(self) -> None:
        frame = self._frame
        assert frame is not None
        request = DerivativeRequest(frame.session.scene, frame.state.heights, self.point)
        self._sum.setText(tr("Computing…"))
        self._background.begin(partial(_derivative, request), request)

    def _show_map(self, request: DerivativeRequest, found: "DerivativeMap") -> None:
        self._map, self._of = found, request
        self._place.setText(_place(found, request.scene.unit))
        self._sum.setText(_sum(found, request.scene.unit))
        self._show_veil()
        self._ask()

    def _give_up(self, sentence: str) -> None:
        self._map = None
        self._place.clear()
        self._sum.setText(sentence)
        self._ask()

    def _is_behind(self) -> bool:
        frame, of = self._frame, self._of
        if frame is None or self._map is None or of is None:
            return False
        return (of.heights, of.point) != (frame.state.heights, self.point)

    def _why_empty(self, frame: "Frame | None") -> str:
        if frame is not None and self._map is None:
            return tr("The map is not computed yet.")
        return super()._why_empty(frame)

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        self._image = DerivativeImage(axes, session.scene)
        return self._image.artists

    def _change(self, frame: "Frame") -> bool:
        return self._image.update(None if self._map is None else self._map.map)


def _index_box(axis: str) -> QSpinBox:
    box = QSpinBox()
    box.setKeyboardTracking(False)
    box.setToolTip(tr("Number of the control point along {axis}, counted from 0").format(axis=axis))
    box.setAccessibleName(tr("Control point along {axis}").format(axis=axis))
    return box


def _place(found: "DerivativeMap", unit: str) -> str:
    x, y = found.position
    return f"x = {written(x, unit, 3)}, y = {written(y, unit, 3)}"


def _sum(found: "DerivativeMap", unit: str) -> str:
    part = (
        tr(", {part} of the total flux there").format(
            part=written(found.sum / found.flux, digits=2)
        )
        if found.flux
        else ""
    )
    return tr("Sum: flux on the screen changes by {sum} per {unit}{part}").format(
        sum=written(found.sum, digits=2), unit=unit, part=part
    )


def _derivative(request: DerivativeRequest, task: Task) -> "DerivativeMap":
    # Late: torch comes with it, and the window shows before that.
    from workbench.analysis.derivatives import irradiance_derivative

    point = request.point
    return irradiance_derivative(request.scene, request.heights, point.index, face=point.face)
