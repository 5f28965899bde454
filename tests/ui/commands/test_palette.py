"""The command palette in the real window, by keyboard and mouse."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QTreeWidget

from ui.commands.command_search import CommandPalette

BOTH = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def palette(window, qtbot):
    qtbot.keyClick(window, Qt.Key.Key_P, BOTH)
    found = window.findChild(CommandPalette)
    with qtbot.waitExposed(found):
        pass
    return found


def listed(palette):
    return [(item.text(0), item.text(1)) for item in palette._items()]


def test_the_palette_has_every_command_of_the_menus_once(window, palette):
    actions = [action for _, action in window.commands.entries()]
    assert len(actions) == len(set(actions)) == len(palette._items())
    assert {window.commands[name] for name in ("save", "undo", "start", "about")} <= {*actions}
    assert ("Run → Start", "F5") in listed(palette)
    assert "View → Light account" in dict(listed(palette))


def test_typing_finds_names_with_all_words(palette, qtbot):
    qtbot.keyClicks(palette._field, "dit sav")
    names = [name.lower() for name, _ in listed(palette)]
    assert names == ["edit → save plot"]


@pytest.mark.parametrize(
    ("own", "typed"),
    [
        ("Éclairement", ("eclairement", "Éclairement", "ECLAIR")),
        ("Fläche", ("flache", "fläche", "FLÄCH")),
        ("Größe", ("grosse", "größe")),
    ],
)
def test_names_are_found_with_and_without_their_accents(palette, own, typed):
    other, found = QAction("x", palette), QAction(own, palette)
    palette._entries = [("View → Light account", other), (f"View → {own}", found)]
    for text in typed:
        palette._field.setText(text)
        assert listed(palette) == [(f"View → {own}", "")]
    palette._entries.insert(0, (f"View → By {own}", other))
    palette._find(typed[0])
    assert listed(palette)[0] == (f"View → {own}", "")  # what begins as typed comes first


def test_enter_runs_the_command(window, palette, qtbot):
    qtbot.keyClicks(palette._field, "start page")
    qtbot.keyClick(palette._field, Qt.Key.Key_Return)
    assert window.pages.at_start
    qtbot.waitUntil(lambda: window.findChild(CommandPalette) is None)


def test_arrows_choose_a_command_and_a_click_runs_it(window, palette, qtbot):
    qtbot.keyClicks(palette._field, "view")
    tree = palette.findChild(QTreeWidget)
    first = next(item for item in palette._items() if not item.isDisabled())
    assert tree.currentItem() is first
    qtbot.keyClick(palette._field, Qt.Key.Key_Down)
    assert tree.currentItem() is tree.itemBelow(first)
    item = next(each for each in palette._items() if each.text(0) == "View → Go to → Derivative")
    tree.scrollToItem(item)
    place = tree.visualItemRect(item).center()
    qtbot.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert window.panes.images.name == "derivative"
