"""Saving asks before it takes the place of what another program has written."""

import os
import shutil

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox, QPushButton

from tests.ui.hands import move_screen
from ui.document.document import Document, OnDisk
from ui.files import actions
from ui.files.actions import ChangedFileChoice
from workbench.files.session import read_session, write_session


@pytest.fixture
def path(window, tmp_path):
    """The file of a design that has changes since it was saved."""
    path = tmp_path / "mine.freeform"
    window.document.save(path)
    move_screen(window.document, 7)
    return path


@pytest.fixture
def answers(monkeypatch):
    """Answers to come; each is used once."""
    coming = []
    name = "ask_about_changed_file"
    monkeypatch.setattr(actions, name, lambda path, found, window: coming.pop(0))
    yield coming
    assert not coming, "a question that was expected was not asked"


def write_elsewhere(session, path, z):
    """What another program does: the same design with its screen elsewhere."""
    other = Document(session, "other")
    move_screen(other, z)
    write_session(other.session, path)
    other.deleteLater()


@pytest.mark.parametrize(
    ("choice", "saved", "z"),
    [(ChangedFileChoice.OVERWRITE, True, 7), (ChangedFileChoice.CANCEL, False, 9)],
)
def test_save_asks_when_the_file_changed_on_disk(window, session, path, answers, choice, saved, z):
    times = path.stat()
    write_elsewhere(session, path, 9)
    os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
    answers.append(choice)
    assert window.files.save() is saved
    assert read_session(path).scene.receiver.z == z
    assert window.document.dirty is not saved


def test_reload_shows_the_file_and_undo_brings_the_design_back(window, session, path, answers):
    write_elsewhere(session, path, 9)
    answers.append(ChangedFileChoice.RELOAD)
    assert not window.files.save()
    assert window.document.session.scene.receiver.z == 9 and not window.document.dirty
    window.document.undo_stack.undo()
    assert window.document.session.scene.receiver.z == 7
    assert window.files.save()  # what the file holds has been seen
    assert read_session(path).scene.receiver.z == 7


def test_save_asks_before_a_deleted_file_is_written_again(window, path, answers):
    path.unlink()
    answers.append(ChangedFileChoice.CANCEL)
    assert not window.files.save()
    assert not path.exists()
    answers.append(ChangedFileChoice.OVERWRITE)
    assert window.files.save()
    assert read_session(path).scene.receiver.z == 7


@pytest.mark.usefixtures("answers")
def test_own_saves_and_equal_content_need_no_question(window, path):
    assert window.files.save()
    move_screen(window.document, 8)
    assert window.files.save()
    shutil.copy(path, path.with_name("copy"))
    path.with_name("copy").rename(path)  # the same content, another file
    move_screen(window.document, 9)
    assert window.files.save()
    assert read_session(path).scene.receiver.z == 9


def test_a_file_that_cannot_be_read_is_not_overwritten(window, path):
    path.unlink()
    path.mkdir()
    assert not window.files.save()
    assert "is a folder" in window.messages.text
    assert window.messages.buttons[0].text() == "Save as…"


def test_closing_asks_too_when_the_file_changed_on_disk(
    window, session, path, answers, monkeypatch
):
    write_elsewhere(session, path, 9)
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Save)
    answers.append(ChangedFileChoice.CANCEL)
    assert not window.close()
    assert window.isVisible() and read_session(path).scene.receiver.z == 9


def press(word, seen):
    """Press the button with this word in the box that is about to open."""

    def answer():
        box = next(w for w in QApplication.topLevelWidgets() if isinstance(w, QMessageBox))
        buttons = {b.text().replace("&", ""): b for b in box.findChildren(QPushButton)}
        seen.append((box.text(), set(buttons)))
        assert box.textFormat() is Qt.TextFormat.PlainText  # names may look like markup
        buttons[word].click()

    QTimer.singleShot(200, answer)


def test_the_question_about_a_changed_file(window, path):
    for word, choice in (
        ("Overwrite", ChangedFileChoice.OVERWRITE),
        ("Save as…", ChangedFileChoice.SAVE_AS),
        ("Reload", ChangedFileChoice.RELOAD),
        ("Cancel", ChangedFileChoice.CANCEL),
    ):
        seen = []
        press(word, seen)
        assert actions.ask_about_changed_file(path, OnDisk.CHANGED, window) is choice
        ((text, buttons),) = seen
        assert "mine.freeform" in text
        assert buttons == {"Overwrite", "Save as…", "Reload", "Cancel"}
