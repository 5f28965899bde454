"""Runs kept side by side: named, compared on the loss plot, gone back to, deleted; and checked."""

import time
from dataclasses import replace
from threading import Event
from types import SimpleNamespace

import pytest
from matplotlib.backend_bases import MouseEvent
from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QApplication, QLineEdit, QToolTip

from tests.ui.hands import move_screen
from ui.check.checking import CheckedLens
from workbench.design.loss import relative_error
from workbench.geometry.faces import FaceArrays
from workbench.scene import RectangleRegion, Stage

pytestmark = pytest.mark.usefixtures("kernels")


def found(error):
    lens_error = SimpleNamespace(
        relative_l2_corrected=error,
        relative_l2_corrected_interval=(0.9 * error, 1.1 * error),
    )
    return SimpleNamespace(
        loss=0.2,
        loss_corrected=0.1,
        relative_l2=2 * error,
        verified=lens_error,
        contradiction=None,
        efficiency=0.9,
        rays=1000,
        noise=0.001,
    )


@pytest.fixture
def checks(monkeypatch):
    """Checks that say what they are told at once; notes heights, rays and threads."""
    seen = SimpleNamespace(asked=[], error=0.0125)

    def validating(scene, target, heights, rays, threads, accuracy):
        seen.asked.append((heights, rays, threads))
        yield 1.0
        return found(seen.error)

    monkeypatch.setattr("workbench.analysis.validation.validating", validating)
    return seen


@pytest.fixture
def window(display, window, checks, as_seen_run):
    window.build()
    window.loaded.control.runner._generate = as_seen_run(window.loaded.control.runner, 6)
    window.workspace.docks["runs"].show()
    window.workspace.docks["runs"].raise_()
    return window


@pytest.fixture
def run(window, qtbot):
    def do(command="start"):
        with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
            window.commands[command].trigger()
        qtbot.waitUntil(lambda: not window.loaded.runs.check._background.busy)

    return do


@pytest.fixture
def two_runs(window, run):
    run()
    move_screen(window.document, 7)
    run()
    return window


def table(window):
    return window.loaded.runs.table.table


def names(window):
    return [table(window).item(row, 0).text() for row in range(table(window).rowCount())]


def texts(window, row):
    lines = table(window)
    return [lines.item(row, column).text() for column in range(lines.columnCount())]


def verified(window):
    """What stands in the column of verified errors."""
    return [texts(window, row)[3] for row in range(table(window).rowCount())]


def test_all_lines_are_as_high_whatever_stands_in_them(two_runs):
    lines = table(two_runs)
    with QSignalBlocker(lines):
        lines.item(0, lines.columnCount() - 1).setText("long words " * 20)
    heights = [lines.rowHeight(row) for row in range(lines.rowCount())]
    assert heights[0] == heights[1] > lines.iconSize().height()


def test_each_run_is_kept_in_one_step_with_its_result(window, run):
    assert not table(window).isVisible()
    run()
    assert names(window) == ["Run 1: auto, 12 × 10"]
    assert window.document.undo_stack.count() == 1
    run("continue")
    assert names(window) == ["Run 1: auto, 12 × 10", "Run 2: auto, 12 × 10"]
    session = window.document.session
    error = f"{100 * relative_error(session.result.state, session.target):.1f} %"
    figures = ["Top hat", error, "1.25 %", "92.0 %", "0:01", "12", "12 × 10", "auto"]
    assert texts(window, 1)[1:] == [*figures, "0.1429", "all iterations are done"]
    assert not table(window).item(1, 0).icon().isNull()
    window.commands["undo"].trigger()
    window.commands["undo"].trigger()
    assert names(window) == [] and window.document.session.result is None


def test_what_is_done_can_still_be_read_when_a_run_begins(window, run):
    window.messages.done("lens.html is written.")
    run()
    assert window.messages.text == "lens.html is written." and window.messages.isVisible()
    window.messages.note("There is no lens yet.")
    run()
    assert window.messages.text == ""


def test_a_file_that_is_being_written_can_still_be_cancelled_when_a_run_begins(window, run):
    window.messages.note("lens.pdf is being written…", ("Cancel", print), lasts=True)
    run()
    assert window.messages.text == "lens.pdf is being written…"
    assert window.messages.buttons[0].isVisible()


def test_runs_stay_while_the_design_changes(two_runs):
    assert names(two_runs) == ["Run 1: auto, 12 × 10", "Run 2: auto, 12 × 10"]
    bold = [table(two_runs).item(row, 0).font().bold() for row in (0, 1)]
    assert bold == [False, True]


