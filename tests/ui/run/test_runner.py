"""The runner with its thread."""

import threading
import time

import numpy as np
import pytest
from PySide6.QtCore import QThread

from ui.run.control import Runner
from workbench.errors import RunFailed
from workbench.progress import check_given_up


class Heard:
    """What a runner stated."""

    def __init__(self, runner):
        self.states, self.frames, self.results, self.failures, self.threads = [], [], [], [], []
        runner.state_changed.connect(self.states.append)
        runner.frame_ready.connect(self.frames.append)
        runner.frame_ready.connect(lambda _: self.threads.append(QThread.currentThread()))
        runner.finished.connect(self.results.append)
        runner.failed.connect(self.failures.append)


@pytest.fixture
def start_runner(qapp):
    runners = []

    def make(generate):
        runner = Runner(generate=generate)
        runners.append(runner)
        return runner, Heard(runner)

    yield make
    for runner in runners:
        runner.shutdown()


@pytest.fixture
def gated(snapshots, start_runner):
    """An endless run that takes a step each time it is let, and counts them.

    It comes after `start_runner`, and so lets a waiting run go before the runner is shut down.
    """

    class Steps:
        def __init__(self):
            self.allowed = threading.Semaphore(0)
            self.taken = 0

        def __call__(self, scene, target, start=None, locked=None):
            while True:
                self.allowed.acquire()
                yield snapshots(self.taken)
                self.taken += 1

    steps = Steps()
    yield steps
    steps.allowed.release(1000)


def test_runs_to_the_end(session, as_run, start_runner, qtbot, qapp):
    runner, heard = start_runner(as_run(5))
    with qtbot.waitSignal(runner.finished):
        runner.start(session, continue_run=False)
        assert runner.state == "running"
    assert heard.states == ["running", "idle"]
    assert heard.frames[-1].snapshot.iteration == 5
    assert heard.results[0].iterations == 5
    assert set(heard.threads) == {qapp.thread()}


def test_stops_before_the_next_iteration(session, gated, start_runner, qtbot):
    runner, heard = start_runner(gated)
    runner.start(session, continue_run=False)
    gated.allowed.release(3)
    qtbot.waitUntil(lambda: gated.taken == 3)
    runner.stop()
    assert runner.state == "stopping"
    with qtbot.waitSignal(runner.finished):
        gated.allowed.release(100)
    assert gated.taken == 3
    assert heard.states == ["running", "stopping", "idle"]
    assert heard.results[0].iterations == 3
    assert heard.frames[-1].snapshot.iteration == 3


@pytest.mark.parametrize("paused", [False, True])
def test_a_first_design_that_takes_long_is_given_up_after_stop(
    session, start_runner, qtbot, paused
):
    began = threading.Event()

    def endless(scene, target, start=None, locked=None):
        began.set()
        while True:
            check_given_up()
            time.sleep(0.01)
        yield

    runner, heard = start_runner(endless)
    runner.start(session, continue_run=False)
    assert began.wait(10)
    if paused:
        runner.pause()
    runner.stop()
    qtbot.waitUntil(lambda: runner.state == "idle", timeout=20_000)
    assert heard.results == [None] and not heard.failures


def test_pauses_shows_the_last_snapshot_and_resumes(session, gated, start_runner, qtbot):
    runner, heard = start_runner(gated)
    runner.start(session, continue_run=False)
    gated.allowed.release(3)
    qtbot.waitUntil(lambda: gated.taken == 3)
    runner.pause()
    assert runner.state == "paused"
    gated.allowed.release(2)
    qtbot.waitUntil(lambda: [f.snapshot.iteration for f in heard.frames][-1:] == [3])
    qtbot.wait(50)
    assert gated.taken == 3  # the snapshot is out, the next is not asked for
    runner.resume()
    assert runner.state == "running"
    qtbot.waitUntil(lambda: gated.taken == 5)
    assert heard.states == ["running", "paused", "running"]


def test_a_failure_is_signalled_before_the_end(session, snapshots, start_runner, qtbot):
    def run(scene, target, start=None, locked=None):
        yield snapshots(0)
        raise RunFailed("the loss is not finite")

    runner, heard = start_runner(run)
    order = []
    runner.failed.connect(lambda _: order.append("failed"))
    runner.finished.connect(lambda _: order.append("finished"))
    with qtbot.waitSignal(runner.finished):
        runner.start(session, continue_run=False)
    assert order == ["failed", "finished"]
    assert heard.failures == ["the loss is not finite"]
    np.testing.assert_array_equal(
        heard.results[0].state.heights["lens.back"],
        heard.frames[-1].snapshot.state.heights["lens.back"],
    )


def test_shutdown_in_the_middle_of_a_run(session, as_run, start_runner, qtbot):
    runner, heard = start_runner(as_run(10_000, pause=0.005))
    runner.start(session, continue_run=False)
    qtbot.waitUntil(lambda: bool(heard.frames))
    runner.shutdown()
    runner.shutdown()
    assert runner.state == "idle"
    seen = len(heard.frames)
    qtbot.wait(100)
    assert heard.results == [] and len(heard.frames) == seen
