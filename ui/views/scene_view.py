"""The lens, its rays and the screen in three dimensions.

1. The plotter is created when the view is first shown: VTK takes a second to load.
2. `auto_update` would render five times a second; `SetMultiSamples(0)` makes a repaint in software
   OpenGL cost 60 ms instead of 200. A repaint of the widget renders; `render` would do so twice.
3. The camera moves by itself only when an object moves and nobody has placed the camera, when
   objects move far (not during a drag), or on resizing before its first use.
4. A plotter that is not closed before its widget is destroyed crashes later: `close_plotter` must
   be called from the window's closeEvent.
5. The view is a native window. Otherwise OpenGL composes the whole window: 13 ms for each paint.
6. The plotter gets the events that no tool uses. Tools request drawing by `_ask`.
7. The camera flies to a view as long as the style animates its widgets: not at all where the system
   asks for less motion. A press, a key or the wheel stops it on its way.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QEvent, QObject, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QGridLayout, QSizePolicy

from ui.document.frame import Frame, same_task
from ui.views.flight import Flight
from ui.views.image_canvas import RING, frame_focused
from ui.views.scene_contents import FaceNets, SceneContents, Spots
from ui.views.shared_view import SharedView
from ui.views.tools import Pointer, Tool, ToolInput, pixel_at, pointer_at, steer
from ui.views.view import View
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import make_native
from ui.words import capitalised, tr
from workbench.arrays import Array
from workbench.design.limits import bounded
from workbench.files.session import Session
from workbench.geometry.faces import ControlHeights
from workbench.scene import Element, Scene

if TYPE_CHECKING:
    from workbench.pictures.camera import CameraState
    from workbench.pictures.compass import Compass
    from workbench.pictures.handles import Handles, SeenPart
    from workbench.pictures.projection import Projection

_STOPS = QEvent.Type.MouseButtonPress, QEvent.Type.Wheel
_NOTCH = 1.2  # times as large, by a notch of the wheel
_FAR = 0.25  # in parts of what all objects span


class SceneView(View):
    """Three-dimensional view that can be turned, moved and zoomed with mouse and keyboard."""

    escaped = Signal()
    menu_asked = Signal(object)  # QPoint of the screen

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._options = self._shared.now
        self._shared.changed.connect(self._follow_options)
        make_native(self)
        self._plotter: Any = None
        self._compass: Compass | None = None
        self._flight = Flight(self, self._fly)
        self._contents: SceneContents | None = None
        self._spots: Spots | None = None
        self.nets = FaceNets(self)
        self.nets.changed.connect(self._ask)
        self._tool: Tool | None = None
        self._shown: Session | None = None
        self._held: Array | None = None  # what the camera was turned to
        self._placement: dict[str, Any] | None = None  # of the camera, once the design is there
        self._closed = False
        self._tool_input = ToolInput(self)
        self._tool_input.clicked.connect(self._pick)
        # Queued: the plotter has its release before.
        queued = Qt.ConnectionType.QueuedConnection
        self._tool_input.menu_asked.connect(self.menu_asked, queued)
        self._tool_input.wheeled.connect(self._zoom)
        self._tool_input.escaped.connect(self.escaped)
        self._hint = WrappedLabel()
        self._hint.setObjectName("hint")
        self._hint.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._hint.hide()
        make_native(self._hint)
        # Over the picture, which words that come, go or grow leave as it is.
        self._over = QGridLayout()
        self._over.addWidget(self._hint, 0, 0, Qt.AlignmentFlag.AlignBottom)
        self._box.addLayout(self._over, 1)
        self._box.setContentsMargins(*4 * [RING])

    @property
    def frame(self) -> Frame | None:
        return self._frame

    @property
    def optic(self) -> Element | None:
        """The element of the selected face, with its bounds."""
        if self._shown is None:
            return None
        return bounded(self._shown.scene.focused_on(self.nets.face))

    @property
    def face_title(self) -> str:
        """Title of the selected face; empty for a single one."""
        if self._shown is None or len(self.nets.faces) < 2:
            return ""
        return capitalised(tr(self._shown.scene.face_in_words(self.nets.face)))

    @property
    def exploded(self) -> bool:
        return self._options.exploded

    @property
    def unit(self) -> str:
        return "" if self._shown is None else self._shown.scene.unit

    @property
    def handles(self) -> "Handles | None":
        """The handles of source, elements and screen; None before the first drawing."""
        return None if self._contents is None else self._contents.handles

    @property
    def sight(self) -> "Projection | None":
        """Projection of the view; None before the first drawing."""
        return None if self._contents is None else self._contents.sight

    def use(self, tool: Tool | None) -> None:
        """Give the left button to another tool, or to the camera alone."""
        self._tool_input.take(tool)
        self._tool = tool
        self._hint.setVisible(tool is not None)
        if tool is not None:
            self._hint.setText(tool.hint)
        if self._plotter is not None:
            self._show_cursor()
            self._plotter.setFocus()  # for Esc
        self._ask()

    def drop(self) -> None:
        self._tool_input.drop()

    def part_at(self, at: QPoint) -> "SeenPart | None":
        """Return the part of the scene at a place on the monitor."""
        if self._shown is None or self._contents is None:
            return None
        from workbench.pictures.handles import part_at

        place = pixel_at(self._plotter, self._plotter.mapFromGlobal(at).toPointF())
        return part_at(self._drawn(self._shown.scene), self._contents.sight, *place)

    def refresh(self) -> None:
        """Draw what a tool has changed, its hint included."""
        self._ask()

    def show_design(self, session: Session) -> None:
        """Take note of another scene, target or set of locks."""
        super().show_design(session)
        self.nets.show_locks(session.locked)

    def hold_camera(self, scene: Scene) -> None:
        """Keep the camera when this scene arrives, as if a person had placed it."""
        self._held = self._space(scene)
        if self._contents is not None:
            self._contents.picture.camera.hold()

    def camera(self) -> dict[str, Any] | None:
        """Where the camera stands, as plain data; None before the first drawing."""
        if self._placement is None and self._contents is not None:
            self._flight.land()
            return self._contents.picture.camera.placement()
        return self._placement

    def set_camera(self, placement: dict[str, Any]) -> None:
        """Restore the camera; raise ValueError if it is invalid."""
        from workbench.pictures.camera import check_placement

        check_placement(placement)
        self._placement = placement
        self._ask()

    def picture(self, times: int) -> npt.NDArray[np.uint8] | None:
        """Return the magnified picture, shape (rows, columns, 3); None before drawing.

        It is without the compass.
        """
        if self._contents is None or self._compass is None:
            return None
        self._compass.show(False)
        self._plotter.render()  # a screenshot is of what was rendered last
        pixels = self._plotter.screenshot(return_img=True, scale=times)
        self._compass.show(True)
        self._plotter.update()
        return np.ascontiguousarray(pixels[..., :3])

    def show_spots(self, heights: ControlHeights, places: Array) -> None:
        """Mark points (n, 3) of a lens with these heights while it is shown."""
        self._spots = heights, places
        self._ask()

    def fit(self, view: str = "") -> None:
        """Turn to a view of `workbench.pictures.camera.FittedCamera.fit`, or to the default one."""
        if self._contents is not None:
            picture = self._contents.picture
            picture.camera.hidden = self._pixels_of_hint()
            picture.camera.choose(self.nets.face)
            before = picture.camera.state()
            picture.fit(view)
            self._plotter.update()
            self._flight.begin(before, picture.camera.state())

    def _fly(self, before: "CameraState", after: "CameraState", part: float) -> None:
        if self._contents is not None:
            self._contents.picture.camera.fly(before, after, part)
            self._plotter.update()

    def _pixels_of_hint(self) -> int:
        height = self._hint.height() if self._hint.isVisible() else 0
        return round(height * self.devicePixelRatioF())

    def close_plotter(self) -> None:
        """Free what VTK holds; the view stays empty from then on. Safe to call twice."""
        self._closed = True
        self._flight.stop()
        if self._contents is not None:
            self._contents.close()
            self._contents = None
        if self._plotter is not None and self._compass is not None:
            self._compass.close()
            self._compass = None
            self._plotter.close()
            self._plotter.deleteLater()
            self._plotter = None

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._flight.land()
        QTimer.singleShot(0, self, self._fit_again)  # once the plotter has its new size

    def _fit_again(self) -> None:
        if self._contents is not None and self._contents.picture.fitted:
            self._contents.picture.camera.hidden = self._pixels_of_hint()
            self._contents.picture.fit_again()
            self._plotter.update()  # the plotter may have been painted before the frame came

    def closeEvent(self, event: QCloseEvent) -> None:
        self.close_plotter()
        super().closeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._plotter is not None:
            frame_focused(self, self._plotter)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        plotter = self._plotter
        if event.type() in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self.update()
        if isinstance(event, QMouseEvent | QWheelEvent) and event.type() in _STOPS:
            self._flight.stop()
        kept = plotter is not None and (
            self._turn_by_compass(event) or self._tool_input.keeps(plotter, event)
        )
        return kept or super().eventFilter(watched, event)

    def _turn_by_compass(self, event: QEvent) -> bool:
        if self._compass is None or not isinstance(event, QMouseEvent):
            return False
        if event.type() != _STOPS[0] or event.button() is not Qt.MouseButton.LeftButton:
            return False
        at = pointer_at(self._plotter, event)
        view = self._compass.pick(at.x, at.y)
        if view:
            self.fit(view)
        return bool(view)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if event.reason() is QContextMenuEvent.Reason.Keyboard:  # the mouse may also drag
            self.menu_asked.emit(event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        self._flight.stop()
        if self._contents is not None and steer(self._contents.picture.camera, event):
            self._plotter.update()
        else:
            super().keyPressEvent(event)

    def _pick(self, at: Pointer) -> None:
        point = self.nets.pick(at.x, at.y)
        if point is not None:
            self._shared.picked.emit(point)

    def _zoom(self, at: Pointer, notches: float) -> None:
        contents = self._contents
        if contents is not None:
            contents.picture.camera.zoom(_NOTCH**notches, contents.sight.point(at.x, at.y))
            self._plotter.update()

    def _follow_options(self) -> None:
        before, self._options = self._options, self._shared.now
        if before.of_scene == self._options.of_scene:
            return
        self.nets.mark(self._options.point)
        if before.exploded != self._options.exploded:
            self._shown = None
        if self._contents is not None:
            self._contents.picture.project(self._options.perspective)
            self._contents.picture.colour_rays(self._options.by_weight)
        self._ask()

    def _draw(self, session: Session, frame: Frame | None) -> None:
        if self._closed:
            return
        if self._plotter is None:
            self._open_plotter()
        if frame is None or self._shown is None or not same_task(self._shown, session):
            self._begin(session)
        self._shown, contents = session, self._contents
        assert contents is not None  # since it began
        latest = self._session is None or same_task(session, self._session)
        if self._placement is not None and latest:
            contents.picture.camera.place(self._placement)
            self._placement = None
        if frame is not None:
            if self._tool is not None:
                self._hint.setText(self._tool.hint)
            contents.draw(frame, self._options, self._tool, self._spots)
        self._plotter.repaint()

    def _open_plotter(self) -> None:
        from pyvistaqt import QtInteractor

        from workbench.pictures.compass import Compass

        self._plotter = QtInteractor(self, auto_update=False)
        self._plotter.ren_win.SetMultiSamples(0)
        self._compass = Compass(self._plotter)
        self._plotter.setAcceptDrops(False)  # files dropped here are for the window
        self._plotter.installEventFilter(self)
        self._show_cursor()
        self._over.addWidget(self._plotter, 0, 0)
        self._box.activate()
        self._plotter.show()  # a layout shows what joins it only in a later turn
        self._hint.raise_()

    def _show_cursor(self) -> None:
        self._plotter.setCursor(self._tool.cursor if self._tool else Qt.CursorShape.ArrowCursor)

    def _begin(self, session: Session) -> None:
        self._flight.land()
        space, former = self._space(session.scene), self._contents
        fitted = former is None or former.picture.fitted
        view = "" if former is None else former.picture.camera.view
        moved = self._held is None or _moved(self._held, space) > (0.0 if fitted else _FAR)
        if former is not None:
            former.handles.close()
        self._contents = SceneContents(
            self._plotter, session, self._options, self.nets, dark=self.is_dark()
        )
        if moved:
            self._held = space
        if moved or fitted:
            self._contents.picture.fit("" if moved else view)

    def _space(self, scene: Scene) -> Array:
        from workbench.pictures.camera import scene_corners

        return scene_corners(self._drawn(scene))

    def _drawn(self, scene: Scene) -> Scene:
        from workbench.pictures.compressed import compress_distances

        return compress_distances(scene) if self._options.exploded else scene

    def _recolour(self) -> None:
        if self._contents is not None:
            self._contents.recolour(dark=self.is_dark())


def _moved(before: Array, after: Array) -> float:
    """How far corners (n, 3) of the objects moved, in parts of what they span."""
    if before.shape != after.shape:
        return math.inf
    return float(np.abs(after - before).max() / np.ptp(before))
