"""What is saved, exported and reported while a run goes on, and after an edit of the task."""

import dataclasses

import numpy as np
import pytest

from tests.ui.hands import enter, move_screen
from workbench.files.session import KeptRun, read_session

pytestmark = pytest.mark.usefixtures("kernels", "display")


@pytest.fixture
def built(window):
    window.build()
    return window


@pytest.fixture
def running(built, make_scene, qtbot):
    """A window with a long run that has a best lens already."""
    # The paper's method takes all its iterations; the other one ends as soon as nothing is gained.
    scene = make_scene({"run.method": "paper", "run.iterations": 100_000})
    built.document.edit(scene, "run", "")
    built.start()
    runner = built.loaded.control.runner
    qtbot.waitUntil(lambda: runner.best is not None and runner.best.iterations > 2, timeout=60_000)
    return built


@pytest.fixture
def carried(open_window, designed, qtbot):
    """A window whose task was edited after its lens was designed."""
    run = KeptRun("Run 1: flat", designed.scene, designed.target, designed.result)
    window = open_window(dataclasses.replace(designed, runs=(run,)))
    window.build()
    move_screen(window.document, 7)
    assert window.document.session.result is None
    qtbot.waitUntil(lambda: window._lens.session is not None, timeout=60_000)
    return window


def stop(window, qtbot):
    window.loaded.control.runner.stop()
    qtbot.waitUntil(lambda: not window.loaded.control.busy, timeout=60_000)


def test_a_run_can_be_saved_with_its_best_lens_so_far(running, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "mine.freeform"
    monkeypatch.setattr(running.dialogs, "to_save", lambda *_: path)
    assert running.commands["save"].isEnabled()
    running.commands["save"].trigger()
    saved = read_session(path)
    assert saved.result.iterations > 2
    assert running.loaded.control.busy and running.document.dirty
    assert "with the best lens so far" in running.status._state.text()
    stop(running, qtbot)
    running.document.undo_stack.undo()  # the run
    assert running.document.dirty  # the file holds a lens
    assert running.document.session.result is None


def test_a_run_can_be_exported(running, qtbot, tmp_path):
    assert running.commands["export"].isEnabled() and running.commands["report"].isEnabled()
    running.exporter.export(tmp_path / "lens.step")
    qtbot.waitUntil(lambda: not running.exporter.background.busy, timeout=60_000)
    assert (tmp_path / "lens.step").stat().st_size > 0
    assert "the best lens so far, after" in running.messages.text


def test_a_lens_of_another_task_is_exported_as_it_is_shown(carried, designed, qtbot, tmp_path):
    assert carried.commands["export"].isEnabled() and carried.commands["report"].isEnabled()
    received = (
        "designed for another task (Run 1: flat): "
        "images[0].receiver.position [0.0, 0.0, 5.0], now [0.0, 0.0, 7.0]"
    )
    assert received in carried.commands["export"].toolTip()
    shown = carried._lens.session
    np.testing.assert_array_equal(
        shown.result.state.heights["lens.back"], designed.result.state.heights["lens.back"]
    )
    assert shown.scene.receiver.z == 7
    carried.exporter.export(tmp_path / "lens.irradiance.npy")
    qtbot.waitUntil(lambda: not carried.exporter.background.busy, timeout=60_000)
    assert received in carried.messages.text
    np.testing.assert_array_equal(
        np.load(tmp_path / "lens.irradiance.npy"), shown.result.state.irradiance
    )


def test_an_edit_waits_for_the_run_or_stops_it(running, qtbot):
    enter(qtbot, running.forms, "images[0].receiver.position[2]", "7")
    assert running.document.session.scene.receiver.z == 5 and running.loaded.control.busy
    assert "Waiting for the end of the run: change of receiver position." in running.messages.text
    stop_and_apply, _ = running.messages.buttons
    assert stop_and_apply.text() == "Stop and apply"
    with qtbot.waitSignal(running.loaded.control.ended, timeout=60_000):
        stop_and_apply.click()
    assert running.document.session.scene.receiver.z == 7
    assert not running.messages.isVisible()
    running.document.undo_stack.undo()
    assert running.document.session.scene.receiver.z == 5
    assert running.document.session.result is not None  # of the run, for the task that it had
