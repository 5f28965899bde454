"""How docks share the window: what is shown has room, and titles of tabs can be read."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import QTabBar

from ui.widgets import theme
from ui.window.workspace import _IMAGES_SHARE

SIZE = QSize(1280, 800)


@pytest.fixture
def large(window, qtbot):
    window.resize(SIZE)
    qtbot.waitUntil(lambda: window.size() == SIZE)
    reset(window, qtbot)
    return window


def reset(window, qtbot):
    window.commands["reset_layout"].trigger()
    share = pytest.approx(_IMAGES_SHARE * SIZE.width(), abs=2)
    qtbot.waitUntil(lambda: width(window) == share)


def width(window, name="error"):
    return window.workspace.docks[name].width()


def test_target_and_irradiance_share_the_room_of_one_dock(large, qtbot):
    whole = width(large)
    large.commands["go_target"].trigger()
    qtbot.wait(50)
    parts = [width(large, name) for name in ("irradiance", "target")]
    assert parts[0] == pytest.approx(parts[1], abs=2)
    assert sum(parts) == pytest.approx(whole, abs=12)  # a separator between them


def test_reset_gives_the_images_their_share_whatever_was_open(large, qtbot):
    usual = width(large)
    assert usual == pytest.approx(_IMAGES_SHARE * SIZE.width(), abs=2)
    for _ in range(2):
        large.commands["go_target"].trigger()
        qtbot.wait(50)
        reset(large, qtbot)
        assert width(large) == usual


def test_titles_of_tabs_are_whole_however_many_there_are(application, large, qtbot):
    theme.apply(application)
    for name in ("derivative", "surface", "manufacture", "tolerances", "focus", "check"):
        large.commands[f"go_{name}"].trigger()
        qtbot.wait(20)
    bar = max(large.findChildren(QTabBar), key=lambda bar: bar.count())
    assert bar.count() == 7
    for number in range(bar.count()):
        text = bar.fontMetrics().horizontalAdvance(bar.tabText(number))
        assert bar.tabRect(number).width() > text
    current = bar.tabRect(bar.currentIndex())
    assert current.left() >= 0 and current.right() < bar.width()


@pytest.mark.parametrize(
    ("screen", "whole"),
    [((1280, 800), True), ((1366, 768), True), ((1024, 600), True), ((1600, 1000), False)],
)
def test_the_first_window_fits_into_the_screen_with_its_frame(
    open_window, qtbot, monkeypatch, screen, whole
):
    room = QSize(*screen)
    monkeypatch.setattr(QScreen, "availableSize", lambda self: room)
    window = open_window()
    assert window.isMaximized() is whole
    usual = window.normalGeometry().size()
    assert usual.boundedTo(room) == usual
    assert whole or (usual + QSize(16, 64)).boundedTo(room) == usual + QSize(16, 64)


def test_the_window_with_all_its_first_docks_can_be_small(display, window):
    window.build()
    least = window.minimumSizeHint()
    assert least.boundedTo(QSize(1024, 600)) == least
