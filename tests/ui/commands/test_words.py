"""Commands say what the optic of the design is called."""

import pytest
from PySide6.QtWidgets import QMainWindow

from ui.commands.actions import Commands
from ui.commands.table import COMMANDS


@pytest.fixture
def commands(qtbot):
    window = QMainWindow()
    qtbot.addWidget(window)
    commands = Commands(window)
    commands._owner = window  # lives as long
    return commands


def words(commands):
    return {
        name: f"{commands[name].text()} {commands[name].toolTip()} {commands[name].statusTip()}"
        for name in COMMANDS
    }


def test_no_place_for_a_name_is_left_open(commands):
    assert not any("{" in text for text in words(commands).values())
    assert commands["check"].text() == "&Check lens"


def test_texts_and_tips_follow_the_optic(commands):
    commands["undo"].setText("&Undo what was done")
    commands.name_optic("mirror")
    assert commands["check"].text() == "&Check mirror"
    assert commands["lens_view"].text() == "Look at &mirror"
    assert commands["lens_view"].toolTip() == "See the mirror as large as it can be (Ctrl+1)"
    assert commands["start"].statusTip().startswith("Design the mirror from nothing")
    assert commands["undo"].text() == "&Undo what was done"
    for name, text in words(commands).items():
        if "{optic}" in COMMANDS[name].tip:
            assert "lens" not in text
    commands.explain({"start": "Not now"})
    assert "mirror" in commands["start"].toolTip()
    commands.name_optic("lens")
    assert commands["check"].text() == "&Check lens"
