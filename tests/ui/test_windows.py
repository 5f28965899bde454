"""Several windows: each with a design, a run and a recovery file of its own."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QMessageBox

from tests.ui.hands import move_screen
from ui.files import recovery as unsaved
from ui.windows import Windows
from workbench.files.session import read_session

SAVE, DISCARD, CANCEL = (
    QMessageBox.StandardButton.Save,
    QMessageBox.StandardButton.Discard,
    QMessageBox.StandardButton.Cancel,
)
BOTH = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "recovery"


@pytest.fixture
def windows(qapp, settings, folder):
    windows = Windows(settings, folder)
    stays = qapp.quitOnLastWindowClosed()
    qapp.setQuitOnLastWindowClosed(False)
    yield windows
    for window in list(windows._recoveries):
        window.discard_and_close()
    windows.wait()
    windows.deleteLater()
    qapp.setQuitOnLastWindowClosed(stays)


@pytest.fixture
def two(windows, qtbot):
    first = windows.open()
    with qtbot.waitActive(first):
        first.activateWindow()
    second = windows.open_beside()
    with qtbot.waitActive(second):
        second.activateWindow()
    return first, second


@pytest.fixture(autouse=True)
def asked(monkeypatch):
    """Questions so far, and the answers to come; each is used once."""
    questions, answers = [], []

    def question(window, title, text, *_):
        questions.append((window, text))
        return answers.pop(0) if answers else CANCEL

    monkeypatch.setattr(QMessageBox, "question", question)
    yield questions, answers
    assert not answers, "a question that was expected was not asked"


def open_windows(windows):
    return list(windows._recoveries)


def test_a_key_opens_another_window_with_a_document_of_its_own(windows, qtbot):
    first = windows.open()
    with qtbot.waitActive(first):
        first.activateWindow()
    qtbot.keyClick(first, Qt.Key.Key_W, BOTH)
    assert len(open_windows(windows)) == 2
    second = open_windows(windows)[1]
    assert second.isVisible() and second.pos() != first.pos()
    move_screen(second.document, 7)
    assert second.isWindowModified() and not first.isWindowModified()
    assert first.document.session.scene.receiver.z != 7


def test_quit_asks_for_each_window(windows, two, asked):
    first, second = two
    questions, answers = asked
    for window in two:
        move_screen(window.document, 7)
    answers += [DISCARD, CANCEL]
    second.commands["quit"].trigger()
    assert [window for window, _ in questions] == [first, second]
    assert open_windows(windows) == [second]
    answers += [DISCARD]
    second.commands["quit"].trigger()
    assert open_windows(windows) == []


@pytest.mark.usefixtures("kernels")
def test_quit_waits_for_a_run_whose_lens_shall_be_saved(
    windows, two, asked, tmp_path, monkeypatch, qtbot
):
    first, second = two
    _, answers = asked
    path = tmp_path / "mine.freeform"
    monkeypatch.setattr(first.dialogs, "to_save", lambda *_: path)
    windows._build_all()
    first.start()
    qtbot.waitUntil(lambda: first.loaded.control.runner.state == "running", timeout=60_000)
    answers += [SAVE]
    second.commands["quit"].trigger()
    assert open_windows(windows) == [first, second]
    qtbot.waitUntil(lambda: open_windows(windows) == [], timeout=60_000)
    assert read_session(path).result is not None


@pytest.mark.usefixtures("kernels")
def test_quit_is_cancelled_when_a_lens_cannot_be_saved(windows, two, asked, monkeypatch, qtbot):
    first, second = two
    _, answers = asked
    monkeypatch.setattr(first.dialogs, "to_save", lambda *_: None)
    windows._build_all()
    first.start()
    qtbot.waitUntil(lambda: first.loaded.control.runner.state == "running", timeout=60_000)
    answers += [SAVE]
    with qtbot.waitSignal(first.stayed, timeout=60_000):
        second.commands["quit"].trigger()
    first.discard_and_close()
    QApplication.processEvents()
    assert open_windows(windows) == [second]


def test_a_file_open_in_another_window_is_not_overwritten(windows, two, tmp_path, monkeypatch):
    first, second = two
    path = tmp_path / "mine.freeform"
    first.document.save(path)
    before = path.read_bytes()
    monkeypatch.setattr(second.dialogs, "to_save", lambda *_: path)
    assert not second.files.save_as()
    assert "another window" in second.messages.text
    assert path.read_bytes() == before


def test_a_signal_leaves_the_work_of_every_window(windows, two, folder):
    for z, window in zip((7, 8), two, strict=True):
        windows._recoveries[window].start()
        move_screen(window.document, z)
    windows.leave()
    assert not any(window.isVisible() for window in two)
    works = unsaved.find_left_behind(folder)
    assert {read_session(work.file).scene.receiver.z for work in works} == {7, 8}
    for work in works:
        work.put_back()
    for window in two:
        window.deleteLater()


def test_each_work_left_behind_comes_back_in_a_window_of_its_own(
    windows, two, folder, monkeypatch, qtbot
):
    for z, window in zip((7, 8), two, strict=True):
        windows._recoveries[window].start()
        move_screen(window.document, z)
    windows.leave()
    again = Windows(windows._settings, folder)
    monkeypatch.setattr(unsaved, "ask", lambda work, window: unsaved.RecoveryChoice.RECOVER)
    window = again.open()
    assert again.recover(window)
    found = open_windows(again)
    assert {each.document.session.scene.receiver.z for each in found} == {7, 8}
    assert all(each.document.dirty for each in found)
    assert unsaved.find_left_behind(folder) == []  # kept anew by the windows that are open
    for each in found:
        each.discard_and_close()
    for each in two:
        each.deleteLater()
    again.deleteLater()
