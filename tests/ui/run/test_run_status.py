"""Progress in the status bar: how far, how fast, how long still."""

from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QStatusBar

from tests.accounts import account_of
from tests.scene.test_images import SECOND
from ui.run.status import RunStatus
from workbench.analysis.metrics import relative_l2
from workbench.design.lens_state import FurtherLight
from workbench.design.loss import relative_error
from workbench.design.task import begin
from workbench.pictures.images import target_irradiance


@pytest.fixture
def bar(qtbot):
    bar = QStatusBar()
    qtbot.addWidget(bar)
    return bar


def frame(session, snapshot):
    return SimpleNamespace(session=session, snapshot=snapshot)


def method(session, make_scene, name):
    scene = make_scene({"run.method": name})
    return SimpleNamespace(scene=scene, target=session.target)


@pytest.mark.parametrize(("name", "left"), [("auto", "at most 0:06 left"), ("paper", "0:06 left")])
def test_progress_while_a_run_goes_on(bar, session, make_scene, snapshots, name, left):
    status = RunStatus(bar)
    task = method(session, make_scene, name)
    for iteration in (0, 20, 40):  # a tenth of a second each
        status.show_frame(frame(task, snapshots(iteration, 100)), running=True)
    assert status._iteration.text() == "iteration 40 of 100, 10/s"
    assert status._left.text() == left
    assert status._elapsed.text() == "0:04 elapsed"
    error = relative_error(snapshots(40, 100).state, task.target)
    assert status._light.text() == f"Error {100 * error:.1f} % · light on the screen 92.0 %"
    status.settle()
    assert status._left.text() == "" and status._progress.isHidden()


def test_status_shows_the_error_of_each_image(bar, make_scene, frames, tmp_path):
    session = begin(make_scene({"further_images": [SECOND]}), tmp_path)
    scene, wanted, _ = session.scene.wanted(session.target)[1]
    upside_down = target_irradiance(scene, wanted)[::-1] + 0.1
    further = FurtherLight(upside_down, 0.1, account_of(1.0, 0.3, 0.62, 0.0, 0.0, 0.0, 0.04, 0.04))
    exact = target_irradiance(session.scene, session.target)
    status = RunStatus(bar)
    status.show_frame(frames(1, session, irradiance=exact, further=(further,)), running=False)
    error = relative_l2(upside_down, wanted)
    assert error > 0.1
    stated = f"(0.00 %, {100 * error:.1f} %) · light on the screen 92.0 %, 30.0 %"
    assert status._light.text().endswith(stated)
    status.show_frame(frames(1, session, irradiance=exact, further=(further,)), False, "1.25 %")
    assert status._light.text() == "Verified error 1.25 % · light on the screen 92.0 %, 30.0 %"
