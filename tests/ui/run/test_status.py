"""The status bar, and the log of a run."""

import dataclasses

import pytest

from workbench.errors import RunFailed
from workbench.scene import Stage

pytestmark = pytest.mark.usefixtures("kernels")


def lines(log):
    return [line.split("  ", 1) for line in log.toPlainText().splitlines()]


def sentences(log):
    return [text for _, text in lines(log)]


@pytest.fixture
def window(display, window):
    window.build()
    return window


def run_with(window, qtbot, generate):
    window.loaded.control.runner._generate = generate
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()


def test_a_run_logs_its_phases_and_its_trace_once(window, snapshots, as_seen_run, qtbot):
    def staged(iteration, iterations):
        notes = ("reference",) if iteration < 3 else ("fused kernels", "box filter")
        shot = snapshots(iteration, iterations)
        return dataclasses.replace(shot, stage=int(iteration > 1), stages=2, notes=notes)

    scene = window.document.session.scene
    stages = scene.model_copy(
        update={"run": scene.run.model_copy(update={"stages": (Stage(iterations=1),)})}
    )
    window.document.edit(stages, "stages", "")
    run = as_seen_run(window.loaded.control.runner, 3, staged)
    run_with(window, qtbot, run)
    assert sentences(window.log) == [
        "Run started: small, method auto",
        "Stage 1 of 2, iteration 0",
        "Trace: reference",
        "Stage 2 of 2, iteration 2",
        "Trace: fused kernels; box filter",
        "Run ended (all iterations are done) after iteration 3 of 3, 0:00: "
        "last loss 0.25, 92.0 % on the screen",
    ]


def state(window):
    return window.status._state.text()


def test_the_status_bar_says_why_the_run_ended(window, as_run, qtbot):
    assert state(window) == "Ready"
    run_with(window, qtbot, as_run(3))
    assert state(window) == "All iterations are done"
    window.commands["undo"].trigger()
    assert state(window) == "Ready"


def test_a_stop_and_a_failure_are_reasons(window, snapshots, as_run, qtbot):
    def fails(scene, target, start=None, locked=None):
        yield snapshots(0)
        raise RunFailed("the loss is not finite")

    run_with(window, qtbot, fails)
    assert state(window) == "Failed: the loss is not finite"
    window.loaded.control.runner._generate = as_run(100_000, pause=0.01)
    window.commands["start"].trigger()
    assert state(window) == "Designing…"
    qtbot.waitUntil(lambda: window.loaded.control.history.frames != [], timeout=60_000)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["stop"].trigger()
    assert state(window) == "Stopped; Continue (Shift+F5) improves the lens"
