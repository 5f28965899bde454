"""The tour and the table of shortcuts, by keyboard in the real window."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence

from ui.commands.shortcuts import Shortcuts
from ui.commands.table import COMMANDS
from ui.help.tour import STOPS, Bubble


@pytest.fixture
def bubble(window, qtbot):
    window.commands["tour"].trigger()
    bubble = window.findChild(Bubble)
    qtbot.waitUntil(bubble.isVisible)
    return bubble


def test_the_tour_is_stepped_through_by_keyboard(window, bubble, qtbot):
    assert bubble._title.text() == STOPS[0].title
    assert not bubble.back.isEnabled() and bubble.on.hasFocus()
    titles = []
    for _ in STOPS:
        titles.append(bubble._title.text())
        qtbot.waitUntil(bubble.on.hasFocus)
        if len(titles) < len(STOPS):
            qtbot.keyClick(bubble.on, Qt.Key.Key_Return)
    assert titles == [stop.title for stop in STOPS]
    assert bubble.on.text() == "&Done" and not bubble.end.isVisible()
    qtbot.keyClick(bubble.on, Qt.Key.Key_Backtab)
    assert bubble.back.hasFocus()
    qtbot.keyClick(bubble.back, Qt.Key.Key_Space)
    assert bubble._title.text() == STOPS[-2].title
    bubble.on.setFocus()
    qtbot.keyClick(bubble.on, Qt.Key.Key_Space)
    assert bubble._title.text() == STOPS[-1].title
    gone = []
    bubble.destroyed.connect(lambda: gone.append(True))
    qtbot.keyClick(bubble.on, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: bool(gone))
    assert window.findChild(Bubble) is None


def test_the_tour_is_offered_once(window, settings, qtbot):
    window.help.offer_tour(settings)
    assert "tour" in window.messages.text.lower() and window.findChild(Bubble) is None
    qtbot.mouseClick(window.messages.buttons[0], Qt.MouseButton.LeftButton)
    assert window.findChild(Bubble) is not None
    window.messages.clear()
    window.help.offer_tour(settings)
    assert not window.messages.isVisible()


def test_all_shortcuts_are_listed_and_found_by_name_or_key(window, qtbot):
    qtbot.keyClick(window, Qt.Key.Key_F1, Qt.KeyboardModifier.ControlModifier)
    dialog = window.findChild(Shortcuts)
    table = dialog._table
    rows = [table.topLevelItem(k) for k in range(table.topLevelItemCount())]
    keys = {row.text(1) for row in rows}
    wanted = {QKeySequence(c.shortcut).toString() for c in COMMANDS.values() if c.shortcut}
    assert wanted <= keys
    for typed, found in (("contin", "Run → Continue"), ("shift+f5", "Run → Continue")):
        dialog._field.clear()
        qtbot.keyClicks(dialog._field, typed)
        assert [row.text(0) for row in rows if not row.isHidden()] == [found]
    dialog.reject()
