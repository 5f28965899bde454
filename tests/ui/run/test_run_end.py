"""The window says in what state a run is, and at last why it ended."""

import pytest

from workbench.errors import RunFailed

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def window(display, window):
    window.build()
    return window


def state(window):
    return window.status._state.text()


def run(window, qtbot, generate):
    window.loaded.control.runner._generate = generate
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()


def test_the_status_bar_says_why_the_run_ended(window, as_run, qtbot):
    assert state(window) == "Ready"
    run(window, qtbot, as_run(3))
    assert state(window) == "All iterations are done"
    window.commands["undo"].trigger()
    assert state(window) == "Ready"


def test_a_stop_and_a_failure_are_reasons(window, snapshots, as_run, qtbot):
    def fails(scene, target, start=None, locked=None):
        yield snapshots(0)
        raise RunFailed("the loss is not finite")

    run(window, qtbot, fails)
    assert state(window) == "Failed: the loss is not finite"
    window.loaded.control.runner._generate = as_run(100_000, pause=0.01)
    window.commands["start"].trigger()
    assert state(window) == "Designing…"
    qtbot.waitUntil(lambda: window.loaded.control.history.frames != [], timeout=60_000)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["stop"].trigger()
    assert state(window) == "Stopped: Continue (Shift+F5) can make the lens better"
