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
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

from ui.views.view import View, look_alike

if TYPE_CHECKING:
    from ui.frame import Frame
    from workbench.files.session import Session
    from workbench.pictures.lens import LensPicture


class SceneView(View):
    """Three-dimensional view that can be turned, moved and zoomed with the mouse."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
        self.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)
        self._plotter: Any = None
        self._picture: LensPicture | None = None
        self._shown: Session | None = None
        self._closed = False

    def fit(self) -> None:
        """Turn back to the default view with everything in it."""
        if self._picture is not None:
            self._picture.fit()
            self._plotter.update()

    def close_plotter(self) -> None:
        """Free what VTK holds; the view stays empty from then on. Safe to call twice."""
        self._closed = True
        self._picture = None
        if self._plotter is not None:
            self._plotter.close()
            self._plotter.deleteLater()
            self._plotter = None

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the default view fitted."""
        super().resizeEvent(event)
        if self._picture is not None and self._picture.fitted:
            self._picture.fit()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close the plotter with the view."""
        self.close_plotter()
        super().closeEvent(event)

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        if self._closed:
            return
        if self._plotter is None:
            self._open_plotter()
        if self._shown is None or not look_alike(self._shown, session):
            self._begin(session)
        self._shown = session
        if self._picture is not None and frame is not None:
            lit = frame.snapshot.irradiance
            self._picture.update(frame.surface, frame.paths, lit, frame.source)
        self._plotter.repaint()

    def _open_plotter(self) -> None:
        from pyvistaqt import QtInteractor

        self._plotter = QtInteractor(self, auto_update=False)
        self._plotter.ren_win.SetMultiSamples(0)
        self._plotter.setAcceptDrops(False)  # files dropped here are for the window
        self._box.addWidget(self._plotter)
        self._box.activate()
        self._plotter.show()  # a layout shows what joins it only in a later turn

    def _begin(self, session: "Session") -> None:
        from workbench.pictures.lens import LensPicture, space

        scene = session.scene
        moved = self._shown is None or not np.array_equal(space(self._shown.scene), space(scene))
        self._plotter.clear_actors()
        self._picture = LensPicture(self._plotter, scene, session.target, dark=self.is_dark())
        if moved:
            self._picture.fit()

    def _recolour(self) -> None:
        if self._picture is not None:
            self._picture.recolour(self.is_dark())
