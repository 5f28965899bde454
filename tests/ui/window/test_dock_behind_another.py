"""A dock that stands behind another one, as a tab, and its entry in the menu View."""

import pytest


@pytest.fixture
def docks(window):
    """Loss, with runs behind it."""
    docks = window.workspace.docks
    assert docks["runs"].isVisible() and docks["runs"].visibleRegion().isEmpty()
    return docks


def is_seen(dock):
    return not dock.visibleRegion().isEmpty()


def test_the_menu_brings_it_to_the_front_and_then_closes_it(docks, qtbot):
    entry = docks["runs"].toggleViewAction()
    entry.trigger()
    qtbot.waitUntil(lambda: is_seen(docks["runs"]))
    assert entry.isChecked() and not is_seen(docks["loss"])
    entry.trigger()
    qtbot.waitUntil(lambda: not docks["runs"].isVisible())
    assert not entry.isChecked()
    entry.trigger()
    qtbot.waitUntil(lambda: is_seen(docks["runs"]))
