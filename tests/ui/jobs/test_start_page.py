"""The start page in the real window, by keyboard and mouse."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from tests.ui.hands import fill, move_screen
from ui.dialogs.start_page import StartPage
from ui.files.actions import Answer
from ui.panels.edits import Edit
from workbench.jobs import JOBS
from workbench.jobs.lenses import SunPlate, Torch
from workbench.scene.part import title_of


@pytest.fixture
def page(window, qtbot):
    window.commands["new"].trigger()
    found = window.findChild(StartPage)
    with qtbot.waitExposed(found):
        pass
    yield found
    window.start_page.close()


def row_of(page, path):
    return next(row for row in page.form.rows if row.path == path)


def choose(page, kind):
    page._jobs.setCurrentRow(JOBS.index(kind))


def begin(page, qtbot):
    with qtbot.waitSignal(page.begun):
        page.begin()


def test_every_job_is_listed_and_has_its_form(page):
    listed = [page._jobs.item(row).text() for row in range(page._jobs.count())]
    assert listed == [title_of(kind) for kind in JOBS]
    for kind in JOBS:
        choose(page, kind)
        assert type(page.form.job) is kind
        asked = {row.path.partition(".")[0] for row in page.form.rows}
        assert asked == {field.name for field in kind.fields() if field.tip}


def test_arrow_keys_and_enter_begin_a_job(window, page, qtbot):
    before = window.document.session
    qtbot.keyClick(page._jobs, Qt.Key.Key_Down)
    with qtbot.waitSignal(page.begun):
        qtbot.keyClick(page, Qt.Key.Key_Return)
    scene = window.document.session.scene
    assert scene.with_net(None) == Torch().scene().with_net(None)
    assert window.document.name == "Torch or phone" and window.document.path is None
    assert window.document.undo_stack.count() == 1
    window.commands["undo"].trigger()
    assert window.document.session is before


def test_an_impossible_answer_is_refused_in_its_row_and_holds_the_job(page, qtbot):
    row = row_of(page, "distance")
    editor = row.editors["distance"]
    fill(qtbot, editor, "2")
    assert row.refusal and editor.text() == "2"
    assert page.form.job == SunPlate()
    button = next(b for b in page.findChildren(QPushButton) if b.text() == "&Begin")
    assert not button.isEnabled()
    page.begin()
    assert page.isVisible()
    qtbot.keyClick(editor, Qt.Key.Key_Escape)
    assert not row.refusal and editor.text() == "500" and button.isEnabled()


def test_a_picture_that_cannot_be_read_is_stated_and_does_not_begin(window, page, qtbot):
    before = window.document.session
    page.form.choose_image(Path("/nowhere/none-256.png"))
    qtbot.waitUntil(lambda: "none-256.png" in page._estimate.text)
    assert not page._refusal.isVisible()
    page.begin()
    assert page.isVisible() and window.document.session is before
    assert page._refusal.isVisible() and "none-256.png" in page._refusal.text()
    chooser = row_of(page, "target.builtin").chooser
    chooser.setCurrentIndex(chooser.findData("ring"))
    chooser.activated.emit(chooser.currentIndex())
    assert not page._refusal.isVisible()


@pytest.mark.parametrize("answer", [Answer.CANCEL, Answer.DISCARD])
def test_a_job_replaces_unsaved_work_only_after_a_question(
    window, page, qtbot, monkeypatch, answer
):
    move_screen(window.document, 7)
    before, asked = window.document.session, []

    def ask(question):
        asked.append(question)
        return answer

    monkeypatch.setattr(window.files, "ask", ask)
    with qtbot.waitSignal(page.begun):
        page.begin()
    assert asked == ["Save the changes to small?"]
    kept = answer is Answer.CANCEL
    assert (window.document.session is before) is kept
    assert (window.start_page.page is page) is kept


def test_the_page_shows_the_picture_as_its_viewer_sees_it_and_says_from_where(page, qtbot):
    choose(page, Torch)
    qtbot.waitUntil(lambda: "Viewed from the side of the light" in page._estimate.text)
    qtbot.waitUntil(lambda: page._session is not None)
    session = page._session
    picture = page._estimate._wanted._picture
    column, row = np.argwhere(session.target.T > 0.5)[0]  # the leftmost pixel on the receiver
    mirrored = picture.width() - 1 - int(column)
    assert picture.pixelColor(mirrored, int(row)).value() > 180
    row_of(page, "target.viewed_from").chooser.activated.emit(2)
    qtbot.waitUntil(lambda: "Viewed from behind the screen" in page._estimate.text)
    assert page.form.job.target.viewed_from == "back"


def test_figures_of_other_answers_are_marked_until_new_ones_come(page, qtbot):
    choose(page, SunPlate)
    qtbot.waitUntil(lambda: "Largest slope" in page._estimate.text, timeout=90_000)
    estimate, (label, *_) = page._estimate, page._estimate._labels
    assert "estimating…" in estimate.text and label.isEnabled()
    row = row_of(page, "distance")
    row.edited.emit(Edit("distance", "distance", {"distance": 700.0}))
    assert "Outdated figures." in estimate.text
    assert not label.isEnabled()
    qtbot.waitUntil(lambda: "Outdated" not in estimate.text, timeout=90_000)
    assert all(label.isEnabled() for label in estimate._labels)
    row.edited.emit(Edit("distance", "distance", {"distance": -1.0}))
    assert page.form.refused and "Outdated figures." in estimate.text
