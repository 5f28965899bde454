"""The shelf lists titled work: progress, Cancel, outcome."""

import threading

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QDesktopServices

from ui.background import Background
from ui.widgets.shelf import Shelf
from workbench.errors import Refused
from workbench.messages import Message


@pytest.fixture
def shelf(show, qtbot):
    return show(Shelf(), 300, 30)


@pytest.fixture
def background(shelf):
    background = Background("export", shelf)
    shelf.follow(shelf)
    yield background
    background.close()


def test_work_with_a_title_is_listed_until_its_outcome(
    shelf, background, qtbot, tmp_path, monkeypatch
):
    go_on, opened, written = threading.Event(), [], []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    shelf.written.connect(lambda outcome, path: written.append((outcome, path)))
    path = tmp_path / "lens.stl"
    path.touch()

    def work(task):
        task.report(0.4)
        go_on.wait(30)
        task.outcome, task.path = "written", path

    background.begin(work, title="Export lens.stl")
    (entry,) = shelf.entries
    qtbot.waitUntil(lambda: entry.part.text() == "40 %" and entry.bar.value() == 40)
    qtbot.waitUntil(lambda: shelf.button.text() == "Tasks (1)")
    qtbot.mouseClick(shelf.button, Qt.MouseButton.LeftButton)
    assert shelf.panel.isVisible() and entry.folder.isHidden()
    go_on.set()
    qtbot.waitUntil(lambda: entry.outcome.text() == "written")
    assert written == [("written", path)] and entry.cancel.isHidden() and entry.bar.isHidden()
    qtbot.mouseClick(entry.open, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(entry.folder, Qt.MouseButton.LeftButton)
    assert opened == [str(path), str(tmp_path)]
    qtbot.waitUntil(lambda: shelf.button.text() == "Tasks")
    shelf.panel.hide()


def test_cancel_stops_the_work_and_an_error_is_shown(shelf, background, qtbot):
    def work(task):
        while not task.stopped:
            threading.Event().wait(0.01)
        raise Refused("target.image", Message("not a picture"))

    background.begin(work, title="Export")
    (entry,) = shelf.entries
    entry.cancel.click()
    assert not entry.cancel.isEnabled()
    qtbot.waitUntil(lambda: "not a picture" in entry.outcome.text())


def test_work_without_title_or_outcome_leaves_nothing(shelf, background, qtbot):
    background.begin(lambda task: None)
    background.finish()
    assert shelf.entries == []
    with qtbot.waitSignal(background.done):
        background.begin(lambda task: None, title="Photo")
        assert len(shelf.entries) == 1
    assert shelf.entries == []
    background.begin(lambda task: threading.Event().wait(0.05), title="Photo")
    background.cancel()
    assert shelf.entries == []