def test_a_check_mark_draws_the_loss_of_another_run(two_runs, qtbot):
    loss = two_runs.loaded.views.loss
    for row in (0, 1):
        table(two_runs).item(row, 0).setCheckState(Qt.CheckState.Checked)
    # The lens on show is drawn anyway.
    assert [course.name for course in loss._runs] == ["Run 1: auto, 12 × 10"]
    assert loss._runs[0].losses.size == loss._runs[0].times.size == 6
    table(two_runs).item(0, 0).setCheckState(Qt.CheckState.Unchecked)
    assert loss._runs == ()


def test_the_run_before_is_drawn_beside_the_one_that_goes_on(window, run, as_run, qtbot):
    run()
    table(window).item(0, 0).setCheckState(Qt.CheckState.Checked)
    assert window.loaded.views.loss._runs == ()
    window.loaded.control.runner._generate = as_run(100_000, pause=0.01)
    window.commands["start"].trigger()
    assert [course.name for course in window.loaded.views.loss._runs] == ["Run 1: auto, 12 × 10"]
    assert not window.loaded.runs.table._restore.isEnabled()
    window.commands["stop"].trigger()
    qtbot.waitUntil(lambda: not window.loaded.control.busy, timeout=60_000)


def test_a_run_is_given_another_name_by_keyboard(two_runs, qtbot):
    lines = table(two_runs)
    lines.setCurrentCell(0, 0)
    lines.setFocus()
    qtbot.keyClick(lines, Qt.Key.Key_F2)
    qtbot.waitUntil(lambda: bool(lines.viewport().findChildren(QLineEdit)))
    editor = lines.viewport().findChildren(QLineEdit)[0]
    editor.selectAll()
    qtbot.keyClicks(editor, "near screen")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: two_runs.document.session.runs[0].name == "near screen")
    assert two_runs.document.undo_stack.undoText() == "rename run"
    two_runs.commands["undo"].trigger()
    assert names(two_runs)[0] == "Run 1: auto, 12 × 10"


def test_a_name_that_becomes_too_long_is_cut_and_said_while_it_is_typed(two_runs, qtbot):
    lines = table(two_runs)
    lines.setCurrentCell(0, 0)
    lines.setFocus()
    qtbot.keyClick(lines, Qt.Key.Key_F2)
    qtbot.waitUntil(lambda: bool(lines.viewport().findChildren(QLineEdit)))
    editor = lines.viewport().findChildren(QLineEdit)[0]
    editor.selectAll()
    QApplication.clipboard().setText("a" * 99)
    qtbot.keyClick(editor, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert not QToolTip.isVisible()
    qtbot.keyClicks(editor, "bc")
    assert editor.text() == "a" * 99 + "b"
    assert QToolTip.text() == "A name has at most 100 characters"
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: two_runs.document.session.runs[0].name == "a" * 99 + "b")


def test_a_long_name_leaves_room_for_figures_and_is_whole_in_its_tip(two_runs):
    name = (10 * "long name ").strip()
    table(two_runs).item(0, 0).setText(name)
    assert table(two_runs).columnWidth(0) < 40 * table(two_runs).fontMetrics().averageCharWidth()
    assert table(two_runs).item(0, 0).toolTip() == name


def test_an_empty_name_is_refused(two_runs):
    table(two_runs).item(0, 0).setText("  ")
    assert "1 to 100" in two_runs.messages.text
    assert names(two_runs)[0] == "Run 1: auto, 12 × 10"


def test_going_back_to_a_run(two_runs, qtbot):
    document = two_runs.document
    first = document.session.runs[0]
    table(two_runs).selectRow(0)
    qtbot.mouseClick(two_runs.loaded.runs.table._restore, Qt.MouseButton.LeftButton)
    assert document.session.scene is first.scene and document.session.scene.receiver.z == 5.0
    assert document.session.result is first.result
    assert document.undo_stack.undoText() == "return to Run 1: auto, 12 × 10"
    assert table(two_runs).item(0, 0).font().bold()
    two_runs.commands["undo"].trigger()
    assert document.session.scene.receiver.z == 7.0


def test_deleting_runs_can_be_undone(two_runs, qtbot):
    lines = table(two_runs)
    lines.selectAll()
    two_runs.activateWindow()
    lines.setFocus()
    qtbot.waitUntil(lines.hasFocus)
    qtbot.keyClick(lines, Qt.Key.Key_Delete)
    assert names(two_runs) == [] and not lines.isVisible()
    two_runs.commands["undo"].trigger()
    assert len(names(two_runs)) == 2
    lines.selectRow(1)
    two_runs.commands["delete_run"].trigger()
    assert names(two_runs) == ["Run 1: auto, 12 × 10"]
    assert two_runs.document.session.result is not None


