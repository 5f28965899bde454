"""A window on a small screen, as one of 1600 × 1000 pixels at 200 %."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QScreen

SMALL = QSize(800, 500)


@pytest.fixture
def small_screen(monkeypatch):
    monkeypatch.setattr(QScreen, "availableSize", lambda _: SMALL)


def test_a_window_fits_on_a_small_screen_and_its_forms_can_be_scrolled(
    small_screen, open_window, qtbot, display, kernels
):
    window = open_window()
    window.build()
    window.setWindowState(window.windowState().WindowNoState)
    window.resize(SMALL)
    qtbot.waitUntil(lambda: window.loaded.views.scene.isVisible())
    assert window.minimumSizeHint().width() <= SMALL.width()
    assert window.minimumSizeHint().height() <= SMALL.height()
    assert window.width() == SMALL.width()
    bar = window.forms.horizontalScrollBar()
    hidden = window.forms.widget().width() - window.forms.viewport().width()
    assert bar.maximum() == hidden > 0
