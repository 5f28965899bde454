"""The lens, its rays and the screen in three dimensions.

1. The plotter is made when the view is first seen: VTK takes a second to load.
2. `auto_update` would render five times a second for ever; `SetMultiSamples(0)` makes a repaint
   in software OpenGL cost 60 ms instead of 200.
3. A repaint of the widget renders the scene. Calling `render` as well would do it twice.
4. While hidden or minimised nothing is rendered; the latest frame is drawn when shown again.
5. The camera belongs to the person: it moves by itself only when lens or screen take another
   place, or when the view is resized before it was ever touched.
6. A plotter that is not closed before its widget is destroyed takes VTK objects with it that
   crash later. `close_plotter` must be called from the window's closeEvent.
7. The view is a native window within the window. Otherwise the whole window is composed with
   OpenGL, and whatever is painted anywhere in it costs 13 ms more, also while the view is hidden.
8. A press and a release at one place are a click, which picks; anything else turns the camera. The
   plotter gets both in any case, or it would believe the button still pressed.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QCloseEvent, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QApplication, QWidget

from ui.frame import RAYS
from ui.views.view import View, look_alike

if TYPE_CHECKING:
    from ui.frame import Frame
    from workbench.files.session import Session
    from workbench.optics.paths import RayPaths
    from workbench.pictures.control_net import ControlNetPicture
    from workbench.pictures.lens import LensPicture
    from workbench.scene import Scene


class SceneView(View):
    """Three-dimensional view that can be turned, moved and zoomed with the mouse.

    Attributes
    ----------
    picked : Signal(tuple[int, int])
        The control point that was clicked, along x and along y.
    """

    picked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
        self.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)
        self._plotter: Any = None
        self._picture: LensPicture | None = None
        self._net: ControlNetPicture | None = None
        self._marked: tuple[int, int] | None = None
        self._pressed_at: QPointF | None = None
        self._shown: Session | None = None
        self._closed = False
        self._rays = 15
        self._exploded = False

    def show_rays(self, rays: int) -> None:
        """Show so many of the rays along each axis: a divisor of `RAYS`, or none."""
        self._rays = rays
        self._ask()

    def explode(self, exploded: bool) -> None:
        """Draw long distances short and a large screen small, or all to scale."""
        self._exploded = exploded
        self._shown = None
        self._ask()

    def fit(self, view: str = "") -> None:
        """Turn to a view of `workbench.pictures.camera.VIEWS`, or back to the default one."""
        if self._picture is not None:
            self._picture.fit(view)
            self._plotter.update()

    def mark(self, index: tuple[int, int] | None) -> None:
        """Show the control points with one of them marked, to be picked from; or none."""
        if index != self._marked:
            self._marked = index
            self._ask()

    def close_plotter(self) -> None:
        """Free what VTK holds; the view stays empty from then on. Safe to call twice."""
        self._closed = True
        self._picture = self._net = None
        if self._plotter is not None:
            self._plotter.close()
            self._plotter.deleteLater()
            self._plotter = None

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the default view fitted."""
        super().resizeEvent(event)
        if self._picture is not None and self._picture.fitted:
            self._picture.fit_again()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close the plotter with the view."""
        self.close_plotter()
        super().closeEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Watch the plotter for clicks."""
        if isinstance(event, QMouseEvent) and event.button() is Qt.MouseButton.LeftButton:
            if event.type() == QEvent.Type.MouseButtonPress:
                self._pressed_at = event.position()
            elif event.type() == QEvent.Type.MouseButtonRelease and self._pressed_at is not None:
                moved = (event.position() - self._pressed_at).manhattanLength()
                if moved < QApplication.startDragDistance():
                    self._pick(event.position())
        return super().eventFilter(watched, event)

    def _pick(self, place: QPointF) -> None:
        if self._net is None:
            return
        scale = self.devicePixelRatioF()  # VTK counts the screen's pixels, from below
        index = self._net.pick(place.x() * scale, (self._plotter.height() - 1 - place.y()) * scale)
        if index is not None:
            self.picked.emit(index)

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        if self._closed:
            return
        if self._plotter is None:
            self._open_plotter()
        if frame is None or self._shown is None or not look_alike(self._shown, session):
            self._begin(session)
        self._shown = session
        if self._picture is not None and frame is not None:
            lit, paths = frame.snapshot.irradiance, _some(frame.paths, self._rays)
            self._picture.update(frame.surface, paths, lit, frame.source)
        if self._net is not None and frame is not None:
            self._net.update(frame.snapshot.control_points)
            self._net.mark(self._marked)
        self._plotter.repaint()

    def _open_plotter(self) -> None:
        from pyvistaqt import QtInteractor

        self._plotter = QtInteractor(self, auto_update=False)
        self._plotter.ren_win.SetMultiSamples(0)
        self._plotter.setAcceptDrops(False)  # files dropped here are for the window
        self._plotter.installEventFilter(self)
        self._box.addWidget(self._plotter)
        self._box.activate()
        self._plotter.show()  # a layout shows what joins it only in a later turn

    def _begin(self, session: "Session") -> None:
        from workbench.pictures.control_net import ControlNetPicture
        from workbench.pictures.lens import LensPicture

        scene, dark, explode = session.scene, self.is_dark(), self._exploded
        moved = self._shown is None or not np.array_equal(
            self._space(self._shown.scene), self._space(scene)
        )
        self._plotter.clear_actors()
        self._picture = LensPicture(
            self._plotter, scene, session.target, dark=dark, explode=explode
        )
        self._net = ControlNetPicture(self._plotter, scene.lens, dark=dark)
        if moved:
            self._picture.fit()

    def _space(self, scene: "Scene") -> npt.NDArray[np.float64]:
        """What the picture of a scene has to hold."""
        from workbench.pictures.camera import space
        from workbench.pictures.exploded import exploded

        return space(exploded(scene) if self._exploded else scene)

    def _recolour(self) -> None:
        if self._picture is not None:
            self._picture.recolour(self.is_dark())
        if self._net is not None:
            self._net.recolour(self.is_dark())


def _some(paths: "RayPaths", count: int) -> "RayPaths":
    """Evenly spread ones of `RAYS` × `RAYS` rays, the middle one among them; or none."""
    chosen = np.zeros((RAYS, RAYS), dtype=bool)
    if count:
        step = RAYS // count
        chosen[step // 2 :: step, step // 2 :: step] = True
    kept = chosen.ravel()
    return type(paths)(paths.points[kept], paths.weight[kept], paths.on_screen[kept])
