"""Progress in the status bar: how far, how fast, how long still; and no figure of the result."""

from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QLabel, QStatusBar

from ui.run.status import RunStatus


@pytest.fixture
def bar(qtbot):
    bar = QStatusBar()
    qtbot.addWidget(bar)
    return bar


def frame(session, snapshot):
    return SimpleNamespace(session=session, snapshot=snapshot)


@pytest.mark.parametrize(("name", "left"), [("auto", "at most 0:06 left"), ("paper", "0:06 left")])
def test_progress_while_a_run_goes_on(bar, session, make_scene, snapshots, name, left):
    status = RunStatus(bar, QLabel())
    task = SimpleNamespace(scene=make_scene({"run.method": name}), target=session.target)
    for iteration in (0, 20, 40):  # a tenth of a second each
        status.show_frame(frame(task, snapshots(iteration, 100)), running=True)
    assert status._iteration.text() == "iteration 40 of 100, 10/s"
    assert status._left.text() == left and status._progress.value() == 40
    shown = [label.text() for label in bar.findChildren(QLabel) if not label.isHidden()]
    assert not any("%" in text or "loss" in text for text in shown)
    status.settle()
    assert all(part.isHidden() for part in (status._left, status._iteration, status._progress))
