"""The start page in the real window, by keyboard and mouse: jobs, pictures and recent files."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QFileDialog, QPushButton

import resources
from resources import EXAMPLES
from tests.ui.hands import drop, fill, move_screen
from ui.dialogs.coach import CoachMarks
from ui.files.actions import Answer
from ui.panels.edits import Edit
from workbench.jobs import JOBS
from workbench.jobs.lenses import SunPlate, Torch
from workbench.scene.part import title_of

FLAME = resources.path("targets", "flame-256.png")


@pytest.fixture
def start(window):
    window.commands["new"].trigger()
    return window.start_page


@pytest.fixture
def page(start):
    """The page of the first job."""
    start.show_job(SunPlate)
    return start.job


def row_of(page, path):
    return next(row for row in page.form.rows if row.path == path)


def end_marks(window):
    marks = window.findChild(CoachMarks)
    if marks is not None:
        marks.end()


def test_every_job_has_a_tile_with_a_picture_and_a_form(start, qtbot):
    listed = [start.jobs.item(row).text() for row in range(start.jobs.count())]
    assert listed == [title_of(kind) for kind in JOBS]
    for row, kind in enumerate(JOBS):
        assert not start.jobs.item(row).data(Qt.ItemDataRole.UserRole)().isNull()
        start.jobs.setCurrentRow(row)
        qtbot.keyClick(start.jobs, Qt.Key.Key_Return)
        assert start.job.isVisible() and type(start.job.form.job) is kind
        asked = {row.path.partition(".")[0] for row in start.job.form.rows}
        assert asked == {field.name for field in kind.fields() if field.tip}
        qtbot.keyClick(start.job, Qt.Key.Key_Escape)
        assert start.jobs.isVisible()


def test_the_page_covers_the_design_and_escape_returns_to_it(window, start, qtbot):
    assert start.isVisible() and not window.panes.images.isVisible()
    assert not window.commands.toolbar.isVisible()
    assert window.commands["workspace_start"].isChecked()
    qtbot.keyClick(start, Qt.Key.Key_Escape)
    assert window.panes.images.isVisible() and window.commands.toolbar.isVisible()
    assert window.commands["workspace_task"].isChecked()
    window.commands["workspace_start"].trigger()
    window.commands["workspace_check"].trigger()
    assert window.panes.images.isVisible() and window.workspaces.name == "check"


def test_arrow_keys_and_enter_begin_a_job(window, start, qtbot):
    before = window.document.session
    start.jobs.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(start.jobs, Qt.Key.Key_Right)
    qtbot.keyClick(start.jobs, Qt.Key.Key_Return)
    with qtbot.waitSignal(start.begun):
        qtbot.keyClick(start.job, Qt.Key.Key_Return)
    end_marks(window)
    assert window.workspaces.name == "task" and window.panes.images.isVisible()
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
    qtbot.waitUntil(lambda: "none-256.png" in page.estimate.text)
    assert not page._refusal.isVisible()
    page.begin()
    assert page.isVisible() and window.document.session is before
    assert page._refusal.isVisible() and "none-256.png" in page._refusal.text()
    chooser = row_of(page, "target.builtin").chooser
    chooser.setCurrentIndex(chooser.findData("ring"))
    chooser.activated.emit(chooser.currentIndex())
    assert not page._refusal.isVisible()


@pytest.mark.parametrize("answer", [Answer.Cancel, Answer.Discard])
def test_a_job_replaces_unsaved_work_only_after_a_question(
    window, page, qtbot, monkeypatch, answer
):
    move_screen(window.document, 7)
    before, asked, start = window.document.session, [], window.start_page

    def ask(question):
        asked.append(question)
        return answer

    monkeypatch.setattr(window.files, "ask", ask)
    with qtbot.waitSignal(page.begun):
        page.begin()
    assert asked == ["Save the changes to small?"]
    kept = answer == Answer.Cancel
    end_marks(window)
    assert (window.document.session is before) is kept
    assert start.isVisible() is kept and page.isVisible() is kept


def test_the_page_shows_the_picture_as_its_viewer_sees_it_and_says_from_where(start, qtbot):
    start.show_job(Torch)
    page = start.job
    qtbot.waitUntil(lambda: "Viewed from the side of the light" in page.estimate.text)
    qtbot.waitUntil(lambda: page._session is not None)
    session = page._session
    picture = page.estimate._wanted._picture
    column, row = np.argwhere(session.target.T > 0.5)[0]  # the leftmost pixel on the receiver
    mirrored = picture.width() - 1 - int(column)
    assert picture.pixelColor(mirrored, int(row)).value() > 180
    row_of(page, "target.viewed_from").chooser.activated.emit(2)
    qtbot.waitUntil(lambda: "Viewed from behind the screen" in page.estimate.text)
    assert page.form.job.target.viewed_from == "back"


def test_figures_of_other_answers_are_marked_until_new_ones_come(page, qtbot):
    qtbot.waitUntil(lambda: "Largest slope" in page.estimate.text, timeout=90_000)
    estimate, label = page.estimate, page.estimate._figures
    assert "estimating…" in estimate.text and label.isEnabled()
    row = row_of(page, "distance")
    row.edited.emit(Edit("distance", "distance", {"distance": 700.0}))
    assert "Outdated figures." in estimate.text
    assert not label.isEnabled()
    qtbot.waitUntil(lambda: "Outdated" not in estimate.text, timeout=90_000)
    assert label.isEnabled()
    row.edited.emit(Edit("distance", "distance", {"distance": -1.0}))
    assert page.form.refused and "Outdated figures." in estimate.text


@pytest.mark.parametrize("way", ["drop", "paste", "choose"])
def test_a_picture_begins_the_first_job_with_one_key(window, start, qtbot, monkeypatch, way):
    if way == "drop":
        drop(window, FLAME)
    elif way == "paste":
        QGuiApplication.clipboard().setImage(QImage(str(FLAME)))
        window.commands["paste_picture"].trigger()
    else:
        chosen = lambda *_: (str(FLAME), "")  # noqa: E731
        monkeypatch.setattr(QFileDialog, "getOpenFileName", chosen)
        qtbot.mouseClick(start._well, Qt.MouseButton.LeftButton)
    job = start.job.form.job
    assert isinstance(job, SunPlate) and start.job._begin.hasFocus()
    assert way == "paste" or job.target.image == str(FLAME)
    with qtbot.waitSignal(start.begun):
        qtbot.keyClick(start.job._begin, Qt.Key.Key_Return)
    end_marks(window)
    assert window.document.session.scene.image == job.target.image


def test_a_picture_dropped_on_a_job_is_for_that_job_if_it_has_one(window, start, qtbot):
    start.show_job(Torch)
    drop(window, FLAME)
    assert isinstance(start.job.form.job, Torch)
    assert start.job.form.job.target.image == str(FLAME)
    start.show_job(JOBS[-1])
    drop(window, FLAME)
    assert isinstance(start.job.form.job, SunPlate)


def test_answers_of_a_job_that_began_are_there_the_next_time(window, page, qtbot):
    fill(qtbot, row_of(page, "distance").editors["distance"], "700")
    page.use_picture(FLAME)
    with qtbot.waitSignal(page.begun):
        page.begin()
    end_marks(window)
    window.commands["new"].trigger()
    window.start_page.show_job(SunPlate)
    assert page.form.job.distance == 700
    assert page.form.job.target == SunPlate().target
    window._settings.setValue("jobs/SunPlate", "no answers")
    window.start_page.show_job(SunPlate)
    assert page.form.job == SunPlate()


def test_recent_files_are_opened_and_missing_ones_are_stated(window, start, qtbot, tmp_path):
    here, gone = tmp_path / "here.freeform", tmp_path / "gone.freeform"
    window.document.save(here)
    for path in (here, gone):
        window._recent.add(path)
    start.begin_anew()
    assert [start.recent.item(row).text() for row in (0, 1)] == ["gone", "here"]
    start.recent.chosen.emit(0)
    assert "gone.freeform" in start.message.text() and start.message.isVisible()
    assert start.recent.count() == 1
    start.recent.chosen.emit(0)
    assert window.document.path == here and not start.isVisible()


def test_every_example_has_a_picture_of_its_target(start):
    tiles = [start.examples.item(row) for row in range(start.examples.count())]
    assert [tile.text() for tile in tiles] == [example.title for example in EXAMPLES]
    assert len({tile.text() for tile in tiles}) == len(tiles)
    for tile, example in zip(tiles, EXAMPLES, strict=True):
        picture = tile.data(Qt.ItemDataRole.UserRole)().scaled(24, 24)
        grey = {picture.pixelColor(x, y).lightness() for x in range(24) for y in range(24)}
        assert min(grey) < 30 and max(grey) > 200, tile.text()
        assert example.look in tile.toolTip() and example.group in tile.toolTip()


def test_typing_a_name_and_enter_open_an_example(window, qtbot):
    window.commands["new"].trigger()
    examples = window.start_page.examples
    examples.setFocus()
    qtbot.keyClicks(examples, "lett")
    qtbot.keyClick(examples, Qt.Key.Key_Return)
    assert window.document.name == "letter" and not window.start_page.isVisible()


def test_the_current_tile_is_scrolled_to(start, qtbot):
    start.window().resize(960, 640)
    start.examples.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(start.examples, Qt.Key.Key_End)
    here = start.examples.visualItemRect(start.examples.currentItem())
    assert start.examples.currentRow() == len(EXAMPLES) - 1
    assert start.examples.visibleRegion().contains(here.center())


def test_a_window_that_comes_to_the_front_scrolls_nothing_under_the_mouse(start):
    start.window().resize(960, 640)
    start.jobs.setCurrentRow(len(JOBS) - 1)
    start.jobs.setFocus(Qt.FocusReason.ActiveWindowFocusReason)
    here = start.jobs.visualItemRect(start.jobs.currentItem())
    assert not start.jobs.visibleRegion().contains(here)
    start.jobs.clearFocus()
    start.jobs.setFocus(Qt.FocusReason.TabFocusReason)
    assert start.jobs.visibleRegion().contains(here)


def test_files_that_are_opened_there_are_used_at_once(window, start):
    window.files.open(FLAME)
    assert start.job.isVisible() and start.job.form.job.target.image == str(FLAME)
    light = resources.path("lights", "led.ies")
    drop(window, light)
    assert not start.isVisible() and window.document.session.scene.source.file == str(light)