def test_two_chosen_runs_are_shown_beside_each_other(two_runs, qtbot):
    runs, lines = two_runs.loaded.runs, table(two_runs)
    compare = runs.table._compare
    lines.selectRow(0)
    assert not compare.isEnabled()
    two_runs.commands["compare_runs"].trigger()
    assert "Choose two runs" in two_runs.messages.text and runs.comparison is None
    lines.selectAll()
    qtbot.mouseClick(compare, Qt.MouseButton.LeftButton)
    shown = runs.comparison
    assert shown.isVisible() and shown.pair == two_runs.document.session.runs
    cells = {shown.table.item(row, 0).text(): row for row in range(shown.table.rowCount())}
    differ = cells["Fields of the scenes that differ"]
    assert list(cells)[differ + 1 :] == ["Screen · At z"]
    at_z = [shown.table.item(cells["Screen · At z"], column).text() for column in (1, 2)]
    assert at_z == ["5 cm", "7 cm"]
    session = two_runs.document.session
    runs.note_check(CheckedLens(session, session.heights), found(0.03))
    errors = [shown.table.item(cells["Verified"], column).text() for column in (1, 2)]
    assert errors == ["1.25 %", "3.00 %"]


def test_the_light_under_the_pointer_is_told_of_both_runs(two_runs, qtbot):
    table(two_runs).selectAll()
    two_runs.commands["compare_runs"].trigger()
    shown = two_runs.loaded.runs.comparison
    axes = shown._figure.axes[0]
    place = axes.transData.transform((0.5, 0.25))
    MouseEvent("motion_notify_event", shown._canvas, *place)._process()
    assert shown.readout == "0.25 → 0.25 / cm² at x = 0.5 cm, y = 0.25 cm"
    loss = shown._figure.axes[3]
    place = loss.transAxes.transform((0.5, 0.5))
    MouseEvent("motion_notify_event", shown._canvas, *place)._process()
    assert shown.readout == "Point at an image to read its light"


def test_commands_without_a_choice_say_what_is_missing(two_runs):
    table(two_runs).clearSelection()
    two_runs.commands["restore_run"].trigger()
    assert "Choose one run" in two_runs.messages.text


def test_kept_runs_are_saved_with_the_file(two_runs, tmp_path):
    path = tmp_path / "two.freeform"
    two_runs.document.save(path)
    two_runs.document.open(path)
    assert names(two_runs) == ["Run 1: auto, 12 × 10", "Run 2: auto, 12 × 10"]
    assert [table(two_runs).item(row, 0).font().bold() for row in (0, 1)] == [False, True]
    assert verified(two_runs) == ["1.25 %", "1.25 %"]
    session = two_runs.document.session
    two_runs.loaded.runs.note_check(CheckedLens(session, session.heights), found(0.03))
    assert not two_runs.document.dirty  # a check is no edit
    assert verified(two_runs) == ["1.25 %", "3.00 %"]
    two_runs.document.save(path)
    two_runs.document.open(path)
    assert verified(two_runs) == ["1.25 %", "3.00 %"]


def test_the_lens_of_a_run_is_checked_at_its_end(window, run, checks, qtbot):
    run()
    result = window.document.session.result
    heights, rays, threads = checks.asked[-1]
    assert heights is result.state.heights and rays == 4_000_000 and threads is None
    assert window.status._verified.text() == "Checked error 1.25 % at 6"
    assert verified(window)[0] == "1.25 %"
    (point,) = window.loaded.views.loss._verified
    assert (point.iteration, point.loss) == (6, 0.1)
    move_screen(window.document, 7)
    assert window.status._verified.text() == "" and window.loaded.views.loss._verified == ()
    assert verified(window)[0] == "1.25 %"


def test_a_lens_changed_by_hand_is_not_the_one_that_was_checked(window, run, checks):
    run()
    document, status = window.document, window.status
    result = document.session.result
    moved = result.with_state(heights=FaceArrays({"exit": result.state.heights["exit"] + 0.001}))
    document.set_result(moved, "move control points")
    assert status._verified.text() == ""
    document.undo_stack.undo()
    assert status._verified.text() == "Checked error 1.25 % at 6"


