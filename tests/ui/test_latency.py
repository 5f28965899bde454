"""How long the window is held up while a design runs. Figures are printed, not asserted."""

import os

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QWidget

from ui.runner import Runner
from ui.views.error_view import ErrorView
from ui.views.irradiance_view import IrradianceView
from ui.views.loss_view import LossView
from ui.views.scene_view import SceneView
from workbench.files.session import Session
from workbench.targets import load_target

pytestmark = pytest.mark.slow

_SECONDS = float(os.environ.get("LATENCY_SECONDS", "20"))
_WARMING_SECONDS = 4.0  # imports, first drawings


@pytest.fixture
def full_session(make_scene, tmp_path):
    """A design of the size that people work with."""
    scene = make_scene(
        {
            "lens.control_points": [64, 64],
            "source.rays": [512, 512],
            "screen.pixels": [256, 256],
            "run.iterations": 1_000_000,
            "target": {"builtin": "flame"},
        }
    )
    return Session(scene, load_target(scene, tmp_path))


@pytest.fixture
def window(display, qtbot):
    """All views as in the main window."""
    made = QMainWindow()
    views = {kind: kind() for kind in (SceneView, IrradianceView, ErrorView, LossView)}
    qtbot.addWidget(made, before_close_func=lambda _: views[SceneView].close_plotter())
    made.resize(1600, 1000)
    stage = QWidget()
    made.setCentralWidget(stage)
    views[SceneView].setParent(stage)
    right, below = Qt.DockWidgetArea.RightDockWidgetArea, Qt.DockWidgetArea.BottomDockWidgetArea
    for kind, area in ((IrradianceView, right), (ErrorView, right), (LossView, below)):
        dock = QDockWidget(kind.__name__, made)
        dock.setWidget(views[kind])
        made.addDockWidget(area, dock)
    made.resizeDocks(made.findChildren(QDockWidget)[2:], [250], Qt.Orientation.Vertical)
    made.views = views
    yield made


@pytest.mark.parametrize("shown", [True, False], ids=["3D shown", "3D hidden"])
def test_window_answers_during_a_run(
    shown, window, full_session, latency_probe, qtbot, capsys, request
):
    runner = Runner()
    request.addfinalizer(runner.shutdown)
    frames = []
    runner.frame_ready.connect(frames.append)
    for view in window.views.values():
        runner.frame_ready.connect(view.show_frame)
    window.show()
    scene_view = window.views[SceneView]
    scene_view.setVisible(shown)
    scene_view.resize(1200, 650)
    runner.start(full_session, continue_run=False)
    qtbot.wait(int(1000 * _WARMING_SECONDS))
    latency_probe.start()
    qtbot.wait(int(1000 * _SECONDS))
    latency_probe.stop()
    with qtbot.waitSignal(runner.finished):
        runner.stop()
    with capsys.disabled():
        print("\n" + latency_probe.report(request.node.callspec.id), end="")
        print(f"; {len(frames)} frames, {frames[-1].snapshot.iteration} iterations")
    assert len(frames) > 2
    assert scene_view._frame is frames[-1]
    assert (scene_view._plotter is not None) == shown
