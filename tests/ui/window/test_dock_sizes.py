"""How docks share the window: what is shown has room, and titles of tabs can be read."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QScreen

from ui.window.workspace import _FORMS_SHARE, _IMAGES


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
