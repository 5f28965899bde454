"""Progress in the status bar: how far, how fast, how long still."""

from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QStatusBar

from tests.accounts import account_of
from tests.scene.test_further_image import SECOND
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


def test_a_lens_at_rest_has_no_pace(bar, session, snapshots):
    status = RunStatus(bar)
    status.show_frame(frame(session, snapshots(7)), running=False)
    assert status._iteration.text() == "iteration 7 of 10"
    assert status._left.text() == ""


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
    said = f"Error 0.00 %, {100 * error:.1f} % · light on the screen 92.0 %, 30.0 %"
    assert status._light.text() == said


def test_verified_figures_are_there_only_when_there_are_some(bar):
    status = RunStatus(bar)
    assert status._verified.isHidden()
    status.show_verified("Checked error 1.20 % at 40")
    assert not status._verified.isHidden()
    status.show_verified("")
    assert status._verified.isHidden()


def test_message_is_whole_in_its_tip_and_is_replaced_by_the_next_state(bar, qtbot):
    status = RunStatus(bar)
    status.show_state("Designing…")
    bar.show()
    status.tell(said := "Saved pendant.freeform, with the best lens so far, after 176 iterations")
    qtbot.waitUntil(lambda: bar.minimumSizeHint().width() < 200)  # figures take no room
    bar.resize(300, bar.height())
    qtbot.waitUntil(lambda: status._state.toolTip() == said)
    assert status._state.shown.endswith("…") and status.text == said
    status._read.timeout.emit()
    assert status.text == "Designing…"
    status.tell(said)
    status.show_state("Stopping…")
    assert status.text == "Stopping…" and not status._read.isActive()


def test_why_a_run_ended_can_be_read_in_a_narrow_window(bar, qtbot, session, snapshots):
    status = RunStatus(bar)
    bar.resize(1280, bar.sizeHint().height())
    bar.show()
    status.show_frame(frame(session, snapshots(53, 300)), running=False)
    status.show_check("Checked error 3.19 %")
    status.show_bound("at best 2.31 %", "")
    status.show_state(
        said := "Converged: error less than 0.015 percentage points lower in 5 iterations"
    )
    qtbot.waitUntil(lambda: status._state.shown == said)
    assert not status._light.isHidden() and not status._check.isHidden()
    status.show_state(longer := f"{said}; of both faces it was 0.5 times that of one")
    qtbot.waitUntil(lambda: status._state.shown == longer)
    assert status._loss.isHidden() and not status._light.isHidden()
    bar.resize(2560, bar.height())
    qtbot.waitUntil(lambda: not status._loss.isHidden())
    assert status._loss.minimumWidth() > 0
