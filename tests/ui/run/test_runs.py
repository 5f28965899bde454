"""Runs kept side by side: named, compared on the loss plot, gone back to, deleted; and checked."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.ui.hands import move_screen
from ui.run.checks import CheckedLens
from workbench.design.loss import relative_error

pytestmark = pytest.mark.usefixtures("kernels")


PIXELS = (32, 32)


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
        irradiance=np.ones(PIXELS),
    )


@pytest.fixture
def checks(monkeypatch):
    """Checks that report at once what they are given; notes heights, rays and threads."""
    seen = SimpleNamespace(asked=[], error=0.0125)

    def validating(scene, target, heights, rays, threads, accuracy):
        seen.asked.append((heights, rays, threads))
        yield 1.0
        return found(seen.error)

    # The one that imports it first: else it would import this one, and keep it.
    for module in ("making.as_made", "validation"):
        monkeypatch.setattr(f"workbench.analysis.{module}.validating", validating)
    # These checks have too few figures for the table.
    monkeypatch.setattr("ui.run.check_figures.CheckFigures.show_check", lambda *_: None)
    return seen


@pytest.fixture
def window(display, window, checks, as_seen_run):
    window.build()
    window.loaded.control.runner._generate = as_seen_run(window.loaded.control.runner, 6)
    window.commands["workspace_design"].trigger()
    window.panes.docks["runs"].show()
    window.panes.docks["runs"].raise_()
    return window


@pytest.fixture
def run(window, qtbot):
    def do(command="start"):
        with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
            window.commands[command].trigger()
        qtbot.waitUntil(lambda: not window.loaded.runs.check.background.busy)

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


def test_each_run_is_kept_in_one_step_with_its_result(window, run):
    assert not table(window).isVisible()
    run()
    assert names(window) == ["Run 1: auto, 12 × 10"]
    assert window.document.undo_stack.count() == 1
    run("continue")
    assert names(window) == ["Run 1: auto, 12 × 10", "Run 2: auto, 12 × 10"]
    session = window.document.session
    error = f"{100 * relative_error(session.result.state, session.target):.1f} %"
    figures = ["Top hat", error, "1.25 %", "92.0 %", "0:01", "12", "12 × 10", "Automatic"]
    assert texts(window, 1)[1:] == [*figures, "0.1429", "all iterations are done"]
    assert not table(window).item(1, 0).icon().isNull()
    window.commands["undo"].trigger()
    window.commands["undo"].trigger()
    assert names(window) == [] and window.document.session.result is None


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
    assert "Select two runs" in two_runs.messages.text and runs.comparison is None
    lines.selectAll()
    qtbot.mouseClick(compare, Qt.MouseButton.LeftButton)
    shown = runs.comparison
    assert shown.isVisible() and shown.pair == two_runs.document.session.runs
    cells = {shown.table.item(row, 0).text(): row for row in range(shown.table.rowCount())}
    differ = cells["Fields of the scenes that differ"]
    assert list(cells)[differ + 1 :] == ["Images 1 · Receiver · Position"]
    places = [shown.table.item(differ + 1, column).text() for column in (1, 2)]
    assert places == ["0, 0, 5 cm", "0, 0, 7 cm"]
    session = two_runs.document.session
    runs.note_check(CheckedLens(session, session.heights), found(0.03))
    errors = [shown.table.item(cells["Verified"], column).text() for column in (1, 2)]
    assert errors == ["1.25 %", "3.00 %"]


def test_the_lens_of_a_run_is_checked_at_its_end(window, run, checks, qtbot):
    run()
    result = window.document.session.result
    heights, rays, threads = checks.asked[-1]
    assert heights is result.state.heights and rays == 4_000_000 and threads is None
    qtbot.waitUntil(lambda: verified(window)[0] == "1.25 %")
    card = window.loaded.cards.cards["error"]
    qtbot.waitUntil(lambda: card.text == "1.25 % verified error.")
    (point,) = window.loaded.views.loss.curve.verified
    assert (point.iteration, point.loss) == (6, 0.1)
    move_screen(window.document, 7)
    assert window.loaded.views.loss.curve.verified == ()
    assert verified(window)[0] == "1.25 %"


def test_no_run_is_checked_where_a_person_prefers_none(window, run, checks, settings):
    settings.setValue("run/check", "none")
    run()
    assert checks.asked == []
    assert verified(window)[0] == "–"


def test_no_check_runs_beside_a_run_on_one_core(window, as_run, checks, monkeypatch, qtbot):
    monkeypatch.setattr("ui.run.checks._REST", 0.0)
    monkeypatch.setattr("ui.run.checks._RESTS", 0.0)
    monkeypatch.setattr("ui.run.checks.cores", lambda: 1)
    window.loaded.control.runner._generate = as_run(20, pause=0.01)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    qtbot.waitUntil(lambda: not window.loaded.runs.check.background.busy)
    assert [rays for _, rays, _ in checks.asked] == [4_000_000]  # after the run
