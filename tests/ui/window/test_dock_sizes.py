"""How docks share the window: what is shown has room, and titles of tabs can be read."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import QTabBar

from ui.widgets import theme
from ui.window.workspace import _FORMS_SHARE, _IMAGES

SIZE = QSize(1280, 800)


@pytest.fixture
def large(window, qtbot):
    window.resize(SIZE)
    qtbot.waitUntil(lambda: window.size() == SIZE)
    reset(window, qtbot)
    return window


def reset(window, qtbot):
    window.commands["reset_layout"].trigger()
    share = pytest.approx((1 - _FORMS_SHARE) / 3 * window.width(), abs=0.03 * window.width())
    qtbot.waitUntil(lambda: [width(window, name) for name in _IMAGES] == 3 * [share])


def width(window, name="error"):
    return window.workspace.docks[name].width()


@pytest.mark.parametrize("size", [(1280, 800), (1600, 1000), (2560, 1440)])
def test_irradiance_target_and_difference_have_a_third_of_the_window(
    window, qtbot, monkeypatch, size
):
    monkeypatch.setattr(QScreen, "availableSize", lambda self: QSize(*size))
    window.build()
    window.resize(QSize(*size))
    qtbot.waitUntil(lambda: window.size() == QSize(*size))
    reset(window, qtbot)
    docks = [window.workspace.docks[name] for name in _IMAGES]
    assert len({dock.y() for dock in docks}) == 1  # side by side
    assert sum(dock.width() * dock.height() for dock in docks) >= size[0] * size[1] / 3


def test_images_share_the_room_of_one_that_went(large, qtbot):
    whole = sum(width(large, name) for name in _IMAGES)
    large.workspace.docks["target"].hide()
    qtbot.wait(50)
    large.commands["go_target"].trigger()
    qtbot.wait(50)
    parts = [width(large, name) for name in _IMAGES]
    assert sum(parts) == pytest.approx(whole, abs=12)  # separators between them
    assert min(parts) > max(parts) / 2


def test_reset_gives_the_images_their_share_whatever_was_open(large, qtbot):
    usual = width(large)
    for _ in range(2):
        large.workspace.docks["target"].hide()
        qtbot.wait(50)
        reset(large, qtbot)
        assert width(large) == pytest.approx(usual, abs=2)


def test_titles_of_tabs_are_whole_however_many_there_are(application, large, qtbot):
    theme.apply(application)
    for name in ("derivative", "surface", "manufacture", "tolerances", "focus", "photo", "check"):
        large.commands[f"go_{name}"].trigger()
        qtbot.wait(20)
    bar = max(large.findChildren(QTabBar), key=lambda bar: bar.count())
    assert bar.count() == 8
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
