"""Entries that were refused, taken back with Ctrl+Z or Escape wherever the keyboard is."""

import pytest
from PySide6.QtCore import Qt

from tests.ui.hands import choose, editor, enter, fill, move_screen, row, rows
from workbench.errors import Refused

CTRL = Qt.KeyboardModifier.ControlModifier
TEXT = {"version": 2, "target": {"builtin": "text", "text": "A"}}
POLYGON = {"version": 2, "regions": [{"shape": "polygon", "corners": [[0, 0], [0.5, 0], [0, 0.5]]}]}


@pytest.fixture
def begin(open_window, make_session):
    """Opens windows of a design that has one step to undo."""

    def make(changes=None):
        window = open_window(make_session(changes))
        move_screen(window.document, 7)
        return window

    return make


def number(window, qtbot):
    return enter(qtbot, window.forms, "images[0].receiver.position[2]", "far")


def whole_number_of_a_pair(window, qtbot):
    return enter(qtbot, window.forms, "elements[0].faces[1].degree[1]", "99")


def pair_that_the_program_may_choose(window, qtbot):
    return enter(qtbot, window.forms, "elements[0].faces[1].control_points[0]", "2")


def number_that_may_be_left_out(window, qtbot):
    return enter(qtbot, window.forms, "run.min_radius", "-1")


def text(window, qtbot):
    return fill(qtbot, row(window.forms, "images[0].target.text").editor, "")


def corners(window, qtbot):
    return fill(qtbot, row(window.forms, "regions[0].corners").editor, "0, 0; 1, 1")


def choice(window, qtbot):
    def refuse(*_):
        raise Refused("run.method", "cannot be had with this task")

    window.document.edit = refuse
    choose(window.forms, "run.method", "paper")
    del window.document.edit
    chooser = row(window.forms, "run.method").chooser
    chooser.setFocus()
    return chooser


ENTRIES = [
    (number, None),
    (whole_number_of_a_pair, None),
    (pair_that_the_program_may_choose, None),
    (number_that_may_be_left_out, None),
    (text, TEXT),
    (corners, POLYGON),
    (choice, None),
]


def shown(forms):
    """What all fields show."""
    texts = [e.text() for each in rows(forms) for e in getattr(each, "editors", {}).values()]
    lines = [each.editor.text() for each in rows(forms) if hasattr(each, "editor")]
    chosen = [each.chooser.currentIndex() for each in rows(forms) if hasattr(each, "chooser")]
    return [*texts, *lines, *chosen]


@pytest.mark.parametrize(("entry", "changes"), ENTRIES)
def test_undo_takes_a_refused_entry_back_and_only_then_a_step(begin, qtbot, entry, changes):
    window = begin(changes)
    session, before = window.document.session, shown(window.forms)
    field = entry(window, qtbot)
    assert window.forms.refused and shown(window.forms) != before
    assert window.commands["undo"].text().startswith("&Undo refused change of")
    qtbot.keyClick(field, Qt.Key.Key_Z, CTRL)
    assert window.document.session is session
    assert not window.forms.refused and shown(window.forms) == before
    qtbot.keyClick(field, Qt.Key.Key_Z, CTRL)
    assert window.document.session.scene.receiver.z == 5


def test_escape_anywhere_takes_all_refused_entries_back(begin, qtbot):
    window = begin()
    before = shown(window.forms)
    for elsewhere in (editor(window.forms, "run.seed"), window.panes.history):
        enter(qtbot, window.forms, "images[0].receiver.position[2]", "far")
        enter(qtbot, window.forms, "images[0].receiver.half_width[0]", "wide")
        elsewhere.setFocus()
        qtbot.keyClick(elsewhere, Qt.Key.Key_Escape)
        assert shown(window.forms) == before and not window.forms.refused
