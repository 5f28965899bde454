"""Edits followed in the window, by the engine itself."""

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QLabel

from tests.ui.hands import editor, fill
from ui.dialogs.preferences import CHECK
from ui.window.loaded_parts import FOLLOW

pytestmark = pytest.mark.usefixtures("kernels", "display")


@pytest.fixture
def open_following(settings, open_window):
    """Opens windows whose edits are followed."""

    def make(session):
        settings.setValue(FOLLOW, True)
        window = open_window(session)
        window.build()
        return window

    return make


@pytest.fixture
def following(open_following, designed, qtbot):
    """A window of a small lens."""
    window = open_following(designed)
    qtbot.waitUntil(lambda: window.loaded.views.scene.frame is not None)
    return window


def settled(window, qtbot):
    return qtbot.waitSignal(window.loaded.follow.settled)


def test_a_value_that_is_typed_is_followed_and_undone_as_one_step(following, designed, qtbot):
    window, document = following, following.document
    texts = []
    window.loaded.follow.message.connect(texts.append)
    with settled(window, qtbot):
        fill(qtbot, editor(window.forms, "images[0].receiver.position[2]"), "6")
    result = document.session.result
    assert document.session.scene.receiver.z == 6
    assert result.iterations > 0
    assert set(texts) == {"Updating the lens", ""}
    assert texts[-1] == ""
    assert window.status._state.text() == result.ended[0].upper() + result.ended[1:]
    assert [run.name for run in document.session.runs] == ["Followed 1: auto, 12 × 10"]
    window.commands["undo"].trigger()
    assert document.session is designed
    window.commands["redo"].trigger()
    assert document.session.result is result


def test_a_run_keeps_edits_waiting_and_they_are_followed_after_it(following, qtbot, as_run):
    window, frames = following, []
    check = window.loaded.runs.check
    window.loaded.control.ended.disconnect(check._finish)  # a check of its lens takes long
    window.loaded.control.runner._generate = as_run(10_000, 0.001)
    window.loaded.control.runner.frame_ready.connect(frames.append)
    window.commands["start"].trigger()
    qtbot.waitUntil(lambda: any(frame.snapshot.iteration for frame in frames))
    fill(qtbot, editor(window.forms, "images[0].receiver.position[2]"), "6")
    assert window.loaded.follow.text == ""
    with settled(window, qtbot):
        window.commands["stop"].trigger()
    names = [run.name for run in window.document.session.runs]
    assert names == ["Run 1: auto, 12 × 10", "Followed 2: auto, 12 × 10"]


def test_the_choice_to_follow_is_kept(following, settings):
    following.commands["follow"].trigger()
    assert not following.loaded.follow.follows(following.document.session)
    settings.sync()
    kept = QSettings(settings.fileName(), QSettings.Format.IniFormat)
    assert kept.value(FOLLOW, True, bool) is False


def test_a_source_that_is_dragged_is_followed_in_one_step(open_following, make_session, qtbot):
    point = {"kind": "point", "position": [0, 0, -4]}
    window = open_following(make_session({"source": point}))
    qtbot.waitUntil(lambda: window.document.session.result is not None)
    tools, before = window.loaded.tools, window.document.session
    follow, source = window.loaded.follow, before.scene.source
    qtbot.waitUntil(lambda: follow.text == "")
    before = window.document.session
    assert tools._movable() is not None  # a drag begins
    for x in (0.02, 0.04, 0.06):
        moved = source.model_copy(update={"position": (x, 0.0, -4.0)})
        tools._move(before.scene.model_copy(update={"source": moved}), "Move source")
        qtbot.wait(50)
    qtbot.waitUntil(lambda: window.document.session.result is not None)
    assert window.document.session.scene.source.position == (0.06, 0.0, -4.0)
    assert window.document.undo_stack.count() == 1
    window.commands["undo"].trigger()
    assert window.document.session is before


def states(window, text):
    """Whether the check's pane shows a text in place of figures."""
    labels = window.loaded.figures.findChildren(QLabel)
    return any(label.text() == text and not label.isHidden() for label in labels)


def test_a_followed_lens_is_checked_until_the_next_edit(following, qtbot):
    window, document = following, following.document
    with settled(window, qtbot):
        fill(qtbot, editor(window.forms, "images[0].receiver.position[2]"), "6")
    first = document.session.result
    assert window.loaded.runs.check.background.busy
    assert states(window, "Checking…")
    with settled(window, qtbot):
        fill(qtbot, editor(window.forms, "images[0].receiver.position[2]"), "7")
    second = document.session.result
    with qtbot.waitSignal(window.loaded.check.checked, timeout=60_000) as shown:
        pass
    assert not states(window, "Checking…")
    lens, found, _ = shown.args
    assert lens.heights == second.state.heights
    assert (
        document.verified.of_lens(second).relative_l2_corrected
        == found.verified.relative_l2_corrected
    )
    assert document.verified.of_lens(first) is None


def test_a_check_that_is_asked_for_takes_the_place_of_that_of_a_followed_lens(following, qtbot):
    with settled(following, qtbot):
        fill(qtbot, editor(following.forms, "images[0].receiver.position[2]"), "6")
    own, asked = following.loaded.runs.check.background, following.loaded.check
    assert own.busy
    with qtbot.waitSignal(asked.checked, timeout=60_000):
        following.commands["check"].trigger()
        assert asked.background.busy and not own.busy
        assert states(following, "Checking…")


def test_a_followed_lens_is_not_checked_where_a_person_wants_no_checks(following, settings, qtbot):
    settings.setValue(CHECK.key, "none")
    with settled(following, qtbot):
        fill(qtbot, editor(following.forms, "images[0].receiver.position[2]"), "6")
    assert not following.loaded.runs.check.background.busy
