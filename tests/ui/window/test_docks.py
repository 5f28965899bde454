"""Docks of the main window."""

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QScreen

from tests.ui.hands import move_screen

STEPS = 30


def test_many_steps_are_listed_and_gone_through_by_keyboard(window, qtbot):
    window.document.blockSignals(True)  # forms do not show each step
    for number in range(STEPS):
        move_screen(window.document, 6 + number, f"screen at {6 + number}")
    window.document.blockSignals(False)
    window.commands["go_history"].trigger()
    history, document = window.panes.history, window.document
    qtbot.waitUntil(history.hasFocus)
    assert history.model().rowCount() == STEPS + 1  # and the beginning
    assert history.currentIndex().row() == STEPS
    qtbot.waitUntil(lambda: history.visualRect(history.currentIndex()).isValid())
    assert history.viewport().rect().intersects(history.visualRect(history.currentIndex()))
    qtbot.keyClick(history, Qt.Key.Key_Up)
    assert document.session.scene.receiver.z == 6 + STEPS - 2
    qtbot.keyClick(history, Qt.Key.Key_Home)
    assert document.session.scene.receiver.z == 5 and history.currentIndex().row() == 0
    qtbot.keyClick(history, Qt.Key.Key_End)
    assert document.session.scene.receiver.z == 6 + STEPS - 1


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
