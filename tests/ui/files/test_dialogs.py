"""Dialogs for files begin where a person has files of this kind."""

import pytest
from PySide6.QtWidgets import QFileDialog, QWidget

from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.widgets.messages import Messages


@pytest.fixture
def asked(monkeypatch):
    """Folders that dialogs began in; each is answered with what was put into the list."""
    begun, answers = [], []

    def choose(window, title, folder, filters):
        begun.append(folder)
        return str(answers.pop(0)) if answers else "", ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", choose)
    return begun, answers


@pytest.fixture
def window_of_dialogs(qtbot):
    widget = QWidget()
    qtbot.addWidget(widget)
    return widget


@pytest.fixture
def make(settings, window_of_dialogs):
    return lambda document: FileDialogs(document, Messages(), settings, window_of_dialogs)


@pytest.fixture
def folders(tmp_path):
    made = [tmp_path / name for name in ("designs", "pictures", "elsewhere")]
    for folder in made:
        folder.mkdir()
    return made


def test_each_kind_of_file_has_a_folder_of_its_own(make, document, asked, folders):
    designs, pictures, elsewhere = folders
    begun, answers = asked
    document.save(designs / "mine.freeform")
    dialogs = make(document)
    answers.append(pictures / "flame.png")
    assert dialogs.to_open("image", "Open", "") == pictures / "flame.png"
    dialogs.to_open("image", "Open", "")
    dialogs.to_open("design", "Open", "")
    assert begun == [str(designs), str(pictures), str(designs)]
    document.save(elsewhere / "mine.freeform")  # where the person works from now on
    dialogs.to_open("image", "Open", "")
    assert begun[-1] == str(elsewhere)


def test_a_folder_is_remembered_for_the_next_window(make, document, session, asked, folders):
    _, pictures, _ = folders
    begun, answers = asked
    answers.append(pictures / "flame.png")
    make(document).to_open("image", "Open", "")
    other = Document(session, "other", document)
    make(other).to_open("image", "Open", "")
    assert begun[1] == str(pictures)
    make(other).to_open("design", "Open", "")
    assert begun[2] != str(pictures)
    pictures.rmdir()
    make(other).to_open("image", "Open", "")
    assert begun[3] == begun[2]  # a folder that is gone is none to begin in


def test_a_dialog_that_is_answered_leaves_nothing_behind(
    make, document, window_of_dialogs, monkeypatch, qtbot
):
    monkeypatch.setattr(QFileDialog, "exec", lambda dialog: False)
    dialogs = make(document)
    for _ in range(3):
        assert (
            dialogs.to_save("design", "Save", "mine", {"Design (*.freeform)": ".freeform"}) is None
        )
    qtbot.waitUntil(lambda: not window_of_dialogs.findChildren(QFileDialog))
