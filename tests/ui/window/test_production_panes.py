"""Manufacture and tolerances in the real window: hidden at first, shown when asked for."""

import pytest

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def window(display, open_window, designed, qtbot):
    window = open_window(designed)
    window.build()
    qtbot.waitUntil(lambda: window.loaded.production.tolerances._frame is not None, timeout=60_000)
    return window


def test_the_dock_shows_the_figures_for_manufacture(window, qtbot):
    pane = window.loaded.production.manufacture
    qtbot.wait(400)
    assert pane._found is None and not window.workspace.docks["manufacture"].isVisible()
    window.commands["go_manufacture"].trigger()
    qtbot.waitUntil(lambda: pane._found is not None and not pane.map.empty, timeout=60_000)
    assert pane._figures.found["thinnest"].text() == "0.497 cm"
    assert pane._figures.found["tightest_concave"].text() == "none"


def test_the_window_closes_in_the_midst_of_a_sample(window, qtbot):
    pane = window.loaded.production.tolerances
    window.commands["go_tolerances"].trigger()
    pane.toggle()
    qtbot.waitUntil(lambda: pane._sample.nominal is not None, timeout=60_000)
    window.discard_and_close()
    assert not pane._background.busy