def test_a_run_is_checked_while_it_goes_on(window, as_run, checks, monkeypatch, qtbot):
    monkeypatch.setattr("ui.run.run_check._REST", 0.0)
    monkeypatch.setattr("ui.run.run_check._RESTS", 0.0)
    monkeypatch.setattr("ui.run.run_check.QThread.idealThreadCount", lambda: 2)
    window.loaded.control.runner._generate = as_run(100_000, pause=0.01)
    window.commands["start"].trigger()
    qtbot.waitUntil(lambda: len(window.loaded.views.loss._verified) >= 2, timeout=60_000)
    assert {(rays, threads) for _, rays, threads in checks.asked} == {(1_000_000, 1)}
    assert window.status._verified.text().startswith("Checked error 1.25 % at ")
    window.commands["stop"].trigger()
    qtbot.waitUntil(lambda: not window.loaded.control.busy, timeout=60_000)
    qtbot.waitUntil(lambda: checks.asked[-1][1] == 4_000_000)
    qtbot.waitUntil(lambda: not window.loaded.runs.check._background.busy)
    seen = [point.iteration for point in window.loaded.views.loss._verified]
    assert seen == sorted(seen) and seen[0] > 0


def test_a_stage_is_checked_at_its_end(window, snapshots, as_seen_run, checks, monkeypatch, qtbot):
    monkeypatch.setattr("ui.run.run_check.QThread.idealThreadCount", lambda: 2)

    def staged(iteration, iterations):
        give_up = time.monotonic() + 30
        while iteration == 7 and not checks.asked and time.monotonic() < give_up:
            time.sleep(0.002)  # or the run ends before the thread of the check has begun
        return replace(snapshots(iteration, iterations), stage=iteration // 4, stages=2)

    scene = window.document.session.scene
    run = scene.run.model_copy(update={"stages": (Stage(iterations=4),)})
    window.document.edit(scene.model_copy(update={"run": run}), "stages", "")
    runner = window.loaded.control.runner
    runner._generate = as_seen_run(runner, 7, staged)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    qtbot.waitUntil(lambda: not window.loaded.runs.check._background.busy)
    assert [(rays, threads) for _, rays, threads in checks.asked] == [
        (1_000_000, 1),
        (4_000_000, None),
    ]
    assert checks.asked[0][0]["exit"][0, 0] == 0.5 - 0.003  # the last lens of the first stage


def test_no_check_runs_beside_a_run_on_one_core(window, as_run, checks, monkeypatch, qtbot):
    monkeypatch.setattr("ui.run.run_check._REST", 0.0)
    monkeypatch.setattr("ui.run.run_check._RESTS", 0.0)
    monkeypatch.setattr("ui.run.run_check.QThread.idealThreadCount", lambda: 1)
    window.loaded.control.runner._generate = as_run(20, pause=0.01)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    qtbot.waitUntil(lambda: not window.loaded.runs.check._background.busy)
    assert [rays for _, rays, _ in checks.asked] == [4_000_000]


def mark_a_region(window):
    scene = window.document.session.scene
    regions = (RectangleRegion(name="Region 1"),)
    window.document.edit(scene.model_copy(update={"regions": regions}), "new region", "")


def test_a_check_is_that_of_the_run_whatever_regions_are_marked(window, run):
    run()
    mark_a_region(window)
    assert verified(window) == ["1.25 %"] and table(window).item(0, 0).font().bold()
    session = window.document.session
    window.loaded.runs.note_check(CheckedLens(session, session.heights), found(0.03))
    assert verified(window) == ["3.00 %"]


def test_regions_that_are_marked_while_a_lens_is_checked_leave_its_check(
    window, monkeypatch, qtbot
):
    go_on, begun = Event(), Event()

    def validating(scene, target, heights, rays, threads, accuracy):
        begun.set()
        while not go_on.wait(0.01):
            yield 0.5
        return found(0.02)

    monkeypatch.setattr("workbench.analysis.validation.validating", validating)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    qtbot.waitUntil(begun.is_set)
    mark_a_region(window)
    go_on.set()
    qtbot.waitUntil(lambda: verified(window) == ["2.00 %"])
    assert window.status._verified.text() == "Checked error 2.00 % at 6"


def test_a_check_of_another_task_is_not_that_of_the_run(window, run, checks):
    run()
    session = window.document.session
    checks.error = 0.5
    moved = session.with_scene(
        session.scene.with_receiver(session.scene.receiver.model_copy(update={"z": 8.0})),
        session.target,
    )
    assert moved.start is session.result.state.heights
    window.loaded.runs.note_check(CheckedLens(moved, moved.start), found(0.5))
    assert verified(window)[0] == "1.25 %"
    window.loaded.runs.note_check(CheckedLens(replace(session, runs=()), moved.start), found(0.5))
    assert verified(window)[0] == "50.00 %"
