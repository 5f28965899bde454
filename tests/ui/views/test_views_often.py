"""Opened, started and closed again and again, nothing is left."""

import pytest
from PySide6.QtWidgets import QMainWindow

from tests.ui.leftovers import left_behind, living
from ui.run.runner import Runner
from ui.views.irradiance_view import IrradianceView
from ui.views.scene_view import SceneView

pytestmark = pytest.mark.slow


def test_fifty_windows(display, session, as_run, qtbot):
    for round_ in range(50):
        before = living()
        window, scene, image = QMainWindow(), SceneView(), IrradianceView()
        runner = Runner(window, generate=as_run(1000, pause=0.002))
        window.setCentralWidget(scene)
        window.statusBar().addWidget(image)
        for view in (scene, image):
            runner.frame_ready.connect(view.show_frame)
        window.show()
        runner.start(session, continue_run=False)
        qtbot.waitUntil(lambda scene=scene: scene._contents.picture is not None)
        runner.shutdown()
        scene.close_plotter()
        window.close()
        window.deleteLater()
        del window, scene, image, runner, view
        assert left_behind(before) == [], f"in round {round_}"
