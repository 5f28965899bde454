"""Unsaved work outlives a program that is not closed."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox, QPushButton

from tests.ui.hands import move_screen
from ui.document.document import Document, OnDisk
from ui.files import recovery as unsaved
from ui.files.recovery import Recovery, RecoveryChoice
from workbench.files.session import read_session, write_session

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def keeping(document, tmp_path):
    recoveries = []

    def make():
        recovery = Recovery(document, tmp_path / "recovery")
        recoveries.append(recovery)
        recovery.start()
        return recovery

    yield make
    for recovery in recoveries:
        recovery.close()


def kept(recovery):
    return sorted(file.name for file in recovery.folder.glob("*.freeform"))


def crash(recovery):
    """Let go of the lock, as the end of the process does."""
    recovery._timer.stop()
    recovery._lock.unlock()
    recovery._closed = True


def test_only_what_is_not_saved_is_kept(document, keeping, tmp_path):
    recovery = keeping()
    assert not recovery.keep_now() and not kept(recovery)
    move_screen(document, 7)
    assert recovery.keep_now()
    assert read_session(recovery._file).scene.receiver.z == 7
    move_screen(document, 8)
    recovery.keep_now()
    assert read_session(recovery._file).scene.receiver.z == 8
    document.save(tmp_path / "mine.freeform")
    recovery.keep_now()
    assert [file.suffix for file in recovery.folder.iterdir()] == [".lock"]


def test_work_of_an_open_window_is_not_offered(document, keeping):
    recovery = keeping()
    move_screen(document, 7)
    recovery.keep_now()
    assert unsaved.find_left_behind(recovery.folder) == []
    crash(recovery)
    (work,) = unsaved.find_left_behind(recovery.folder)
    assert unsaved.find_left_behind(recovery.folder) == []  # nor to two at once
    work.put_back()
    (work,) = unsaved.find_left_behind(recovery.folder)
    work.remove()
    assert list(recovery.folder.iterdir()) == []


def test_recovered_work_has_its_name_and_file_and_is_unsaved(document, keeping, tmp_path):
    path = tmp_path / "mine.freeform"
    document.save(path)
    recovery = keeping()
    move_screen(document, 7)
    recovery.keep_now()
    crash(recovery)
    (work,) = unsaved.find_left_behind(recovery.folder)
    about = work.about
    assert (about.name, about.path, about.ended) == ("mine", path, False)
    other = Document(document.session, "other", document)
    other.recover(read_session(work.file), about.name, about.path, about.fingerprint)
    assert (other.name, other.path, other.dirty) == ("mine", path, True)
    assert other.session.scene.receiver.z == 7
    assert other.on_disk(path) is OnDisk.KNOWN
    other.save(path)
    assert not other.dirty
    work.remove()


def test_a_file_changed_after_a_crash_is_asked_about(document, keeping, tmp_path):
    path = tmp_path / "mine.freeform"
    document.save(path)
    recovery = keeping()
    move_screen(document, 7)
    recovery.keep_now()
    crash(recovery)
    write_session(document.session, path)
    (work,) = unsaved.find_left_behind(recovery.folder)
    about = work.about
    document.recover(read_session(work.file), about.name, about.path, about.fingerprint)
    assert document.on_disk(path) is OnDisk.CHANGED
    work.remove()


def test_the_lens_of_a_run_is_kept_before_it_ends(display, window, make_scene, tmp_path, qtbot):
    window.build()
    scene = make_scene({"run.method": "paper", "run.iterations": 100_000})
    window.document.edit(scene, "run", "")
    recovery = Recovery(window.document, tmp_path / "recovery", window)
    recovery.start()
    recovery.follow(window.loaded.control)
    window.start()
    qtbot.waitUntil(lambda: recovery._frame is not None, timeout=60_000)
    frame = recovery._frame
    assert recovery.keep_now()
    found = read_session(recovery._file).result
    assert found.iterations >= frame.snapshot.iteration
    np.testing.assert_array_equal(found.losses, recovery._kept.result.losses)
    window.loaded.control.runner.stop()
    qtbot.waitUntil(lambda: not window.loaded.control.busy, timeout=60_000)
    assert recovery._frame is None
    recovery._background.finish()
    ended = read_session(recovery._file).result
    np.testing.assert_array_equal(
        ended.state.heights["lens.back"], window.document.session.result.state.heights["lens.back"]
    )
    recovery.close()


@pytest.mark.parametrize("choice", RecoveryChoice)
def test_the_question_has_three_answers(window, document, keeping, qtbot, choice):
    recovery, received = keeping(), []
    move_screen(document, 7)
    recovery.keep_now()
    crash(recovery)
    works = unsaved.find_left_behind(recovery.folder)

    def answer():
        box = next(w for w in QApplication.topLevelWidgets() if isinstance(w, QMessageBox))
        received.append(box.text())
        buttons = {b.text().replace("&", ""): b for b in box.findChildren(QPushButton)}
        assert list(buttons) == ["Recover", "Discard", "Ask later"]
        button = buttons["Ask later" if choice is RecoveryChoice.LATER else choice.name.title()]
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)

    QTimer.singleShot(200, answer)
    opened = []
    unsaved.offer_left_behind(works, lambda work: not opened.append(work), window)
    assert "small" in received[0] and "ended unexpectedly" in received[0]
    assert len(opened) == (choice is RecoveryChoice.RECOVER)
    assert len(kept(recovery)) == (choice is RecoveryChoice.LATER)


BEGIN = (
    "import sys; from PySide6.QtCore import QTimer; import ui.app, ui.files.recovery as r\n"
    "start = r.Recovery.start\n"
    "def started(self):\n"
    "    start(self)\n"
    "    scene = self._document.session.scene\n"
    "    self._document.edit(scene.with_receiver(scene.receiver.moved_to(7.5)), 'edit', '')\n"
    "    print(self.keep_now(), flush=True)\n"
    "r.Recovery.start = started\n"
    "sys.exit(ui.app.main([]))"
)


def first_line(script, number, folder):
    """What a program reported before it got a signal."""
    process = subprocess.Popen(
        [sys.executable, "-c", script],
        env={**os.environ, "XDG_CONFIG_HOME": str(folder)},
        stdout=subprocess.PIPE,
        text=True,
    )
    line = process.stdout.readline()
    time.sleep(0.2)
    process.send_signal(number)
    process.communicate(timeout=120)
    return line


needs_display = pytest.mark.skipif(not os.environ.get("DISPLAY"), reason="needs a display")


@needs_display
def test_work_is_found_after_a_kill(tmp_path):
    assert first_line(BEGIN, signal.SIGKILL, tmp_path) == "True\n"
    (folder,) = tmp_path.rglob("recovery")
    (work,) = unsaved.find_left_behind(folder)
    assert (work.about.name, work.about.path) == ("tophat", None)
    session = read_session(work.file)
    assert session.scene.receiver.z == 7.5 and session.view["layout"]
    work.remove()
