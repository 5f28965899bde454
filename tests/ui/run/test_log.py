"""The log: phases, notes and failures of runs, with times, bounded, in a dock of its own."""

import dataclasses

import pytest

from ui.widgets.log_view import LogView
from workbench.scene import Stage

pytestmark = pytest.mark.usefixtures("kernels")


def lines(log):
    return [line.split("  ", 1) for line in log.toPlainText().splitlines()]


def sentences(log):
    return [text for _, text in lines(log)]


def test_the_oldest_lines_are_dropped(qtbot):
    log = LogView()
    qtbot.addWidget(log)
    for number in range(2500):
        log.add(str(number))
    assert sentences(log) == [str(number) for number in range(500, 2500)]


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
        "Run begins: small, method auto",
        "Stage 1 of 2, iteration 0",
        "Trace: reference",
        "Stage 2 of 2, iteration 2",
        "Trace: fused kernels; box filter",
        "Run ended (all iterations are done) after iteration 3 of 3, 0:00: "
        "last loss 0.25, 92.0 % on the screen",
    ]
