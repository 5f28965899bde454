"""A window with the tools of the 3D view, and drags over it."""

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QMainWindow

from ui.document.document import Document
from ui.lens.tools import LensTools
from ui.run.control import RunControl
from ui.views.scene_view import SceneView
from workbench.design.limits import undesigned

LEFT = Qt.MouseButton.LeftButton


class ToolWindow:
    """The 3D view with its tools, a document and its runs, and no more of the window."""

    def __init__(self, session):
        self.document = Document(session, "by hand")
        self.window = QMainWindow()
        self.document.setParent(self.window)
        self.view = SceneView()
        self.window.setCentralWidget(self.view)
        self.window.resize(640, 480)
        self.control = RunControl(self.document, self.window)
        self.tools = LensTools(self.document, self.control, self.view, self.window)
        self.commands = self.tools.slots()
        self.stated, self.put_away = [], []
        self.tools.message.connect(self.stated.append)
        self.view.escaped.connect(lambda: self.put_away.append(True))
        self.view.show_design(session)
        self.document.session_changed.connect(self.view.show_design)
        self.control.runner.frame_ready.connect(self.view.show_frame)

    def close(self):
        self.control.close()
        self.tools.close()
        self.view.close_plotter()

    def heights(self):
        session = self.document.session
        return (session.heights or undesigned(session.scene.optic))["lens.back"]


def seen_at(view, place):
    """Where a place of the scene is seen, as Qt counts."""
    ((x, y),) = view.sight.pixels(np.array([place]))
    scale = view.devicePixelRatioF()
    return QPoint(round(x / scale), view._plotter.height() - 1 - round(y / scale))


class Drag:
    """A drag over the 3D view that the test begins, moves and ends."""

    def __init__(self, qtbot, view, start):
        self._qtbot, self._plotter, self.at = qtbot, view._plotter, start
        qtbot.mousePress(self._plotter, LEFT, pos=start)

    def move(self, by, keys=Qt.KeyboardModifier.NoModifier):
        self.at = self.at + by
        place = QPointF(self.at)
        QApplication.sendEvent(
            self._plotter,
            QMouseEvent(
                QEvent.Type.MouseMove,
                place,
                self._plotter.mapToGlobal(place),
                Qt.MouseButton.NoButton,
                LEFT,
                keys,
            ),
        )

    def release(self):
        self._qtbot.mouseRelease(self._plotter, LEFT, pos=self.at)


def control_point(tools, index):
    return seen_at(tools.view, tools.view.nets.picture.places(index))


def upwards(view, length):
    """Pixels, as Qt counts, that lead so far along z."""
    there = seen_at(view, (0, 0, 0.5 + length)) - seen_at(view, (0, 0, 0.5))
    assert there.manhattanLength() > 1
    return there
