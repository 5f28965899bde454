"""Names beside the icons of the toolbar."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMainWindow, QToolButton

from ui.commands.actions import NAMED_FIRST, Commands

NAMED = Qt.ToolButtonStyle.ToolButtonTextBesideIcon


@pytest.fixture
def window(qtbot):
    window = QMainWindow()
    qtbot.addWidget(window)
    return window


@pytest.fixture
def commands(window, display):
    return Commands(window)


def named(commands):
    return {
        name
        for group in NAMED_FIRST
        for name in group
        if commands.toolbar.widgetForAction(commands[name]).toolButtonStyle() == NAMED
    }


def test_a_wider_window_names_one_group_after_the_other(window, commands, qtbot):
    window.show()
    seen = []
    for width in (500, 1000, 1400, 3000):
        window.resize(width, 300)
        qtbot.waitUntil(lambda width=width: commands.toolbar.width() > width - 20)
        whole = [set(group) for group in NAMED_FIRST if set(group) <= named(commands)]
        assert set().union(*whole) == named(commands)  # a group has all names or none
        seen.append(len(whole))
        if len(whole) > 1:
            assert commands.toolbar.sizeHint().width() <= commands.toolbar.width()
    assert seen[0] == 1 and seen[-1] == len(NAMED_FIRST) and seen == sorted(seen)


def test_undo_keeps_its_short_name_and_a_longer_text_takes_its_room(window, commands, qtbot):
    window.show()
    window.resize(3000, 300)
    qtbot.waitUntil(lambda: "undo" in named(commands))
    commands.reword({"undo": "&Undo a very long name of a step"})
    button = commands.toolbar.widgetForAction(commands["undo"])
    assert isinstance(button, QToolButton) and button.text() == "Undo"
    window.resize(commands.toolbar.sizeHint().width() + 20, 300)
    qtbot.waitUntil(lambda: "undo" in named(commands))
    commands.reword({"start": "&Start with a far longer name than before"})
    assert "undo" not in named(commands) and "start" in named(commands)
